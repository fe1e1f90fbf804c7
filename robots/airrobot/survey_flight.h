// The memory of a survey and what it can do in a tick. The C++ state machine and the POSH plan both use this class, so
// they do the same things with the same code (the thesis's Context, 4.3).
#pragma once

#include "core/agent/robot_plugin.h"
#include "robots/airrobot/flight/craft.h"
#include "robots/airrobot/flight/ins_reset.h"
#include "robots/airrobot/flight/launch_checklist.h"
#include "robots/airrobot/flight/time_estimate.h"
#include "robots/airrobot/leftovers.h"
#include "robots/airrobot/sortie.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// In each tick, call `perceive` first, then the functions that were decided on (only one of them commands the robot);
/// at the end, publish `status` and `ending`. Owned by one behavior.
class SurveyFlight {
public:
    explicit SurveyFlight(agent::BehaviorContext context);
    void hear(const protocol::InfoLine& line) { craft_.hear(line.message); } ///< Call it with every line.
    void perceive(const agent::Tick& tick, agent::CommandPort& port);
    agent::BehaviorStatus status() const;
    void setParameters(const agent::ParameterSet& parameters);
    /// Remembers a pause until Resume. LandNow makes the robot land at its present place.
    void order(agent::Order order, agent::CommandPort& port);

    Phase phase() const { return phase_; }
    bool finished() const { return ending_.has_value(); }
    const std::optional<agent::BehaviorFinished>& ending() const { return ending_; } ///< nullopt while it runs
    bool paused() const { return paused_; }
    bool inTheAir() const;
    /// Whether a sensor that the flight needs has been silent for longer than the timeout.
    bool sensorsSilent() const { return silent_; }
    bool planned() const { return survey_.laneCount() > 0; } ///< the lanes are known
    /// The number of the lane that is being scanned or approached, counting from 1.
    std::size_t lane() const { return survey_.laneIndex() + 1; }
    bool launched() const { return launched_; }     ///< the launch is complete
    bool atWork() const { return sortie_.at_work; } ///< it has risen since the last landing
    /// True from the choice of a landing place until the robot takes off again.
    bool landing() const { return sortie_.landing_m.has_value(); }
    bool returning() const; ///< the base is the goal
    bool atBase() const;    ///< It is over the base, or where it is to land instead.
    bool goalReached() const;
    /// Whether no goals are left, or the survey was given up.
    bool scanOver() const { return errand_ == Errand::Done || errand_ == Errand::GivenUp; }
    /// The share of the simulated battery beyond the beeline home and the reserve; negative if it is too late.
    double batteryMargin() const;
    /// Whether the robot's own battery, which the simulator cannot charge, lasts only for the way home.
    bool robotBatteryLow() const;
    /// False from a recharge until a lane is flown. If the battery runs low in between, the lane is out of reach.
    bool resumedGoalReached() const { return had_lane_since_charge_; }
    bool charged() const; ///< it has been on the ground for as long as charging takes
    const Craft& craft() const { return craft_; }
    const LaunchChecklist& checklist() const { return checklist_; }

    // Before the start.
    LaunchState checkLaunch(const agent::Tick& tick, agent::CommandPort& port);
    void planSurvey(agent::CommandPort& port); ///< over the area; ends the flight if that fails
    void beginReset() { ins_reset_.start(craft_.senses.now); }
    /// Returns true once the INS is set or all attempts have failed.
    bool stepReset(const agent::Tick& tick, agent::CommandPort& port);
    /// Starts from the ground, after the launch or a charge, when what is left is planned anew. Forgets all places,
    /// which belong to the old estimate.
    void setOut(agent::CommandPort& port);

    // In the air.
    /// Climbs straight up to `altitude_m` over the place of the take-off; returns true when it is reached.
    bool climb(double altitude_m, agent::CommandPort& port);
    void beginWork();
    void look() { craft_.look(leg()); }                            ///< along the present leg, see Craft::look
    void decide(agent::CommandPort& port) { craft_.decide(port); } ///< about threats, see Craft::decide
    void perform(Maneuver maneuver, agent::CommandPort& port) { craft_.perform(maneuver, takeLeg(), port); }
    /// Looks, decides and performs in the usual order.
    FlightState fly(agent::CommandPort& port) { return craft_.fly(takeLeg(), port); }
    void holdPlace(agent::CommandPort& port) { craft_.hover(sortie_.hold_m, port, "paused"); }
    /// Stops where it is; ends the flight if the sensors stay silent.
    void awaitSensors(agent::CommandPort& port);

