// Tells the state of a survey in words, its figures, and where it is in its mission.
#include <algorithm>
#include <string>

#include "core/base/numbers.h"
#include "robots/airrobot/survey_flight.h"

namespace usar::airrobot {

std::string SurveyFlight::words() const {
    const std::string lane =
        "lane " + std::to_string(survey_.laneIndex() + 1) + " of " + std::to_string(survey_.laneCount());
    switch (phase_) {
    case Phase::Launch:
        return checklist_.words();
    case Phase::TakeOff:
        return sortie_.beyond_door ? "coming up beyond a door" : "taking off";
    case Phase::ToLane:
        return "flying to " + lane;
    case Phase::Lane:
        return "scanning " + lane;
    case Phase::Home:
        return errand_ == Errand::Recharge ? "returning to charge" : "returning to base";
    case Phase::Landing:
        return "landing";
    case Phase::Ground:
        return ins_reset_.state() == ResetState::Done && errand_ != Errand::Start && !scanOver()
                   ? "charging"
                   : "calibrating the INS on the ground";
    case Phase::Finished:
        return "finished";
    }
    return {};
}

void SurveyFlight::noteCeiling(agent::CommandPort& port) {
    const auto& found = craft_.overhead.found();
    if (!inTheAir() || !found || !found->anew)
        return;
    const double above_m = found->z_m - base_in_map_.position_m.z();
    port.publish(agent::BehaviorEvent{found->touched ? Severity::Warning : Severity::Note,
                                      std::string("A ceiling was ") + (found->touched ? "touched " : "seen ") +
                                          fixed(above_m, 1) + " m above the base; the robot stays below it."});
}

MissionState SurveyFlight::missionState() {
    const Settings& settings = craft_.settings;
    const Vec3 place_m = craft_.senses.position_m();
    const double height_m = std::max(0.0, place_m.z() - base_in_map_.position_m.z());
    const double rate_m_s = errand_ == Errand::Start ? carefulClimb_m_s(craft_.settings) : settings.climb_speed_m_s;
    const auto climb = [&](double by_m) { return Seconds(std::max(0.0, by_m) / rate_m_s); };
    MissionState state{place_m.head<2>(), base_in_map_.position_m.head<2>(),
                       craft_.battery.used_pct(settings) / 100.0 * settings.battery_range_m};
    state.lanes_left = errand_ != Errand::Done && errand_ != Errand::GivenUp;
    state.returning = phase_ == Phase::Home;
    state.added_m = leftovers_.expected_m(craft_, survey_, ledger_);
    if (!settings.navigate_by_truth) // The last landing ends with a setting of the INS.
        state.waiting = Seconds(settings.rest_time_s);
    const Seconds rested = phase_ == Phase::Ground ? craft_.senses.now - sortie_.landed : Seconds{0.0};
    if (!state.lanes_left)
        state.waiting = std::max(Seconds{0.0}, state.waiting - rested);
    if (phase_ == Phase::TakeOff)
        state.waiting += climb(settings.scan_altitude_m - height_m);
    if (phase_ == Phase::Landing)
        state.waiting += Seconds(height_m / settings.landing_speed_m_s);
    if ((phase_ == Phase::Landing || phase_ == Phase::Ground) && state.lanes_left) {
        const Seconds charging(errand_ == Errand::Start ? 0.0 : settings.recharge_time_s);
        state.waiting += std::max(Seconds{0.0}, charging - rested) + climb(settings.scan_altitude_m);
        state.since_charge_m = 0.0;
    }
    return state;
}

agent::BehaviorStatus SurveyFlight::status() const {
    agent::BehaviorStatus status;
    status.time = craft_.senses.now;
    status.elapsed = craft_.senses.now - *started_;
    status.state = silent_ ? "waiting for sensors" : paused_ ? "paused, " + words() : words();
    status.distance_to_goal_m = goal_distance_m_;
    status.battery_used_pct = craft_.battery.used_pct(craft_.settings);
    status.range_left_m = craft_.battery.rangeLeft_m(beelineHome_m(), craft_.settings);
    status.progress_pct = planned() ? 100.0 * survey_.doneLength_m() / survey_.totalLength_m() : 0.0;
    if (const auto left = finished() ? agent::Forecast{} : time_.left(status.time)) {
        status.time_left = Seconds(left->mean);
        status.time_left_range = left->range();
    }
    status.distance_flown_m = craft_.battery.flown_m();
    status.charges = craft_.battery.charges();
    status.paused = paused_;
    return status;
}

} // namespace usar::airrobot
