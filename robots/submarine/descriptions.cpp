#include "robots/submarine/descriptions.h"

#include "core/base/text.h"
#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/diver.h"

namespace usar::submarine {

namespace {

/// The thesis's nautical robot (3.5.1). Asks for the robot's limits, passes messages to the Diver, which decides, sends
/// its commands and moves the camera. The stock robot does not know where it is; if a GroundTruth sensor is mounted,
/// its pose shows the user the path on the map, but the robot makes no decisions by it.
class DiverBehavior : public agent::TimedBehavior<Diver> {
public:
    using TimedBehavior::TimedBehavior;

    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
        const bool known = questions_.goOn(tick.robot.configuration);
        decider_.perceive(tick, known ? std::optional(questions_.limits()) : std::nullopt);
        const protocol::NauticDrive drive = decider_.decide();
        std::optional<agent::PoseEstimate> pose;
        if (const auto* const truth = tick.robot.sensors.groundTruth())
            pose = {tick.now, truth->value.base_in_map};
        if (!goesOn(pose, port))
            return;
        port.send(drive, decider_.state());
        if (known)
            moveCamera(tick, port);
    }

    protocol::Command safeCommand() const override { return protocol::NauticDrive{0.0, 0.0, 0.0}; }

private:
    void moveCamera(const agent::Tick& tick, agent::CommandPort& port) {
        for (const protocol::Response& response : tick.robot.responses.takeAll()) {
            if (response.ok || zoom_refused_ || !sameWord(response.type, "Camera"))
                continue;
            zoom_refused_ = true; // Tell the user only once, because the sweep keeps trying
            port.publish(agent::BehaviorEvent{Severity::Note, "The camera does not zoom as it is told."});
        }
        if (auto command = camera_.next(tick.now, Seconds(decider_.settings().sweep_s), questions_.limits()))
            port.send(*std::move(command), "looking around");
    }

    Questionnaire questions_; ///< finds out the limits
    CameraSweep camera_;
    bool zoom_refused_ = false; ///< the user has been told that the camera refuses to zoom
};

} // namespace

SubmarineRobot::SubmarineRobot() : ListedRobot("USARBot.Submarine", "Submarine", {"Range"}) {
    add<DiverBehavior>(
        {.id = "submarine/cpp",
         .name = "Along the bottom (C++)",
         .help = "Asks for its configuration, then keeps its height above the bottom with the ray on its belly. Turns "
                 "with the rudder while it is level, backs off when the bottom rises too fast, and pans its camera.",
         .parameters = Settings::parameters.specs()});
}

} // namespace usar::submarine
