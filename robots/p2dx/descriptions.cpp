#include "robots/p2dx/descriptions.h"

#include <functional>

#include "core/agent/posh_primitives.h"
#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

extern const char explorer_plan_text[]; // Contents of resources/plans/p2dx.lap

namespace {

constexpr protocol::SkidDrive standing{0.0, 0.0};

/// The thesis's ground robot (3.5.3), controlled by a few conditions in C++. Sends one DRIVE per tick until the
/// Explorer ends; then stops the wheels.
class ExplorerBehavior : public agent::TimedBehavior<Explorer> {
public:
    using TimedBehavior::TimedBehavior;

    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
        decider_.perceive(tick);
        const protocol::SkidDrive drive = decide();
        if (goesOn(decider_.pose(), port))
            port.send(drive, decider_.state());
    }

    protocol::Command safeCommand() const override { return standing; }

private:
    /// Checks the conditions in order of importance, the same as in the plan.
    protocol::SkidDrive decide() {
        if (decider_.blind() || decider_.waiting())
            return decider_.halt();
        if (decider_.trapped())
            decider_.escape();
        if (decider_.inDanger())
            return decider_.reverse();
        if (decider_.mustTurn())
            return decider_.turnAway();
        if (decider_.open() == Third::Ahead)
            return decider_.goAhead();
        return decider_.open() == Third::Left ? decider_.steerLeft() : decider_.steerRight();
    }
};

/// Connects an Explorer to a plan's engine. Owned by one behavior.
class ExplorerBody final : public agent::PoshBody {
public:
    explicit ExplorerBody(const agent::BehaviorContext& context) : explorer(context) {}

    void onInfo(const protocol::InfoLine& line) override { explorer.hear(line); }
    void begin(const agent::Tick& tick) override { explorer.perceive(tick); }
    void end(const agent::Tick&) override {
        for (agent::BehaviorEvent& event : explorer.takeEvents())
            publish(std::move(event));
        publish(explorer.pose());
    }
    bool order(agent::Order order) override { return explorer.order(order); }
    void setParameters(const agent::ParameterSet& parameters) override { explorer.setParameters(parameters); }
    void describe(agent::BehaviorStatus& status) const override { status = explorer.status(); }
    std::optional<agent::BehaviorFinished> ended() const override { return explorer.ending(); }
    protocol::Command safeCommand() const override { return standing; }

    Explorer explorer;
};

using Primitives = agent::PoshPrimitives<ExplorerBody>;

/// Registers a sense that answers `ask(explorer)`.
template <class Ask>
agent::PoshRegistry::Entry addSense(Primitives& list, std::string name, std::string help, Ask ask) {
    return list.sense(std::move(name), [ask](const ExplorerBody& body) { return std::invoke(ask, body.explorer); })
        .describe(std::move(help));
}

/// Registers an act that sends the DRIVE of one tick and is complete after the cycle.
void addDrive(Primitives& list, std::string name, std::string help, protocol::SkidDrive (Explorer::*act)()) {
    list.act(std::move(name),
             [act](ExplorerBody& body) {
                 const protocol::SkidDrive drive = (body.explorer.*act)();
                 body.drive(drive, body.explorer.state());
             })
        .describe(std::move(help))
        .needs("DRIVE");
}

void addSenses(Primitives& list) {
    addSense(list, "ScanAge", "Time since the newest message of the range scanner. Very large before the first one.",
             [](const Explorer& explorer) { return explorer.scanAge().count(); })
        .unit("s")
        .needs("RangeScanner");
    addSense(list, "Waiting", "A person asked the robot to wait, or it has not rested long enough to start.",
             &Explorer::waiting);
    addSense(
        list, "IsInDanger",
        "Something ahead is too close, the ground falls too steeply, or the robot is still backing away from that.",
        &Explorer::inDanger)
        .needs("RangeScanner")
        .needs("Sonar");
    addSense(list, "IsTrapped", "The robot has stayed in one place for longer than the settings allow.",
             &Explorer::trapped)
        .needs("INS");
    addSense(list, "MustTurn", "The robot has backed away or is turning around, and the way is not free yet.",
             &Explorer::mustTurn);
    addSense(list, "OpenLeft", "The left third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Left; });
    addSense(list, "OpenAhead", "The middle third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Ahead; });
    addSense(list, "OpenRight", "The right third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Right; });
}

void addActs(Primitives& list) {
    addDrive(list, "Halt", "Stops both wheels.", &Explorer::halt);
    addDrive(list, "Reverse",
             "Backs away over ground that the robot has crossed, and turns slightly away from the nearer side. Then "
             "the robot must turn.",
             &Explorer::reverse);
    addDrive(list, "TurnAway", "Turns in place, away from what was too close.", &Explorer::turnAway);
    addDrive(list, "GoAhead", "Drives straight ahead at cruise speed, or slower if something is ahead.",
             &Explorer::goAhead);
    addDrive(list, "SteerLeft", "Drives ahead in a curve to the left.", &Explorer::steerLeft);
    addDrive(list, "SteerRight", "Drives ahead in a curve to the right.", &Explorer::steerRight);
    list.act("Escape",
             [](ExplorerBody& body) {
                 body.explorer.escape();
                 return posh::ActResult::Finished;
             })
        .describe(
            "Starts to turn around to the other side. The second time in the same place, the robot backs away first.");
}

} // namespace

P2dxRobot::P2dxRobot() : ListedRobot("USARBot.P2DX", "P2DX", {"RangeScanner", "Sonar", "INS"}) {
    add<ExplorerBehavior>(
        {.id = "p2dx/cpp",
         .name = "Most open direction (C++)",
         .help = "Heads for the most open third of the laser's view. Backs away and turns if something ahead is too "
                 "close, and turns around if it gets no farther. Stays inside the mission area if there is one.",
         .parameters = Settings::parameters.specs()});
    addPlanned<ExplorerBody>("p2dx/posh", "Most open direction (POSH)", {"p2dx.lap", explorer_plan_text},
                             agent::registryOf<ExplorerBody>({addSenses, addActs}));
}

} // namespace usar::p2dx
