#include "robots/airrobot/descriptions.h"

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/survey_behavior.h"
#include "robots/airrobot/survey_plan.h"

namespace usar::airrobot {

namespace {
const char* const survey_id = "airrobot/cpp";
const char* const planned_survey_id = "airrobot/posh";
} // namespace

agent::RobotDescription describeAirRobot() {
    agent::BehaviorDescription survey;
    survey.id = survey_id;
    survey.name = "Terrain survey (C++)";
    survey.help = "Maps the mission area in lanes, keeps its height over the terrain, goes round and over obstacles, "
                  "charges at its base and lands there at the end.";
    survey.needs_area = true;
    survey.parameters = parameterSpecs();
    agent::BehaviorDescription planned = survey;
    planned.id = planned_survey_id;
    planned.name = "Terrain survey (POSH)";
    planned.help += " Decided by a POSH plan, which can be read and changed.";
    const agent::PlanText plan = surveyPlan();
    planned.plan_name = plan.name;
    planned.plan_text = plan.text;
    return {"USARBot.AirRobot",
            "AirRobot",
            {"INS", "GroundTruth", "RangeScanner", "Sonar"},
            {std::move(survey), std::move(planned)},
            surveyRegistry().descriptions()};
}

Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context) {
    if (id == planned_survey_id)
        return makePlannedSurvey(std::move(context));
    if (id != survey_id)
        return failure("the AirRobot has no such behavior", "behavior " + id,
                       std::string("Use ") + survey_id + " or " + planned_survey_id);
    return std::make_unique<SurveyBehavior>(std::move(context));
}

Result<agent::TaskPreview> previewSurvey(const agent::BehaviorContext& context) {
    const Settings settings = settingsFrom(context.parameters);
    const Vec2 base_m = context.task.start_in_map.position_m.head<2>();
    const auto plan =
        mapping::planCoverage(context.task.area_in_map, base_m, {settings.lane_spacing_m, settings.quadrant_limit_m});
    if (!plan)
        return tl::unexpected(plan.error());
    agent::TaskPreview preview;
    for (const mapping::Lane& lane : plan->lanes)
        preview.path_in_map_m.insert(preview.path_in_map_m.end(), {lane.start_m, lane.end_m});
    preview.length_m = plan->lane_length_m + plan->transit_length_m;
    preview.duration = mapping::estimatedTime(*plan, settings.scan_speed_m_s, settings.transit_speed_m_s);
    const std::size_t parts = plan->quadrants.size();
    preview.summary = std::to_string(plan->lanes.size()) + (plan->lanes.size() == 1 ? " lane" : " lanes") +
                      (parts > 1 ? " in " + std::to_string(parts) + " parts" : "");
    return preview;
}

} // namespace usar::airrobot
