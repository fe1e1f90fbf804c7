#include "robots/airrobot/survey_behavior.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::airrobot {

namespace {

constexpr double over_base_m = 0.8;
constexpr Seconds lost_after{15.0};
/// A robot that stands this far from its start pose was put there, as the place was taken; farther away it was flown.
constexpr double beside_start_m = 1.0;
constexpr double away_from_start_m = 6.0;

/// "sonars" for all of them, else "sonar L4" or "sonars L4, L3".
std::string silentSonars(const Senses& senses) {
    if (senses.sonars.empty())
        return "sonars";
    std::string names;
    for (const std::string& name : senses.silent_sonars)
        names += (names.empty() ? " " : ", ") + name;
    return (senses.silent_sonars.size() == 1 ? "sonar" : "sonars") + names;
}

} // namespace

SurveyBehavior::SurveyBehavior(agent::BehaviorContext context)
    : task_(std::move(context.task))
    , base_in_map_(task_.start_in_map) {
    craft_.settings = settingsFrom(context.parameters);
}

void SurveyBehavior::setParameters(const agent::ParameterSet& parameters) {
    craft_.settings = settingsFrom(parameters);
}

protocol::Command SurveyBehavior::safeCommand() const {
    return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0};
}

bool SurveyBehavior::airborne() const {
    return phase_ != Phase::Launch && phase_ != Phase::Ground && phase_ != Phase::Finished;
}

double SurveyBehavior::beelineHome_m() const {
    return (craft_.senses.position_m() - base_in_map_.position_m).norm();
}

void SurveyBehavior::tick(const agent::Tick& tick, agent::CommandPort& port) {
    if (phase_ == Phase::Finished)
        return;
    if (!started_)
        started_ = tick.now;
    craft_.perceive(tick, checklist_.layout(), airborne(), port);
    goal_distance_m_.reset();
    if (phase_ == Phase::Launch)
        launch(tick, port);
    else if (sensorsSpeak(port))
        act(tick, port);
    publishStatus(tick, port);
}

void SurveyBehavior::launch(const agent::Tick& tick, agent::CommandPort& port) {
    const LaunchState state = checklist_.step(tick.now, tick.robot, port);
    if (state == LaunchState::Failed)
        return finish(false, checklist_.words() + ".", port);
    if (state == LaunchState::Ready)
        planSurvey(port);
}

void SurveyBehavior::planSurvey(agent::CommandPort& port) {
    const Vec2 base_m = task_.start_in_map.position_m.head<2>();
    const Settings& settings = craft_.settings;
    const auto plan =
        mapping::planCoverage(task_.area_in_map, base_m, {settings.lane_spacing_m, settings.quadrant_limit_m});
    if (!plan)
        return finish(false, plan.error().text(), port);
    survey_ = Survey(*plan);
    port.publish(agent::PlannedPath{survey_.corners_m()});
    phase_ = Phase::Ground;
    ins_reset_.start(craft_.senses.now);
}

bool SurveyBehavior::sensorsSpeak(agent::CommandPort& port) {
    const Senses& senses = craft_.senses;
    const Seconds worst = std::max({senses.ins_age, senses.sonar_age, senses.scan_age});
    const bool silent = worst > Seconds(craft_.settings.sensor_timeout_s);
    if (silent && !silent_) {
        const std::string which = worst == senses.ins_age     ? "INS"
                                  : worst == senses.sonar_age ? silentSonars(senses)
                                                              : "range scanner";
        port.publish(agent::BehaviorEvent{Severity::Error,
                                          "The " + which + " went silent; the robot waits for data where it is."});
    }
    if (silent_ && !silent)
        port.publish(agent::BehaviorEvent{Severity::Note, "All sensors speak again."});
    silent_ = silent;
    if (!silent || phase_ == Phase::Ground)
        return true;
    craft_.rest(port, "sensors silent");
    if (worst > lost_after)
        finish(false, "A sensor that the flight needs stays silent; the robot hovers. Take over by hand.", port);
    return false;
}

void SurveyBehavior::act(const agent::Tick& tick, agent::CommandPort& port) {
    watchBattery(port);
    if (paused_ && phase_ != Phase::Landing && phase_ != Phase::Ground)
        return craft_.hover(hold_m_, port, "paused");
    switch (phase_) {
    case Phase::TakeOff:
        return takeOff(port);
    case Phase::ToLane:
    case Phase::Lane:
        return survey(port);
    case Phase::Home:
        return flyHome(port);
    case Phase::Landing:
        return land(port);
    case Phase::Ground:
        return onGround(tick, port);
    case Phase::Launch:
    case Phase::Finished:
        return;
    }
}

