#include "robots/p2dx/explorer_behavior.h"

namespace usar::p2dx {

/// Checks the conditions in order of importance, the same as in the plan.
protocol::SkidDrive ExplorerBehavior::decide() {
    if (decider_.scanAge() > blind_after || decider_.waiting())
        return decider_.halt();
    if (decider_.trapped())
        decider_.escape();
    if (decider_.inDanger())
        return decider_.reverse();
    if (decider_.mustTurn())
        return decider_.turnAway();
    switch (decider_.open()) {
    case Third::Left:
        return decider_.steerLeft();
    case Third::Right:
        return decider_.steerRight();
    case Third::Ahead:
        break;
    }
    return decider_.goAhead();
}

void ExplorerBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    decider_.perceive(tick);
    const protocol::SkidDrive drive = decide();
    if (goesOn(decider_.pose(), port))
        port.send(drive, decider_.state());
}

} // namespace usar::p2dx
