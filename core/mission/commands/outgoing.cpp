#include "core/mission/commands/outgoing.h"

#include <algorithm>
#include <utility>

#include "core/protocol/command_writer.h"
#include "core/protocol/zero_drives.h"

namespace usar::mission {

void Outgoing::beginConnection() {
    gate_.reset();
    moving_.reset();
    dialect_ = {};
    drives_replaced_ = 0;
}

void Outgoing::send(const agent::CausedCommand& command) {
    if (protocol::isDrive(command.command))
        drives_replaced_ += gate_.offer(command);
    else
        write(command);
}

void Outgoing::release(Seconds now, bool at_once) {
    for (const agent::CausedCommand& drive : gate_.release(now, at_once))
        write(drive);
}

void Outgoing::write(const agent::CausedCommand& command) {
    std::string text = protocol::write(command.command, spelling());
    dialect_.sent(command.command);
    moving_.sent(command.command);
    writer_(command, std::move(text));
}

std::vector<protocol::Command> Outgoing::stops(const std::optional<protocol::Command>& safe,
                                               protocol::VehicleKind kind) const {
    std::vector<protocol::Command> stops;
    if (!safe)
        stops = protocol::zeroDrives(kind);
    for (const protocol::Command& stop : moving_.stops()) {
        if ((!safe || stop.index() != safe->index()) && std::ranges::find(stops, stop) == stops.end())
            stops.push_back(stop);
    }
    return stops;
}

} // namespace usar::mission
