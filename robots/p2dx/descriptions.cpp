#include "robots/p2dx/descriptions.h"

#include "robots/p2dx/explorer_behavior.h"
#include "robots/p2dx/explorer_plan.h"

namespace usar::p2dx {

namespace {
const char* const coded_id = "p2dx/cpp";
const char* const planned_id = "p2dx/posh";
} // namespace

agent::RobotDescription describeP2dx() {
    agent::BehaviorDescription coded;
    coded.id = coded_id;
    coded.name = "Most open direction (C++)";
    coded.help = "Heads for the most open third of the laser's view, backs away and turns where something is too close "
                 "ahead, and turns around where it gets no further. Stays in the area, if there is one.";
    coded.parameters = parameterSpecs();
    agent::BehaviorDescription planned = coded;
    planned.id = planned_id;
    planned.name = "Most open direction (POSH)";
    planned.help += " Decided by a POSH plan, which can be read and changed.";
    const agent::PlanText plan = explorerPlan();
    planned.plan_name = plan.name;
    planned.plan_text = plan.text;
    return {"USARBot.P2DX",
            "P2DX",
            {"RangeScanner", "Sonar", "INS"},
            {std::move(coded), std::move(planned)},
            explorerRegistry().descriptions()};
}

Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context) {
    if (id == planned_id)
        return makePlannedExplorer(std::move(context));
    if (id != coded_id)
        return failure("the P2DX has no such behavior", "behavior " + id,
                       std::string("Use ") + coded_id + " or " + planned_id);
    return std::make_unique<ExplorerBehavior>(std::move(context));
}

} // namespace usar::p2dx
