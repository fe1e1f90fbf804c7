#include <string>
#include <utility>

#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

namespace {

/// Registers a sense that answers `ask(flight)`.
template <class Ask>
agent::PoshRegistry::Entry addSense(SurveyPrimitives& primitives, std::string name, std::string help, Ask ask) {
    return primitives.sense(std::move(name), [ask](const SurveyBody& body) { return ask(body.flight()); })
        .describe(std::move(help));
}

posh::Symbol worstRisk(const SurveyFlight& flight) {
    switch (flight.craft().threats.risk) {
    case agent::Risk::None:
        break;
    case agent::Risk::Low:
        return {"low"};
    case agent::Risk::High:
        return {"high"};
    }
    return {"none"};
}

void addLaunchSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "ConfReceived", "The server answered for the robot's configuration.",
             [](const SurveyFlight& flight) { return flight.checklist().configurationKnown(); });
    addSense(primitives, "GeoReceived", "The server answered for geometry and limits of sonars and range scanner.",
             [](const SurveyFlight& flight) { return flight.checklist().geometryKnown(); });
    addSense(primitives, "SensorsReceived", "INS, every sonar and the range scanner have sent a first reading.",
             [](const SurveyFlight& flight) { return flight.checklist().ready(); });
    addSense(primitives, "PreviewReady", "The lanes over the area are planned.",
             [](const SurveyFlight& flight) { return flight.planned(); });
    addSense(primitives, "LaunchReady", "Everything needed before the start is there; stays true.",
             [](const SurveyFlight& flight) { return flight.launched(); });
}

void addFlightSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "Airborne", "The scan altitude was reached, and the robot has not landed since.",
             [](const SurveyFlight& flight) { return flight.atWork(); });
    addSense(primitives, "GroundPhase", "From the choice of a landing place until the scan is resumed.",
             [](const SurveyFlight& flight) { return flight.landing(); });
    addSense(primitives, "OnGround", "The robot stands on the ground.",
             [](const SurveyFlight& flight) { return flight.phase() == Phase::Ground; });
    addSense(primitives, "SensorsSilent",
             "A sensor that the flight needs has been silent for longer than its time-out.",
             [](const SurveyFlight& flight) { return flight.sensorsSilent(); });
    addSense(primitives, "Paused", "A person asked the robot to wait.",
             [](const SurveyFlight& flight) { return flight.paused(); });
    addSense(primitives, "BatteryMargin",
             "Part of the battery's range that is left beyond the beeline home and the reserve; negative when it is "
             "too late.",
             [](const SurveyFlight& flight) { return flight.batteryMargin(); })
        .within(-1.0, 1.0);
    addSense(primitives, "RobotBatteryLow",
             "The robot's own battery, which nothing can charge, lasts for the way home only.",
             [](const SurveyFlight& flight) { return flight.robotBatteryLow(); });
}

void addGoalSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "ReturningHome", "The base is the present goal.",
             [](const SurveyFlight& flight) { return flight.returning(); });
    addSense(primitives, "AtBase", "The robot is over its base, or over the place where it is to land instead.",
             [](const SurveyFlight& flight) { return flight.atBase(); });
    addSense(primitives, "GoalReached", "The present goal of the survey is reached.",
             [](const SurveyFlight& flight) { return !flight.returning() && flight.goalReached(); });
    addSense(primitives, "ResumedGoalReached",
             "False from a recharge until a lane is flown again: running low in between means that the goal is out "
             "of reach.",
             [](const SurveyFlight& flight) { return flight.resumedGoalReached(); });
    addSense(primitives, "ScanComplete", "No goals are left, or none that can be reached.",
             [](const SurveyFlight& flight) { return flight.scanOver(); });
    addSense(primitives, "MissionFinished", "The last word of the mission was said.",
             [](const SurveyFlight& flight) { return flight.finished(); });
}

void addAvoidanceSenses(SurveyPrimitives& primitives) {
    addSense(primitives, "SonarRisk", "The worst zone that an echo of the sonars lies in.",
             [](const SurveyFlight& flight) { return worstRisk(flight); })
        .oneOf({"none", "low", "high"})
        .needs("Sonar");
    addSense(primitives, "ThreatMatters", "There is a high risk, or a low one on the way to the goal.",
             [](const SurveyFlight& flight) { return flight.craft().threatMatters(); });
    addSense(primitives, "EscapeOpen", "There is a high risk, and a way out of it.",
             [](const SurveyFlight& flight) { return flight.craft().escapeOpen(); });
    addSense(primitives, "IsAvoiding", "A point beside an obstacle is being followed.",
             [](const SurveyFlight& flight) { return flight.craft().diversionSet(); });
    addSense(primitives, "ClimbingOver", "The robot is on its way over an obstacle.",
             [](const SurveyFlight& flight) { return flight.craft().climbingOver(); });
    addSense(primitives, "AvoidanceNeeded", "Something is in the way, or was a moment ago.",
             [](const SurveyFlight& flight) { return flight.craft().avoiding(); });
    addSense(primitives, "AvoidanceTime", "Time spent avoiding since the goal came nearer.",
             [](const SurveyFlight& flight) { return flight.craft().hindered().count(); })
        .unit("s");
    addSense(primitives, "Stuck", "The goal has not come nearer for as long as the settings allow.",
             [](const SurveyFlight& flight) { return flight.craft().stuck(); });
}

} // namespace

void addSurveySenses(SurveyPrimitives& primitives) {
    addLaunchSenses(primitives);
    addFlightSenses(primitives);
    addGoalSenses(primitives);
    addAvoidanceSenses(primitives);
}

} // namespace usar::airrobot
