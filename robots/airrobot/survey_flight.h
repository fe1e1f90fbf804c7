// What a survey remembers, and what it can do in a tick. Who decides stands on it: the state machine in C++ and the
// POSH plan do the same things by the same code (the thesis's Context, 4.3).
#pragma once

#include <optional>
#include <string>

#include "core/agent/robot_plugin.h"
#include "robots/airrobot/craft.h"
#include "robots/airrobot/ins_reset.h"
#include "robots/airrobot/launch_checklist.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// What the robot is doing; acts set it.
enum class Phase { Launch, TakeOff, ToLane, Lane, Home, Landing, Ground, Finished };

/// Owned by one behavior. Each tick: `perceive`, then the acts that were decided on (one of them commands the robot),
/// and at its end `status` and `ending` are to be published.
class SurveyFlight {
public:
    explicit SurveyFlight(agent::BehaviorContext context);

    void perceive(const agent::Tick& tick, agent::CommandPort& port);
    agent::BehaviorStatus status() const;
    void setParameters(const agent::ParameterSet& parameters);
    /// Pause and resume are remembered; for LandNow the place to land is here.
    void order(agent::Order order, agent::CommandPort& port);

    Phase phase() const { return phase_; }
    bool finished() const { return ending_.has_value(); }
    /// The last word.
    const std::optional<agent::BehaviorFinished>& ending() const { return ending_; }
    bool paused() const { return paused_; }
    bool inTheAir() const;
    /// A sensor that the flight needs has been silent for longer than its time-out.
    bool sensorsSilent() const { return silent_; }
    /// The lanes are known.
    bool planned() const { return survey_.laneCount() > 0; }
    /// The one that is being scanned or flown to, from 1.
    std::size_t lane() const { return survey_.laneIndex() + 1; }
    /// It has left the launch behind.
    bool launched() const { return launched_; }
    /// The scan altitude was reached, and it has not landed since.
    bool atWork() const { return at_work_; }
    /// From the choice of a landing place until it goes on.
    bool landing() const { return landing_m_.has_value(); }
    /// The base is the goal.
    bool returning() const;
    /// Over the base, or where it is to land instead.
    bool atBase() const;
    bool goalReached() const { return survey_.goalReached(craft_.senses.position2_m(), craft_.settings); }
    /// No goals are left, or none that could be reached.
    bool scanOver() const { return errand_ == Errand::Done || errand_ == Errand::GivenUp; }
    /// Part of the simulated capacity that is left beyond the beeline home and the reserve; negative: too late.
    double batteryMargin() const;
    /// The robot's own battery lasts for the way home only; the simulator cannot charge it.
    bool robotBatteryLow() const;
    /// False from a recharge until a lane is flown: running low in between means that the place is out of reach.
    bool resumedGoalReached() const { return had_lane_since_charge_; }
    /// On the ground for as long as charging takes.
    bool charged() const;
    const Craft& craft() const { return craft_; }
    const LaunchChecklist& checklist() const { return checklist_; }

    // Before the start.
    LaunchState checkLaunch(const agent::Tick& tick, agent::CommandPort& port);
    /// The lanes over the area; ends the flight where there are none.
    void planSurvey(agent::CommandPort& port);
    void beginReset();
    ResetState stepReset(const agent::Tick& tick, agent::CommandPort& port);
    /// From the ground, after the launch or a charge: everything known of places belongs to the old estimate.
    void setOut();

    // In the air.
    /// Straight up to `altitude_m` over where it stood; true when it is reached.
    bool climb(double altitude_m, agent::CommandPort& port);
    void beginWork();
    /// Looks along the present leg, for `Craft`'s judgment of threats and for `perform`.
    void look() { craft_.look(leg()); }
    /// Decides about the threats looked at; see Craft.
    void decide(agent::CommandPort& port) { craft_.decide(port); }
    void perform(Maneuver maneuver, agent::CommandPort& port) { craft_.perform(maneuver, takeLeg(), port); }
    /// Looks, decides and performs in the usual order.
    FlightState fly(agent::CommandPort& port) { return craft_.fly(takeLeg(), port); }
    void holdPlace(agent::CommandPort& port);
    /// Zero DRIVE; ends the flight when the silence lasts.
    void awaitSensors(agent::CommandPort& port);

    // Goals.
    void nextGoal(agent::CommandPort& port);
    /// The goal could not be reached in time.
    void skipGoal(agent::CommandPort& port);
    void returnToCharge(agent::CommandPort& port);
    /// The place to resume at is out of the battery's range.
    void abortScan(agent::CommandPort& port);
    void obeyRobotBattery(agent::CommandPort& port);

    // Down.
    void beginLanding();
    /// The way home is blocked.
    void landHere(agent::CommandPort& port);
    /// True on the ground, with the rotors at rest.
    bool land(agent::CommandPort& port);
    void rest(agent::CommandPort& port, const std::string& source) { craft_.rest(port, source); }
    void recharge();
    /// The errand's end on the ground.
    void conclude(agent::CommandPort& port);
    void finish(bool success, const std::string& reason, agent::CommandPort& port);

private:
    /// Why the robot is on the ground, or on its way there; decides what follows.
    enum class Errand { Start, Recharge, Quadrant, Done, GivenUp };

    Leg leg() const;
    Leg takeLeg();
    void noteSilence(agent::CommandPort& port);
    void afterGoal(SurveyEvent event, agent::CommandPort& port);
    void goHome(Errand errand, const std::string& why, agent::CommandPort& port);
    void landAt(const Vec2& near_m);
    void endPause(const std::string& why, agent::CommandPort& port);
    void onResetEnded(ResetState reset, agent::CommandPort& port) const;
    void markRecharge(agent::CommandPort& port) const;
    double beelineHome_m() const;
    std::string words() const;
    std::optional<Seconds> timeLeft() const;
    double progress_pct() const;

    agent::Task task_;
    Craft craft_;
    LaunchChecklist checklist_;
    InsReset ins_reset_;
    Survey survey_;

    Phase phase_ = Phase::Launch;
    Errand errand_ = Errand::Start;
    std::string end_reason_;
    std::optional<agent::BehaviorFinished> ending_;
    bool paused_ = false;
    bool silent_ = false;
    bool launched_ = false;
    bool at_work_ = false;
    bool had_lane_since_charge_ = true;
    Pose base_in_map_; ///< where it took off first: the start pose, or beside it where another robot had its place
    Vec2 hold_m_ = Vec2::Zero();
    std::optional<Vec2> landing_m_;
    std::optional<Vec3> take_off_m_;
    std::optional<Seconds> started_;
    Seconds landed_{0.0};
    std::optional<double> goal_distance_m_;
};

} // namespace usar::airrobot
