#include "core/mission/commands/safe_stop.h"

#include <algorithm>

#include "core/mission/commands/drive_merge.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/zero_drives.h"

namespace usar::mission {

using namespace protocol;

namespace {

using Commands = std::vector<Command>;

/// Stops a joint. An angle is held by going to where the joint is now.
Command stopOfJoint(const Token& joint, bool to_an_angle) {
    return JointDrive{joint, to_an_angle ? JointOrder::RelativeAngle : JointOrder::Speed, 0.0};
}

/// The commands that stop what a command has set in motion.
struct Stops {
    Commands operator()(const SkidDrive&) const { return {no_spin}; }
    Commands operator()(const AckermannDrive&) const { return {no_roll}; }
    Commands operator()(const AerialDrive&) const { return {no_flight}; }
    Commands operator()(const NauticDrive&) const { return {no_thrust}; }
    Commands operator()(const OmniDrive& drive) const {
        OmniDrive stop;
        for (const WheelDrive& wheel : drive.wheels)
            stop.wheels.push_back({.wheel = wheel.wheel, .spin_rad_s = 0.0});
        return {stop};
    }
    Commands operator()(const JointDrive& drive) const {
        if (drive.order == JointOrder::Brake)
            return {};
        return {stopOfJoint(drive.joint, drive.order == JointOrder::Angle || drive.order == JointOrder::RelativeAngle)};
    }
    Commands operator()(const MultiDrive& drive) const {
        Commands stops;
        for (const JointAngleTarget& target : drive.joints)
            stops.push_back(stopOfJoint(target.joint, true));
        return stops;
    }
    Commands operator()(const SetJoint& set) const {
        if (set.opcode == JointOpcode::Stiffness)
            return {};
        return {stopOfJoint(set.joint, set.opcode == JointOpcode::Angle || set.opcode == JointOpcode::RelativeAngle)};
    }
    /// One command per link, so that each can be replaced by itself. A package that goes to an angle ends there.
    Commands operator()(const PackageDrive& drive) const {
        Commands stops;
        for (const LinkTarget& target : drive.links)
            if (target.order != LinkOrder::Angle)
                stops.push_back(PackageDrive{drive.package, {{target.link, 0.0, LinkOrder::Speed}}});
        return stops;
    }
    Commands operator()(const auto&) const { return {}; }
};

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
    for (const Command& stop : std::visit(Stops{}, command))
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
