#include <array>
#include <functional>
#include <string>
#include <utility>

#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

namespace {

using agent::PoshArguments;
using posh::ActResult;
using SurveyPrimitives = agent::PoshPrimitives<SurveyBody>;

/// Registers a sense that answers `ask` about the flight, its craft or its launch checklist.
template <class Ask>
agent::PoshRegistry::Entry addSense(SurveyPrimitives& list, std::string name, std::string help, Ask ask) {
    return list
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

void addLaunchSenses(SurveyPrimitives& list) {
    addSense(list, "ConfReceived", "The question for the robot's configuration has been answered or given up.",
             &LaunchChecklist::configurationKnown);
    addSense(list, "GeoReceived", "The questions for the sonars and the range scanner have been answered or given up.",
             &LaunchChecklist::geometryKnown);
    addSense(list, "SensorsReceived", "The INS, every sonar and the range scanner have sent a first reading.",
             &LaunchChecklist::ready);
    addSense(list, "PreviewReady", "The lanes over the area are planned.", &SurveyFlight::planned);
    addSense(list, "LaunchReady", "Everything needed before the start is ready. Stays true from then on.",
             &SurveyFlight::launched);
}

void addFlightSenses(SurveyPrimitives& list) {
    addSense(list, "Airborne", "The robot has reached the scan altitude and has not landed since.",
             &SurveyFlight::atWork);
    addSense(list, "GroundPhase", "True from the choice of a landing place until the scan is resumed.",
             &SurveyFlight::landing);
    addSense(list, "OnGround", "The robot stands on the ground.",
             [](const SurveyFlight& flight) { return flight.phase() == Phase::Ground; });
    addSense(list, "SensorsSilent", "A sensor that the flight needs has been silent for longer than the time-out.",
             &SurveyFlight::sensorsSilent);
    addSense(list, "Paused", "A person asked the robot to wait.", &SurveyFlight::paused);
    addSense(list, "BatteryMargin",
             "Share of the battery's range that is left beyond the beeline home and the reserve. Negative: too late.",
             &SurveyFlight::batteryMargin)
        .within(-1.0, 1.0);
    addSense(list, "RobotBatteryLow", "The robot's own battery, which cannot be charged, lasts only for the way home.",
             &SurveyFlight::robotBatteryLow);
}

void addGoalSenses(SurveyPrimitives& list) {
    addSense(list, "ReturningHome", "The robot is on its way to its base.", &SurveyFlight::returning);
    addSense(list, "AtBase", "The robot is over its base, or over the place where it is to land instead.",
             &SurveyFlight::atBase);
    addSense(list, "GoalReached", "The present goal of the survey is reached.",
             [](const SurveyFlight& flight) { return !flight.returning() && flight.goalReached(); });
    addSense(list, "ResumedGoalReached",
             "False from a recharge until the robot is on a lane again. If the battery runs low in between, the goal "
             "is out of reach.",
             &SurveyFlight::resumedGoalReached);
    addSense(list, "ScanComplete", "No goals are left, or the scan was given up.", &SurveyFlight::scanOver);
    addSense(list, "MissionFinished", "The mission has ended.", &SurveyFlight::finished);
}

void addAvoidanceSenses(SurveyPrimitives& list) {
    addSense(list, "SonarRisk",
             "The highest risk that any sonar reports; none beside a way that the robot knows and flies slowly.",
             worstRisk)
        .oneOf({"none", "low", "high"})
        .needs("Sonar");
    addSense(list, "ThreatMatters", "There is a high risk, or a low risk on the way to the goal.",
             &Craft::threatMatters);
    addSense(list, "EscapeOpen", "There is a high risk and a way to escape it.", &Craft::escapeOpen);
    addSense(list, "IsAvoiding", "The robot is flying around an obstacle by way of a diversion point.",
             &Craft::diversionSet);
    addSense(list, "ClimbingOver", "The robot is climbing over an obstacle.", &Craft::climbingOver);
    addSense(list, "AvoidanceNeeded", "An obstacle is in the way or was a moment ago.", &Craft::avoiding);
    addSense(list, "AvoidanceTime", "Time spent avoiding obstacles since the last progress toward the goal.",
             [](const SurveyFlight& flight) { return flight.craft().hindered().count(); })
        .unit("s");
    addSense(list, "Stuck", "The robot has made no progress toward its goal for longer than the settings allow.",
             &Craft::stuck);
}

/// Registers an act that takes no time, so that the cycle continues.
template <class Do>
void addNote(SurveyPrimitives& list, std::string name, std::string help, Do act) {
    list.act(std::move(name),
             [act](SurveyBody& body) {
                 body.with(act);
                 return ActResult::Finished;
             })
        .describe(std::move(help));
}

/// Registers an act that commands the robot for one tick and is complete after the cycle.
template <class Do>
void addStep(SurveyPrimitives& list, std::string name, std::string help, Do act) {
    list.act(std::move(name), [act](SurveyBody& body) { body.with(act); }).describe(std::move(help));
}

/// The result of an act that runs in each cycle until it is done.
ActResult until(bool done) {
    return done ? ActResult::RunningOnce : ActResult::Running;
}

/// Registers an act that steps the launch checklist until `known(checklist)` holds.
template <class Known>
void addQuery(SurveyPrimitives& list, std::string name, std::string help, Known known) {
    list.act(std::move(name),
             [known](SurveyBody& body) {
                 const LaunchState state = body.with([&body](SurveyFlight& flight, agent::CommandPort& port) {
                     return flight.checkLaunch(body.tick(), port);
                 });
                 if (state == LaunchState::Failed)
                     return ActResult::Failed;
                 return std::invoke(known, body.flight().checklist()) ? ActResult::Finished : ActResult::Running;
             })
        .describe(std::move(help));
}

class ResetIns {
public:
    void init(SurveyBody& body, const PoshArguments&) { body.with(&SurveyFlight::beginReset); }
    ActResult run(SurveyBody& body, const PoshArguments&) {
        return until(body.with(
            [&body](SurveyFlight& flight, agent::CommandPort& port) { return flight.stepReset(body.tick(), port); }));
    }
};

class LandAtBase {
public:
    void init(SurveyBody& body, const PoshArguments&) {
        body.with([](SurveyFlight& flight, agent::CommandPort&) {
            if (!flight.landing())
                flight.beginLanding();
        });
    }
    ActResult run(SurveyBody& body, const PoshArguments&) {
        const bool down = body.with(&SurveyFlight::land);
        return body.flight().landing() ? until(down) : ActResult::Failed; // It has to fly to another place first.
    }
};

ActResult climbTo(SurveyBody& body, const PoshArguments& arguments) {
    const double asked_m = arguments.real("altitude");
    const double altitude_m = asked_m > 0.0 ? asked_m : body.flight().craft().settings.scan_altitude_m;
    return until(body.with(
        [altitude_m](SurveyFlight& flight, agent::CommandPort& port) { return flight.climb(altitude_m, port); }));
}

ActResult markLaunchReady(SurveyBody& body) {
    if (body.flight().paused())
        return ActResult::Running;
    body.with(&SurveyFlight::setOut);
    return ActResult::Finished;
}

void addLaunchActs(SurveyPrimitives& list) {
    addQuery(list, "QueryRobotConf", "Asks the server for the robot's configuration.",
             &LaunchChecklist::configurationKnown);
    addQuery(list, "QuerySonarGeo", "Asks the server for the geometry and limits of the sonars and the range scanner.",
             &LaunchChecklist::geometryKnown);
    addQuery(list, "WaitForSensors", "Waits for a first reading of the INS, every sonar and the range scanner.",
             &LaunchChecklist::ready);
    addNote(list, "InitPreview", "Plans the lanes over the area.", &SurveyFlight::planSurvey);
    list.act<ResetIns>("ResetIns").describe("Rests, then sets the INS from ground truth.");
    list.act("MarkLaunchReady", markLaunchReady)
        .describe("Notes that the launch is complete. Waits while the robot is paused.");
}

void addFlightActs(SurveyPrimitives& list) {
    list.act("ClimbTo", climbTo)
        .describe("Climbs straight up to an altitude.")
        .takes(agent::PoshParameter::number(
            "altitude", 0.0, "m", 0.0, 30.0,
            "Height above the place of the take-off. 0 means the scan altitude in the parameters."));
    addNote(list, "MarkAirborne", "Notes that the robot has reached the scan altitude.", &SurveyFlight::beginWork);
    const auto cruise = [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::Cruise, port); };
    const auto avoid = [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::Avoid, port); };
    addStep(list, "FlyToGoal", "Flies toward the present goal of the survey.", cruise);
    addStep(list, "FlyToBase", "Flies toward the base.", cruise);
    addStep(list, "KeepCourse", "Flies on as if nothing were in the way.", cruise);
    addStep(list, "EvadeOpposite", "Moves away from the greatest threat, suddenly at first.", avoid);
    addNote(list, "PlotDiversion",
            "Finds the greatest threat, compares the sonars to its left and right, and sets a diversion point on the "
            "freer side.",
            &SurveyFlight::decide);
    addStep(list, "FollowDiversion", "Flies to the diversion point, or waits if there is no way.", avoid);
    addStep(list, "ClimbOver", "Backs away from the obstacle, climbs until the way is free, and flies across.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::ClimbOver, port); });
    addStep(list, "HoldPlace", "Holds the place where the robot was when it was paused.", &SurveyFlight::holdPlace);
    addStep(list, "WaitForData", "Stops, and ends the mission if a sensor stays silent for 15 s.",
            &SurveyFlight::awaitSensors);
    addStep(list, "Hover", "Commands zero speed for one cycle.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.rest(port, "hovering"); });
}

void addGoalActs(SurveyPrimitives& list) {
    addNote(list, "NextGoal",
            "Moves on to the next goal: on the lane, on the next lane or in the next quadrant, or home.",
            &SurveyFlight::nextGoal);
    addNote(list, "SkipGoal", "Gives up the present goal and moves on to the next one.", &SurveyFlight::skipGoal);
    const auto return_home = &SurveyFlight::returnToCharge;
    addNote(list, "StoreGoalAndReturn", "Remembers where the robot leaves the lane, and makes the base the goal.",
            return_home);
    addNote(list, "StoreOuterGoalAndReturn",
            "Does the same during a diversion, which is forgotten. After the charge, the lane is the goal again.",
            return_home);
    addNote(list, "AbortScan",
            "Gives up the scan because its next place is out of the battery's range, and makes the base the goal.",
            &SurveyFlight::abortScan);
    addNote(list, "GiveUpAndReturn",
            "Gives up the scan because the robot's own battery runs low, and makes the base the goal.",
            &SurveyFlight::obeyRobotBattery);
    addNote(
        list, "LandHere",
        "Looks for a way home again, then goes back as it came. If both fail, it gives up the scan and lands nearby.",
        &SurveyFlight::landHere);
}

void addGroundActs(SurveyPrimitives& list) {
    list.act<LandAtBase>("LandAtBase").describe("Sinks onto level ground at the base until the robot touches down.");
    list.act("HoldOnGround",
             [](SurveyBody& body) {
                 return until(body.with([](SurveyFlight& flight) { return flight.charged() && !flight.paused(); }));
             })
        .describe("Stays on the ground for as long as a charge takes, and while the robot is paused.");
    addNote(list, "Recharge", "Fills the simulated battery.", &SurveyFlight::recharge);
    addNote(list, "ResumeScan", "Allows the start; the robot resumes the lane where it left it.",
            &SurveyFlight::setOut);
    addNote(list, "StopRotors", "Commands zero speed, which stops the rotors on the ground.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.rest(port, "rotors off"); });
    addNote(list, "MarkFinished", "Ends the mission and reports how the scan went.", &SurveyFlight::conclude);
}

} // namespace

agent::PoshRegistry surveyPrimitives() {
    return agent::registryOf<SurveyBody>({addLaunchSenses, addFlightSenses, addGoalSenses, addAvoidanceSenses,
                                          addLaunchActs, addFlightActs, addGoalActs, addGroundActs});
}

} // namespace usar::airrobot
