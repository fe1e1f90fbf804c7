#include "robots/ers/kicker_behavior.h"

namespace usar::ers {

void KickerBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    decider_.perceive(tick);
    const bool fallen = decider_.hasFallen();
    if (fallen)
        decider_.standUpAgain();
    const auto drive = decider_.walk();
    std::optional<agent::PoseEstimate> pose;
    if (decider_.base_in_map())
        pose = {tick.now, *decider_.base_in_map()};
    if (!goesOn(pose, port))
        return;
    trace(port);
    if (drive)
        port.send(*drive, decider_.state());
    if (fallen)
        port.send(protocol::DriveSwitches{.flip = true}, decider_.state());
}

/// Sends TRACE with its interval and color at the start, and again whenever the user changes the settings.
void KickerBehavior::trace(agent::CommandPort& port) {
    const Settings& wanted = decider_.settings();
    if (wanted.trace == traced_ && (!traced_ || wanted.trace_interval_s == traced_interval_s_))
        return;
    traced_ = wanted.trace;
    traced_interval_s_ = wanted.trace_interval_s;
    protocol::Trace trace{traced_};
    if (traced_) {
        trace.interval = Seconds(traced_interval_s_);
        trace.color = protocol::TraceColor::Yellow;
    }
    port.send(trace, "its way");
}

protocol::Command KickerBehavior::safeCommand() const {
    protocol::MultiDrive drive;
    for (const Leg leg : all_legs)
        putPaw(drive, leg, standing_paw);
    return drive;
}

} // namespace usar::ers
