#include "robots/airrobot/descriptions.h"

#include "robots/airrobot/survey_behavior.h"

namespace usar::airrobot {

namespace {
const char* const survey_id = "airrobot/cpp";
}

agent::RobotDescription describeAirRobot() {
    agent::BehaviorDescription survey;
    survey.id = survey_id;
    survey.name = "Terrain survey (C++)";
    survey.help = "Maps the mission area in lanes, keeps its height over the terrain, goes round and over obstacles, "
                  "charges at its base and lands there at the end.";
    survey.needs_area = true;
    survey.parameters = parameterSpecs();
    return {"USARBot.AirRobot", "AirRobot", {"INS", "GroundTruth", "RangeScanner", "Sonar"}, {std::move(survey)}};
}

Result<std::unique_ptr<agent::Behavior>> makeBehavior(const std::string& id, agent::BehaviorContext context) {
    if (id != survey_id)
        return failure("the AirRobot has no such behavior", "behavior " + id, std::string("Use ") + survey_id);
    return std::make_unique<SurveyBehavior>(std::move(context));
}

} // namespace usar::airrobot
