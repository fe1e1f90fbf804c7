#include "robots/p2dx/explorer_behavior.h"

namespace usar::p2dx {

/// Checks the conditions in order of importance, the same as in the plan.
protocol::SkidDrive ExplorerBehavior::decide() {
    if (explorer_.scanAge() > blind_after || explorer_.waiting())
        return explorer_.halt();
    if (explorer_.trapped())
        explorer_.escape();
    if (explorer_.inDanger())
        return explorer_.reverse();
    if (explorer_.mustTurn())
        return explorer_.turnAway();
    switch (explorer_.open()) {
    case Third::Left:
        return explorer_.steerLeft();
    case Third::Right:
        return explorer_.steerRight();
    case Third::Ahead:
        break;
    }
    return explorer_.goAhead();
}

void ExplorerBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    explorer_.perceive(tick);
    const protocol::SkidDrive drive = decide();
    for (agent::BehaviorEvent& event : explorer_.takeEvents())
        port.publish(std::move(event));
    port.publish(explorer_.pose());
    port.publish(explorer_.status());
    if (explorer_.ending())
        end(port);
    else
        port.send(drive, explorer_.state());
}

void ExplorerBehavior::order(agent::Order order, agent::CommandPort& port) {
    explorer_.order(order);
    if (explorer_.ending())
        end(port);
}

void ExplorerBehavior::end(agent::CommandPort& port) {
    port.send(safeCommand(), "done");
    port.publish(*explorer_.ending());
}

} // namespace usar::p2dx
