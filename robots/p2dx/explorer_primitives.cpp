#include <functional>

#include "robots/p2dx/explorer_body.h"

namespace usar::p2dx {

namespace {

/// Registers a sense that answers `ask(explorer)`.
template <class Ask>
agent::PoshRegistry::Entry addSense(ExplorerPrimitives& primitives, std::string name, std::string help, Ask ask) {
    return primitives
        .sense(std::move(name), [ask](const ExplorerBody& body) { return std::invoke(ask, body.explorer()); })
        .describe(std::move(help));
}

/// Registers an act that sends the DRIVE of one tick and is complete after the cycle.
void addDrive(ExplorerPrimitives& primitives, std::string name, std::string help,
              protocol::SkidDrive (Explorer::*act)()) {
    primitives
        .act(std::move(name),
             [act](ExplorerBody& body) {
                 const protocol::SkidDrive drive = (body.explorer().*act)();
                 body.drive(drive, body.explorer().state());
             })
        .describe(std::move(help))
        .needs("DRIVE");
}

} // namespace

void addExplorerSenses(ExplorerPrimitives& primitives) {
    addSense(primitives, "ScanAge", "Time since the newest message of the range scanner; large before the first.",
             [](const Explorer& explorer) { return explorer.scanAge().count(); })
        .unit("s")
        .needs("RangeScanner");
    addSense(primitives, "Waiting", "A person asked the robot to wait, or it has not rested enough to start.",
             &Explorer::waiting);
    addSense(
        primitives, "IsInDanger",
        "Something in the strip ahead is within the safety distance, or the ground falls too steeply, or the robot "
        "is still backing away from that.",
        &Explorer::inDanger)
        .needs("RangeScanner")
        .needs("Sonar");
    addSense(primitives, "IsTrapped", "The robot has been in one place for longer than the settings allow.",
             &Explorer::trapped)
        .needs("INS");
    addSense(primitives, "MustTurn", "The robot has backed away, or is to turn around, and the way is not free yet.",
             &Explorer::mustTurn);
    addSense(primitives, "OpenLeft", "The left third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Left; });
    addSense(primitives, "OpenAhead", "The middle third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Ahead; });
    addSense(primitives, "OpenRight", "The right third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Right; });
}

void addExplorerActs(ExplorerPrimitives& primitives) {
    addDrive(primitives, "Halt", "Both wheels stand.", &Explorer::halt);
    addDrive(primitives, "Reverse",
             "Both wheels backward, unequal so that the robot turns away from the nearer side; as far as it knows the "
             "ground behind it, then it must turn.",
             &Explorer::reverse);
    addDrive(primitives, "TurnAway", "Turns in place, away from what was near.", &Explorer::turnAway);
    addDrive(primitives, "GoAhead", "Both wheels forward at cruise speed, slower the nearer things ahead are.",
             &Explorer::goAhead);
    addDrive(primitives, "SteerLeft", "The left wheel slower than the right one.", &Explorer::steerLeft);
    addDrive(primitives, "SteerRight", "The right wheel slower than the left one.", &Explorer::steerRight);
    primitives
        .act("Escape",
             [](ExplorerBody& body) {
                 body.explorer().escape();
                 return posh::ActResult::Finished;
             })
        .describe("Has the robot turn around to the other side; where that did not help, back away first.");
}

} // namespace usar::p2dx
