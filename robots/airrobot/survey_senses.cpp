#include <array>

#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

namespace {

/// Registers a sense that answers `ask` about the flight, its craft or its launch checklist.
template <class Ask>
agent::PoshRegistry::Entry addSense(SurveyPrimitives& primitives, std::string name, std::string help, Ask ask) {
    return primitives
        .sense(std::move(name),
               [ask](const SurveyBody& body) {
                   if constexpr (std::is_invocable_v<Ask, const SurveyFlight&>)
                       return std::invoke(ask, body.flight());
                   else if constexpr (std::is_invocable_v<Ask, const Craft&>)
                       return std::invoke(ask, body.flight().craft());
                   else
                       return std::invoke(ask, body.flight().checklist());
               })
        .describe(std::move(help));
}

posh::Symbol worstRisk(const Craft& craft) {
    static constexpr std::array words{"none", "low", "high"};
    return {words[static_cast<std::size_t>(craft.threats.risk)]};
}

void addLaunchSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "ConfReceived", "The server answered for the robot's configuration.",
             &LaunchChecklist::configurationKnown);
    addSense(primitives, "GeoReceived", "The server answered for geometry and limits of sonars and range scanner.",
             &LaunchChecklist::geometryKnown);
    addSense(primitives, "SensorsReceived", "INS, every sonar and the range scanner have sent a first reading.",
             &LaunchChecklist::ready);
    addSense(primitives, "PreviewReady", "The lanes over the area are planned.", &SurveyFlight::planned);
    addSense(primitives, "LaunchReady", "Everything needed before the start is there; stays true.",
             &SurveyFlight::launched);
}

void addFlightSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "Airborne", "The scan altitude was reached, and the robot has not landed since.",
             &SurveyFlight::atWork);
    addSense(primitives, "GroundPhase", "From the choice of a landing place until the scan is resumed.",
             &SurveyFlight::landing);
    addSense(primitives, "OnGround", "The robot stands on the ground.",
             [](const SurveyFlight& flight) { return flight.phase() == Phase::Ground; });
    addSense(primitives, "SensorsSilent",
             "A sensor that the flight needs has been silent for longer than its time-out.",
             &SurveyFlight::sensorsSilent);
    addSense(primitives, "Paused", "A person asked the robot to wait.", &SurveyFlight::paused);
    addSense(primitives, "BatteryMargin",
             "Part of the battery's range that is left beyond the beeline home and the reserve; negative when it is "
             "too late.",
             &SurveyFlight::batteryMargin)
        .within(-1.0, 1.0);
    addSense(primitives, "RobotBatteryLow",
             "The robot's own battery, which nothing can charge, lasts for the way home only.",
             &SurveyFlight::robotBatteryLow);
}

void addGoalSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "ReturningHome", "The base is the present goal.", &SurveyFlight::returning);
    addSense(primitives, "AtBase", "The robot is over its base, or over the place where it is to land instead.",
             &SurveyFlight::atBase);
    addSense(primitives, "GoalReached", "The present goal of the survey is reached.",
             [](const SurveyFlight& flight) { return !flight.returning() && flight.goalReached(); });
    addSense(primitives, "ResumedGoalReached",
             "False from a recharge until a lane is flown again: running low in between means that the goal is out "
             "of reach.",
             &SurveyFlight::resumedGoalReached);
    addSense(primitives, "ScanComplete", "No goals are left, or none that can be reached.", &SurveyFlight::scanOver);
    addSense(primitives, "MissionFinished", "The last word of the mission was said.", &SurveyFlight::finished);
}

void addAvoidanceSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "SonarRisk", "The worst zone that an echo of the sonars lies in.", worstRisk)
        .oneOf({"none", "low", "high"})
        .needs("Sonar");
    addSense(primitives, "ThreatMatters", "There is a high risk, or a low one on the way to the goal.",
             &Craft::threatMatters);
    addSense(primitives, "EscapeOpen", "There is a high risk, and a way out of it.", &Craft::escapeOpen);
    addSense(primitives, "IsAvoiding", "A point beside an obstacle is being followed.", &Craft::diversionSet);
    addSense(primitives, "ClimbingOver", "The robot is on its way over an obstacle.", &Craft::climbingOver);
    addSense(primitives, "AvoidanceNeeded", "Something is in the way, or was a moment ago.", &Craft::avoiding);
    addSense(primitives, "AvoidanceTime", "Time spent avoiding since the goal came nearer.",
             [](const SurveyFlight& flight) { return flight.craft().hindered().count(); })
        .unit("s");
    addSense(primitives, "Stuck", "The goal has not come nearer for as long as the settings allow.", &Craft::stuck);
}

} // namespace

void addSurveySenses(SurveyPrimitives& primitives) {
    addLaunchSenses(primitives);
    addFlightSenses(primitives);
    addGoalSenses(primitives);
    addAvoidanceSenses(primitives);
}

} // namespace usar::airrobot
