#include "core/mission/commands/drive_gate.h"

#include <algorithm>
#include <utility>

#include "core/mission/commands/drive_merge.h"

namespace usar::mission {

bool DriveGate::offer(agent::CausedCommand drive) {
    const auto old = std::ranges::find_if(
        held_, [&drive](const agent::CausedCommand& held) { return replaces(drive.command, held.command); });
    const bool replaced = old != held_.end();
    if (replaced) {
        keepAbsentTerms(drive.command, old->command);
        held_.erase(old);
    }
    complete(drive.command);
    std::erase_if(held_,
                  [&drive](agent::CausedCommand& held) { return !takeOutWhatIsOld(held.command, drive.command); });
    held_.push_back(std::move(drive));
    return replaced;
}

/// Completes an AckermannDrive from the earlier ones, except for its lights, which are not repeated.
void DriveGate::complete(protocol::Command& drive) {
    auto* const ackermann = std::get_if<protocol::AckermannDrive>(&drive);
    if (!ackermann)
        return;
    if (last_ackermann_)
        keepAbsentTerms(drive, *last_ackermann_);
    protocol::AckermannDrive said = *ackermann;
    said.switches = {};
    last_ackermann_ = said;
}

std::vector<agent::CausedCommand> DriveGate::release(Seconds now, bool at_once) {
    // Times on the wire have two decimals: a difference of half a hundredth must not cost a tick.
    constexpr Seconds rounding{0.005};
    if (!at_once && last_sent_ && now >= *last_sent_ && now - *last_sent_ < spacing - rounding)
        return {};
    if (!held_.empty())
        last_sent_ = now;
    return std::exchange(held_, {});
}

} // namespace usar::mission