    // Goals.
    void nextGoal(agent::CommandPort& port) { afterGoal(survey_.next(craft_.settings), port); }
    void skipGoal(agent::CommandPort& port); ///< It could not be reached in time.
    void returnToCharge(agent::CommandPort& port);
    /// Ends the survey because the place to resume is out of the battery's range; returns home first.
    void abortScan(agent::CommandPort& port);
    /// Ends the survey because the robot's own battery runs low; returns home first.
    void obeyRobotBattery(agent::CommandPort& port);

    // Down.
    void beginLanding() { landAt(home_m()); } ///< at the base, or where it is to land instead
    /// Ends the survey because the way home is blocked; lands on the nearest ground that is fit for it.
    void landHere(agent::CommandPort& port);
    /// Sinks; returns true once the robot is on the ground with its rotors at rest.
    bool land(agent::CommandPort& port);
    void rest(agent::CommandPort& port, const std::string& source) { craft_.rest(port, source); }
    void recharge();
    /// Ends the survey on the ground, with success if enough of the area is scanned.
    void conclude(agent::CommandPort& port);
    /// `sensors_missing`: see agent::BehaviorFinished.
    void finish(bool success, const std::string& reason, agent::CommandPort& port,
                std::vector<std::string> sensors_missing = {});

private:
    void showPlan(agent::CommandPort& port) const; ///< on the map, with the flights home
    void replan(agent::CommandPort& port);
    void putFloor(); ///< chooses the floor level if nobody has set one
    void chooseFloor(agent::CommandPort& port);
    void riseBeyondDoor();
    bool doubtsMap(const ReachablePlaces& reach);
    Leg leg() const;
    Leg takeLeg();
    void noteSilence(agent::CommandPort& port);
    void noteCeiling(agent::CommandPort& port);
    void shiftLanes();
    void afterGoal(SurveyEvent event, agent::CommandPort& port);
    void goHome(Errand errand, const std::string& why, agent::CommandPort& port);
    void landAt(const Vec2& near_m);
    void landElsewhere(agent::CommandPort& port);            ///< This place is no good; hovers where there is no other.
    bool landNearby(double dry_m, agent::CommandPort& port); ///< at the nearest fit place; false if none is known
    void headFor(const Vec2& place_m, agent::CommandPort& port); ///< to land there instead of at the base
    Vec2 home_m() const { return sortie_.refuge_m.value_or(base_in_map_.position_m.head<2>()); }
    std::optional<Vec2> door_m() const { return sortie_.refuge_m ? std::nullopt : leftovers_.door_m(); }
    void endPause(const std::string& why, agent::CommandPort& port);
    double beelineHome_m() const { return (craft_.senses.position_m() - base_in_map_.position_m).norm(); }
    std::string words() const;
    MissionState missionState();

    agent::Task task_;
    Craft craft_;
    LaunchChecklist checklist_;
    InsReset ins_reset_;
    Survey survey_;
    TimeEstimate time_;
    Phase phase_ = Phase::Launch;
    Errand errand_ = Errand::Start;
    std::string end_reason_;
    ScanLedger ledger_;
    Leftovers leftovers_;
    std::optional<agent::BehaviorFinished> ending_;
    bool paused_ = false;
    bool silent_ = false;
    bool launched_ = false;
    bool had_lane_since_charge_ = true;
    Pose base_in_map_; ///< place of the first take-off: the start pose, or beside it if another robot was there
    Sortie sortie_;
    bool chooses_floor_ = false;     ///< nobody has set a floor level
    double start_z_m_ = 0.0;         ///< map z of the first take-off; before it, of the start pose
    std::optional<Seconds> started_; ///< time of the first tick
    std::optional<double> goal_distance_m_;
};

} // namespace usar::airrobot
