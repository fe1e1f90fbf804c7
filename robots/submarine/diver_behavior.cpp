#include "robots/submarine/diver_behavior.h"

#include "core/base/text.h"

namespace usar::submarine {

/// The stock robot does not know where it is; if a GroundTruth sensor is mounted, its pose shows the user the path on
/// the map, but the robot makes no decisions by it.
void DiverBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
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

void DiverBehavior::moveCamera(const agent::Tick& tick, agent::CommandPort& port) {
    for (const protocol::Response& response : tick.robot.responses.takeAll()) {
        if (response.ok || zoom_refused_ || !sameWord(response.type, "Camera"))
            continue;
        zoom_refused_ = true; // Tell the user only once, because the sweep keeps trying
        port.publish(agent::BehaviorEvent{Severity::Note, "The camera does not zoom as it is told."});
    }
    if (auto command = camera_.next(tick.now, Seconds(decider_.settings().sweep_s), questions_.limits()))
        port.send(*std::move(command), "looking around");
}

} // namespace usar::submarine