void SurveyBehavior::takeOff(agent::CommandPort& port) {
    if (!take_off_m_) {
        take_off_m_ = craft_.senses.position_m(); // not before: the INS was set a tick ago
        const double aside_m = (*take_off_m_ - task_.start_in_map.position_m).norm();
        if (errand_ == Errand::Start && aside_m > beside_start_m && aside_m < away_from_start_m)
            base_in_map_ = craft_.senses.base_in_map;
    }
    const double goal_z_m = std::max(take_off_m_->z() + craft_.settings.scan_altitude_m, craft_.settings.floor_level_m);
    if (!craft_.rise(goal_z_m, take_off_m_->head<2>(), port))
        return;
    phase_ = Phase::ToLane;
    craft_.startAnew();
}

void SurveyBehavior::survey(agent::CommandPort& port) {
    const Settings& settings = craft_.settings;
    const Vec2 here_m = craft_.senses.position2_m();
    onSurveyEvent(survey_.update(here_m, settings), port);
    if (phase_ != Phase::ToLane && phase_ != Phase::Lane)
        return;
    phase_ = survey_.onLane() ? Phase::Lane : Phase::ToLane;
    had_lane_since_charge_ = had_lane_since_charge_ || phase_ == Phase::Lane;
    const Leg leg{survey_.goal_m(settings), survey_.aim_m(here_m, settings),
                  survey_.onLane() ? settings.scan_speed_m_s : settings.transit_speed_m_s, words()};
    goal_distance_m_ = (leg.goal_m - here_m).norm();
    if (craft_.fly(leg, port) != FlightState::Unreachable)
        return;
    const Vec3 goal_m(leg.goal_m.x(), leg.goal_m.y(), craft_.senses.position_m().z());
    craft_.log.mark(agent::MarkKind::GoalGivenUp, goal_m, craft_.senses, port);
    port.publish(agent::BehaviorEvent{Severity::Warning, "A goal could not be reached in time and is left out."});
    onSurveyEvent(survey_.giveUp(settings), port);
}

void SurveyBehavior::onSurveyEvent(SurveyEvent event, agent::CommandPort& port) {
    if (event == SurveyEvent::AllDone)
        goHome(Errand::Done, "", port);
    else if (event == SurveyEvent::QuadrantDone)
        goHome(Errand::Quadrant, "A quadrant is done; home to set the INS and to charge.", port);
}

void SurveyBehavior::goHome(Errand errand, const std::string& why, agent::CommandPort& port) {
    errand_ = errand;
    endPause("the robot has to go home", port);
    survey_.interrupt();
    craft_.startAnew();
    phase_ = Phase::Home;
    if (!why.empty())
        port.publish(agent::BehaviorEvent{Severity::Note, why});
}

void SurveyBehavior::endPause(const std::string& why, agent::CommandPort& port) {
    if (!std::exchange(paused_, false))
        return;
    port.publish(agent::BehaviorEvent{Severity::Warning, "The pause ends, for " + why + "."});
}

void SurveyBehavior::watchRobotBattery(agent::CommandPort& port) {
    const Settings& settings = craft_.settings;
    const Seconds way_home(1.3 * beelineHome_m() / settings.transit_speed_m_s + settings.robot_battery_reserve_s);
    if (!craft_.senses.robot_battery || *craft_.senses.robot_battery >= way_home)
        return;
    endPause("the robot's own battery runs out", port);
    if (phase_ == Phase::Home)
        return;
    end_reason_ = "The robot's own battery runs out, and the simulator cannot charge it; raise its battery life.";
    goHome(Errand::GivenUp, end_reason_, port);
}

void SurveyBehavior::watchBattery(agent::CommandPort& port) {
    if (phase_ == Phase::Ground || phase_ == Phase::Landing)
        return;
    watchRobotBattery(port);
    if (phase_ != Phase::ToLane && phase_ != Phase::Lane)
        return;
    if (craft_.battery.rangeLeft_m(beelineHome_m(), craft_.settings) > 0.0)
        return;
    craft_.log.mark(agent::MarkKind::Recharge, craft_.senses.position_m(), craft_.senses, port);
    if (!had_lane_since_charge_) {
        end_reason_ = "The place to resume at is out of the battery's range; raise the range or move the base.";
        return goHome(Errand::GivenUp, end_reason_, port);
    }
    goHome(Errand::Recharge, "The battery's reserve is near; home for a charge.", port);
}

