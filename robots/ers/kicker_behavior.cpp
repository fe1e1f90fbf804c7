#include "robots/ers/kicker_behavior.h"

namespace usar::ers {

void KickerBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    kicker_.perceive(tick);
    const bool fallen = kicker_.hasFallen();
    if (fallen)
        kicker_.standUpAgain();
    const auto drive = kicker_.walk();
    for (agent::BehaviorEvent& event : kicker_.takeEvents())
        port.publish(std::move(event));
    if (kicker_.base_in_map())
        port.publish(agent::PoseEstimate{tick.now, *kicker_.base_in_map()});
    port.publish(kicker_.status());
    if (kicker_.ending())
        return end(port);
    trace(port);
    if (drive)
        port.send(*drive, kicker_.state());
    if (fallen)
        port.send(protocol::DriveSwitches{.flip = true}, kicker_.state());
}

/// Sends TRACE with its interval and color at the start, and again whenever the user changes the settings.
void KickerBehavior::trace(agent::CommandPort& port) {
    const Settings& wanted = kicker_.settings();
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

void KickerBehavior::order(agent::Order order, agent::CommandPort& port) {
    kicker_.order(order);
    if (kicker_.ending())
        end(port);
}

void KickerBehavior::end(agent::CommandPort& port) {
    port.send(safeCommand(), "done");
    port.publish(*kicker_.ending());
}

} // namespace usar::ers
