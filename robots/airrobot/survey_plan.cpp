#include "robots/airrobot/survey_plan.h"

#include <utility>

#include "core/agent/posh/posh_behavior.h"
#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

extern const char survey_plan_text[]; // Contents of resources/plans/airrobot.lap

const agent::PoshRegistry& surveyRegistry() {
    static const agent::PoshRegistry all = [] {
        agent::PoshRegistry registry;
        SurveyPrimitives primitives(registry);
        addSurveySenses(primitives);
        addSurveyActs(primitives);
        return registry;
    }();
    return all;
}

agent::PlanText surveyPlan() {
    return {"airrobot.lap", survey_plan_text};
}

Result<std::unique_ptr<agent::Behavior>> makePlannedSurvey(agent::BehaviorContext context) {
    agent::PlanText plan = context.plan ? *context.plan : surveyPlan();
    auto made = agent::PoshBehavior::make({std::move(plan.name),
                                           std::move(plan.text),
                                           surveyRegistry(),
                                           std::make_unique<SurveyBody>(std::move(context)),
                                           {}});
    if (!made)
        return tl::unexpected(made.error());
    return *std::move(made);
}

} // namespace usar::airrobot
