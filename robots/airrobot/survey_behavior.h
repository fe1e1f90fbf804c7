// "airrobot/cpp": the terrain survey of the thesis's chapter 4 as a state machine over the craft's acts.
#pragma once

#include <string>

#include "core/agent/robot_plugin.h"
#include "robots/airrobot/craft.h"
#include "robots/airrobot/ins_reset.h"
#include "robots/airrobot/launch_checklist.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

enum class Phase { Launch, TakeOff, ToLane, Lane, Home, Landing, Ground, Finished };

/// Launch checklist, INS reset (which also gives the INS the rest that it needs to start), take-off, lanes, home for a
/// charge, after each quadrant and at the end; INS reset and recharge on the ground; resume where it stopped. Judges at
/// every tick, first to last as in the thesis's drive collection: silent sensors, battery, stuck, sonars, goal.
class SurveyBehavior : public agent::Behavior {
public:
    explicit SurveyBehavior(agent::BehaviorContext context);

    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override;
    protocol::Command safeCommand() const override;

    Phase phase() const { return phase_; }

private:
    /// Why the robot is on the ground, or on its way there; decides what follows.
    enum class Errand { Start, Recharge, Quadrant, Done, GivenUp };

    void launch(const agent::Tick& tick, agent::CommandPort& port);
    void planSurvey(agent::CommandPort& port);
    void act(const agent::Tick& tick, agent::CommandPort& port);
    void takeOff(agent::CommandPort& port);
    void survey(agent::CommandPort& port);
    void onSurveyEvent(SurveyEvent event, agent::CommandPort& port);
    void flyHome(agent::CommandPort& port);
    void land(agent::CommandPort& port);
    void onGround(const agent::Tick& tick, agent::CommandPort& port);
    void onResetEnded(ResetState reset, agent::CommandPort& port);
    void goHome(Errand errand, const std::string& why, agent::CommandPort& port);
    /// The errand's end on the ground.
    void conclude(agent::CommandPort& port);
    void beginLanding(const Vec2& near_m);
    void finish(bool success, const std::string& reason, agent::CommandPort& port);

    bool sensorsSpeak(agent::CommandPort& port);
    void watchBattery(agent::CommandPort& port);
    void watchRobotBattery(agent::CommandPort& port);
    void endPause(const std::string& why, agent::CommandPort& port);
    double beelineHome_m() const;
    bool airborne() const;
    void publishStatus(const agent::Tick& tick, agent::CommandPort& port) const;
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
    bool paused_ = false;
    bool silent_ = false;
    bool had_lane_since_charge_ = true;
    Pose base_in_map_; ///< where it took off first: the start pose, or beside it where another robot had its place
    Vec2 hold_m_ = Vec2::Zero();
    Vec2 landing_m_ = Vec2::Zero();
    std::optional<Vec3> take_off_m_;
    std::optional<Seconds> started_;
    Seconds phase_since_{0.0};
    std::optional<double> goal_distance_m_;
};

} // namespace usar::airrobot
