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

/// Registers an act that takes no time, so that the cycle continues.
template <class Do>
void addNote(SurveyPrimitives& primitives, std::string name, std::string help, Do act) {
    primitives
        .act(std::move(name),
             [act](SurveyBody& body) {
                 body.with(act);
                 return ActResult::Finished;
             })
        .describe(std::move(help));
}

/// Registers an act that commands the robot for one tick and is complete after the cycle.
template <class Do>
void addStep(SurveyPrimitives& primitives, std::string name, std::string help, Do act) {
    primitives.act(std::move(name), [act](SurveyBody& body) { body.with(act); }).describe(std::move(help));
}

/// The result of an act that runs in each cycle until it is done.
ActResult until(bool done) {
    return done ? ActResult::RunningOnce : ActResult::Running;
}

/// Registers an act that steps the launch checklist until `known(checklist)` holds.
template <class Known>
void addQuery(SurveyPrimitives& primitives, std::string name, std::string help, Known known) {
    primitives
        .act(std::move(name),
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
    ActResult run(SurveyBody& body, const PoshArguments&) { return until(body.with(&SurveyFlight::land)); }
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

void addLaunchActs(SurveyPrimitives& primitives) {
    addQuery(primitives, "QueryRobotConf", "Asks the server for the robot's configuration.",
             &LaunchChecklist::configurationKnown);
    addQuery(primitives, "QuerySonarGeo", "Asks the server for geometry and limits of sonars and range scanner.",
             &LaunchChecklist::geometryKnown);
    addQuery(primitives, "WaitForSensors", "Waits for a first reading of INS, sonars and range scanner.",
             &LaunchChecklist::ready);
    addNote(primitives, "InitPreview", "Plans the lanes over the area.", &SurveyFlight::planSurvey);
    primitives.act<ResetIns>("ResetIns").describe("Rests, then sets the INS from ground truth.");
    primitives.act("MarkLaunchReady", markLaunchReady)
        .describe("Notes that the launch is complete; waits while the robot is paused.");
}

void addFlightActs(SurveyPrimitives& primitives) {
    primitives.act("ClimbTo", climbTo)
        .describe("Climbs straight up.")
        .takes(agent::PoshParameter::number("altitude", 0.0, "m", 0.0, 30.0,
                                            "Above where it stood; 0 for the scan altitude of the mission."));
    addNote(primitives, "MarkAirborne", "Notes that the scan altitude is reached.", &SurveyFlight::beginWork);
    const auto cruise = [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::Cruise, port); };
    const auto avoid = [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::Avoid, port); };
    addStep(primitives, "FlyToGoal", "Flies toward the present goal of the survey.", cruise);
    addStep(primitives, "FlyToBase", "Flies toward the base.", cruise);
    addStep(primitives, "KeepCourse", "Goes on as if nothing were in the way.", cruise);
    addStep(primitives, "EvadeOpposite", "A sudden move away from the greatest threat.", avoid);
    addNote(primitives, "PlotDiversion",
            "Chooses the greatest threat, sums the sonars to its left and right, and sets a point on the freer side.",
            &SurveyFlight::decide);
    addStep(primitives, "FollowDiversion", "Flies to the point set, or waits where there is no way.", avoid);
    addStep(primitives, "ClimbOver", "Backs away from the obstacle, climbs until the way is free, and crosses.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.perform(Maneuver::ClimbOver, port); });
    addStep(primitives, "HoldPlace", "Waits where it was when it was paused.", &SurveyFlight::holdPlace);
    addStep(primitives, "WaitForData", "Stops, and gives up when a sensor stays silent for 15 s.",
            &SurveyFlight::awaitSensors);
    addStep(primitives, "Hover", "Stops for a cycle.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.rest(port, "hovering"); });
}

void addGoalActs(SurveyPrimitives& primitives) {
    addNote(primitives, "NextGoal", "Takes the next goal: along the lane, the next lane or quadrant, or home.",
            &SurveyFlight::nextGoal);
    addNote(primitives, "SkipGoal", "Declares the goal unreachable and takes the next.", &SurveyFlight::skipGoal);
    const auto return_home = &SurveyFlight::returnToCharge;
    addNote(primitives, "StoreGoalAndReturn", "Remembers where the lane was left, and makes the base the goal.",
            return_home);
    addNote(primitives, "StoreOuterGoalAndReturn",
            "The same during a diversion, which is forgotten; the lane is the next goal after it.", return_home);
    addNote(primitives, "AbortScan", "No more goals; the base is the goal, and the scan ends there.",
            &SurveyFlight::abortScan);
    addNote(primitives, "GiveUpAndReturn", "The robot's own battery runs out: home, and the scan ends there.",
            &SurveyFlight::obeyRobotBattery);
    addNote(primitives, "LandHere", "The way home is blocked: the robot lands where it is, and the scan ends there.",
            &SurveyFlight::landHere);
}

void addGroundActs(SurveyPrimitives& primitives) {
    primitives.act<LandAtBase>("LandAtBase")
        .describe("Sinks onto a free place at the base until it touches the ground.");
    primitives
        .act("HoldOnGround",
             [](SurveyBody& body) {
                 return until(body.with([](SurveyFlight& flight) { return flight.charged() && !flight.paused(); }));
             })
        .describe("Stands for as long as charging takes, and while the robot is paused.");
    addNote(primitives, "Recharge", "Fills the simulated battery.", &SurveyFlight::recharge);
    addNote(primitives, "ResumeScan", "Takes the lane up where it was left, and allows the start.",
            &SurveyFlight::setOut);
    addNote(primitives, "StopRotors", "Zero DRIVE.",
            [](SurveyFlight& flight, agent::CommandPort& port) { flight.rest(port, "rotors off"); });
    addNote(primitives, "MarkFinished", "Says how the scan ended; its files are written then.",
            &SurveyFlight::conclude);
}

} // namespace

agent::PoshRegistry surveyPrimitives() {
    return agent::registryOf<SurveyBody>({addLaunchSenses, addFlightSenses, addGoalSenses, addAvoidanceSenses,
                                          addLaunchActs, addFlightActs, addGoalActs, addGroundActs});
}

} // namespace usar::airrobot
