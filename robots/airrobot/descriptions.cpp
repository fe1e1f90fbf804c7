#include "robots/airrobot/descriptions.h"

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/survey_behavior.h"
#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

extern const char survey_plan_text[]; // Contents of resources/plans/airrobot.lap

AirRobot::AirRobot() : ListedRobot("USARBot.AirRobot", "AirRobot", {"INS", "GroundTruth", "RangeScanner", "Sonar"}) {
    add<SurveyBehavior>({.id = "airrobot/cpp",
                         .name = "Terrain survey (C++)",
                         .help = "Maps the mission area in lanes, keeps its height over the terrain, goes round and "
                                 "over obstacles, charges at its base and lands there at the end.",
                         .needs_area = true,
                         .parameters = Settings::parameters.specs()});
    addPlanned<SurveyBody>("airrobot/posh", "Terrain survey (POSH)", {"airrobot.lap", survey_plan_text},
                           agent::registryOf<SurveyBody>({addSurveySenses, addSurveyActs}));
}

Result<agent::TaskPreview> AirRobot::preview(const std::string&, const agent::BehaviorContext& context) const {
    const Settings settings = Settings::parameters.settings(context.parameters);
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
