#include "robots/ers/descriptions.h"

#include "robots/ers/kicker.h"

namespace usar::ers {

namespace {

/// The thesis's legged robot (3.5.2). Passes messages to the Kicker, which decides, and sends its commands. Rights the
/// robot after a fall and marks its path with TRACE.
class KickerBehavior : public agent::TimedBehavior<Kicker> {
public:
    using TimedBehavior::TimedBehavior;

    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
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

    /// Puts all paws down so that the robot stands still.
    protocol::Command safeCommand() const override {
        protocol::MultiDrive drive;
        for (const Leg leg : all_legs)
            putPaw(drive, leg, standing_paw);
        return drive;
    }

private:
    /// Sends TRACE with its interval and color at the start, and again whenever the user changes the settings.
    void trace(agent::CommandPort& port) {
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

    bool traced_ = false;            ///< whether TRACE was last switched on or off
    double traced_interval_s_ = 0.0; ///< interval that was last sent
};

} // namespace

ErsRobot::ErsRobot() : ListedRobot("USARBot.ERS", "ERS", {"Helper", "INS"}) {
    add<KickerBehavior>({.id = "ers/cpp",
                         .name = "After the ball (C++)",
                         .help = "Walks in circles until it sees the ball, walks to it while watching it, and kicks it "
                                 "by walking on. Marks its path with TRACE.",
                         .parameters = Settings::parameters.specs()});
}

} // namespace usar::ers
