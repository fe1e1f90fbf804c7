#include "robots/p2dx/explorer_plan.h"

#include <utility>

#include "core/agent/posh/posh_behavior.h"
#include "core/agent/posh_primitives.h"
#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

extern const char explorer_plan_text[]; // Contents of resources/plans/p2dx.lap

namespace {

/// The state that the senses and acts share: the explorer.
class ExplorerBody final : public agent::PoshBody {
public:
    explicit ExplorerBody(agent::BehaviorContext context) : explorer_(std::move(context)) {}

    const Explorer& explorer() const { return explorer_; }
    Explorer& explorer() { return explorer_; }

    void onInfo(const protocol::InfoLine& line) override { explorer_.hear(line); }
    void begin(const agent::Tick& tick) override { explorer_.perceive(tick); }
    void end(const agent::Tick&) override {
        for (agent::BehaviorEvent& event : explorer_.takeEvents())
            publish(std::move(event));
        publish(explorer_.pose());
    }
    bool order(agent::Order order) override { return explorer_.order(order); }
    void setParameters(const agent::ParameterSet& parameters) override { explorer_.setParameters(parameters); }
    void describe(agent::BehaviorStatus& status) const override { status = explorer_.status(); }
    std::optional<agent::BehaviorFinished> ended() const override { return explorer_.ending(); }
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }

private:
    Explorer explorer_;
};

using ExplorerPrimitives = agent::PoshPrimitives<ExplorerBody>;

/// Registers a sense that answers `ask(explorer)`.
template <class Ask>
agent::PoshRegistry::Entry addSense(ExplorerPrimitives& primitives, std::string name, std::string help, Ask ask) {
    return primitives.sense(std::move(name), [ask](const ExplorerBody& body) { return ask(body.explorer()); })
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

void addSenses(ExplorerPrimitives& primitives) {
    addSense(primitives, "ScanAge", "Time since the newest message of the range scanner; large before the first.",
             [](const Explorer& explorer) { return explorer.scanAge().count(); })
        .unit("s")
        .needs("RangeScanner");
    addSense(primitives, "Waiting", "A person asked the robot to wait, or it has not rested enough to start.",
             [](const Explorer& explorer) { return explorer.waiting(); });
    addSense(
        primitives, "IsInDanger",
        "Something in the strip ahead is within the safety distance, or the ground falls too steeply, or the robot "
        "is still backing away from that.",
        [](const Explorer& explorer) { return explorer.inDanger(); })
        .needs("RangeScanner")
        .needs("Sonar");
    addSense(primitives, "IsTrapped", "The robot has been in one place for longer than the settings allow.",
             [](const Explorer& explorer) { return explorer.trapped(); })
        .needs("INS");
    addSense(primitives, "MustTurn", "The robot has backed away, or is to turn around, and the way is not free yet.",
             [](const Explorer& explorer) { return explorer.mustTurn(); });
    addSense(primitives, "OpenLeft", "The left third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Left; });
    addSense(primitives, "OpenAhead", "The middle third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Ahead; });
    addSense(primitives, "OpenRight", "The right third of the scan has the greatest mean range.",
             [](const Explorer& explorer) { return explorer.open() == Third::Right; });
}

void addActs(ExplorerPrimitives& primitives) {
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

} // namespace

const agent::PoshRegistry& explorerRegistry() {
    static const agent::PoshRegistry all = [] {
        agent::PoshRegistry registry;
        ExplorerPrimitives primitives(registry);
        addSenses(primitives);
        addActs(primitives);
        return registry;
    }();
    return all;
}

agent::PlanText explorerPlan() {
    return {"p2dx.lap", explorer_plan_text};
}

Result<std::unique_ptr<agent::Behavior>> makePlannedExplorer(agent::BehaviorContext context) {
    agent::PlanText plan = context.plan ? *context.plan : explorerPlan();
    auto made = agent::PoshBehavior::make({std::move(plan.name),
                                           std::move(plan.text),
                                           explorerRegistry(),
                                           std::make_unique<ExplorerBody>(std::move(context)),
                                           {}});
    if (!made)
        return tl::unexpected(made.error());
    return *std::move(made);
}

} // namespace usar::p2dx
