#include <string>
#include <utility>

#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

namespace {

using agent::PoshArguments;
using posh::ActResult;

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
        const ResetState state = body.with(
            [&body](SurveyFlight& flight, agent::CommandPort& port) { return flight.stepReset(body.tick(), port); });
        return until(state == ResetState::Done || state == ResetState::Failed);
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

void addSurveyActs(SurveyPrimitives& primitives) {
    addLaunchActs(primitives);
    addFlightActs(primitives);
    addGoalActs(primitives);
    addGroundActs(primitives);
}

} // namespace usar::airrobot
