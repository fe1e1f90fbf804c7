#include "core/mission/commands/safe_stop.h"

#include <algorithm>

#include "core/mission/commands/drive_merge.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/zero_drives.h"

namespace usar::mission {

using namespace protocol;

namespace {

using Commands = std::vector<Command>;

Commands stopsOf(const SkidDrive&) {
    return {no_spin};
}
Commands stopsOf(const AckermannDrive&) {
    return {no_roll};
}
Commands stopsOf(const AerialDrive&) {
    return {no_flight};
}
Commands stopsOf(const NauticDrive&) {
    return {no_thrust};
}
Commands stopsOf(const OmniDrive& drive) {
    OmniDrive stop;
    for (const WheelDrive& wheel : drive.wheels)
        stop.wheels.push_back({.wheel = wheel.wheel, .spin_rad_s = 0.0});
    return {stop};
}

/// Stops a joint. An angle is held by going to where the joint is now.
Commands stopsOfJoint(const Token& joint, bool to_an_angle) {
    return {JointDrive{joint, to_an_angle ? JointOrder::RelativeAngle : JointOrder::Speed, 0.0}};
}
Commands stopsOf(const JointDrive& drive) {
    if (drive.order == JointOrder::Brake)
        return {};
    return stopsOfJoint(drive.joint, drive.order == JointOrder::Angle || drive.order == JointOrder::RelativeAngle);
}
Commands stopsOf(const MultiDrive& drive) {
    Commands stops;
    for (const JointAngleTarget& target : drive.joints)
        stops.push_back(stopsOfJoint(target.joint, true).front());
    return stops;
}
Commands stopsOf(const SetJoint& set) {
    if (set.opcode == JointOpcode::Stiffness)
        return {};
    return stopsOfJoint(set.joint, set.opcode == JointOpcode::Angle || set.opcode == JointOpcode::RelativeAngle);
}

/// Makes one command per link, so that each can be replaced by itself. A package that goes to an angle ends there.
Commands stopsOf(const PackageDrive& drive) {
    Commands stops;
    for (const LinkTarget& target : drive.links) {
        if (target.order != LinkOrder::Angle)
            stops.push_back(PackageDrive{drive.package, {{target.link, 0.0, LinkOrder::Speed}}});
    }
    return stops;
}

template <class Other>
Commands stopsOf(const Other&) {
    return {};
}

bool sameThing(const Command& a, const Command& b) {
    const auto* const package = std::get_if<PackageDrive>(&a);
    return package ? a == b : replaces(a, b);
}

} // namespace

void MovingParts::sent(const Command& command) {
    if (const auto* const raw = std::get_if<RawCommand>(&command)) {
        Diagnostics ignored;
        const Command read = readCommand(raw->line, ignored);
        if (!std::holds_alternative<RawCommand>(read))
            sent(read);
        return;
    }
    for (const Command& stop : std::visit([](const auto& one) { return stopsOf(one); }, command))
        remember(stop);
}

void MovingParts::remember(const Command& stop) {
    const auto known = std::ranges::find_if(stops_, [&stop](const Command& one) { return sameThing(stop, one); });
    if (known == stops_.end()) {
        stops_.push_back(stop);
        return;
    }
    Command all = stop;
    keepAbsentTerms(all, *known); // Keeps the wheels of an earlier command.
    *known = all;
}

} // namespace usar::mission