void SurveyBehavior::flyHome(agent::CommandPort& port) {
    const Vec2 base_m = base_in_map_.position_m.head<2>();
    const Vec2 here_m = craft_.senses.position2_m();
    goal_distance_m_ = (base_m - here_m).norm();
    if (*goal_distance_m_ < over_base_m)
        return beginLanding(base_m);
    const Leg leg{base_m, base_m, craft_.settings.transit_speed_m_s, words()};
    if (craft_.fly(leg, port) != FlightState::Unreachable)
        return;
    port.publish(agent::BehaviorEvent{Severity::Error, "The way home is blocked; the robot lands where it is."});
    end_reason_ = "The way home was blocked.";
    errand_ = Errand::GivenUp;
    beginLanding(here_m);
}

void SurveyBehavior::beginLanding(const Vec2& near_m) {
    landing_m_ = landingPlace_m(craft_.memory, near_m, craft_.settings.landing_radius_m);
    craft_.touchdown.start();
    phase_ = Phase::Landing;
}

void SurveyBehavior::land(agent::CommandPort& port) {
    if (!craft_.descend(landing_m_, port))
        return;
    craft_.rest(port, "landed");
    craft_.log.mark(agent::MarkKind::Landing, craft_.senses.position_m(), craft_.senses, port);
    craft_.log.goal(std::nullopt, port);
    phase_ = Phase::Ground;
    phase_since_ = craft_.senses.now;
    ins_reset_.start(craft_.senses.now);
}

void SurveyBehavior::onGround(const agent::Tick& tick, agent::CommandPort& port) {
    if (errand_ == Errand::Done || errand_ == Errand::GivenUp)
        return conclude(port);
    const ResetState before = ins_reset_.state();
    const ResetState reset = ins_reset_.step(tick.now, tick.robot, port, craft_.settings);
    if (reset != before)
        onResetEnded(reset, port);
    const bool settled = reset == ResetState::Done || reset == ResetState::Failed;
    const Seconds charging(errand_ == Errand::Start ? 0.0 : craft_.settings.recharge_time_s);
    if (!settled || paused_ || tick.now - phase_since_ < charging)
        return;
    if (errand_ != Errand::Start) {
        craft_.battery.recharge();
        had_lane_since_charge_ = false;
    }
    craft_.forgetPlaces();
    phase_ = Phase::TakeOff;
    take_off_m_.reset();
}

void SurveyBehavior::conclude(agent::CommandPort& port) {
    if (errand_ != Errand::Done)
        return finish(false, end_reason_, port);
    if (survey_.goalsGivenUp() == 0)
        return finish(true, "The area is scanned.", port);
    const double share_pct = survey_.givenUp_pct();
    const double most_pct = craft_.settings.most_left_out_pct;
    const std::string goals = "goals left out: " + std::to_string(survey_.goalsGivenUp()) + ", " +
                              std::to_string(std::lround(share_pct)) + " % of the lanes";
    if (share_pct <= most_pct)
        return finish(true, "The area is scanned; " + goals + ".", port);
    finish(false,
           "The area is not scanned; " + goals + ", and at most " + std::to_string(std::lround(most_pct)) +
               " % may be. Raise the time until a goal is given up, or choose an area with room to fly.",
           port);
}

void SurveyBehavior::onResetEnded(ResetState reset, agent::CommandPort& port) {
    if (reset == ResetState::Failed)
        port.publish(
            agent::BehaviorEvent{Severity::Warning, "The INS could not be set; the flight goes on with its drift."});
    if (reset == ResetState::Done)
        port.publish(agent::BehaviorEvent{Severity::Note, "The INS was set from ground truth."});
}

void SurveyBehavior::order(agent::Order order, agent::CommandPort& port) {
    if (phase_ == Phase::Finished)
        return;
    hold_m_ = craft_.senses.position2_m();
    paused_ = order == agent::Order::Pause;
    if (order != agent::Order::LandNow)
        return;
    end_reason_ = "The robot landed because a person asked it to.";
    if (!airborne())
        return finish(false, end_reason_, port);
    errand_ = Errand::GivenUp;
    if (phase_ != Phase::Landing)
        beginLanding(craft_.senses.position2_m());
}

void SurveyBehavior::finish(bool success, const std::string& reason, agent::CommandPort& port) {
    phase_ = Phase::Finished;
    craft_.rest(port, "finished");
    port.publish(agent::BehaviorFinished{success, reason});
}

} // namespace usar::airrobot
