#include "robots/submarine/diver_behavior.h"

#include "core/base/text.h"

namespace usar::submarine {

void DiverBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    const bool known = questions_.goOn(tick.robot.configuration);
    diver_.perceive(tick, known ? std::optional(questions_.limits()) : std::nullopt);
    const protocol::NauticDrive drive = diver_.decide();
    publish(tick, port);
    if (diver_.ending())
        return end(port);
    port.send(drive, diver_.state());
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
    if (auto command = camera_.next(tick.now, Seconds(diver_.settings().sweep_s), questions_.limits()))
        port.send(*std::move(command), "looking around");
}

/// Publishes the status. The stock robot does not know where it is; if a GroundTruth sensor is mounted, its pose shows
/// the user the path on the map, but the robot makes no decisions by it.
void DiverBehavior::publish(const agent::Tick& tick, agent::CommandPort& port) {
    for (agent::BehaviorEvent& event : diver_.takeEvents())
        port.publish(std::move(event));
    if (const auto* const truth = tick.robot.sensors.groundTruth())
        port.publish(agent::PoseEstimate{tick.now, truth->value.base_in_map});
    port.publish(diver_.status());
}

void DiverBehavior::order(agent::Order order, agent::CommandPort& port) {
    diver_.order(order);
    if (diver_.ending())
        end(port);
}

void DiverBehavior::end(agent::CommandPort& port) {
    port.send(safeCommand(), "done");
    port.publish(*diver_.ending());
}

} // namespace usar::submarine
