// The status of the survey in each tick: the figures of the status strip.
#include "robots/airrobot/survey_flight.h"

namespace usar::airrobot {

std::string SurveyFlight::words() const {
    const std::string lane =
        "lane " + std::to_string(survey_.laneIndex() + 1) + " of " + std::to_string(survey_.laneCount());
    switch (phase_) {
    case Phase::Launch:
        return checklist_.words();
    case Phase::TakeOff:
        return "taking off";
    case Phase::ToLane:
        return "flying to " + lane;
    case Phase::Lane:
        return "scanning " + lane;
    case Phase::Home:
        return errand_ == Errand::Recharge ? "returning to charge" : "returning to base";
    case Phase::Landing:
        return "landing";
    case Phase::Ground:
        return ins_reset_.state() == ResetState::Done && errand_ != Errand::Start ? "charging"
                                                                                  : "at rest, setting the INS";
    case Phase::Finished:
        return "finished";
    }
    return {};
}

std::optional<Seconds> SurveyFlight::timeLeft() const {
    if (survey_.laneCount() == 0)
        return std::nullopt;
    const Settings& settings = craft_.settings;
    const double done_m = survey_.doneLength_m();
    const Seconds elapsed = craft_.senses.now - *started_;
    const Seconds planned = mapping::estimatedTime(survey_.plan(), settings.scan_speed_m_s, settings.transit_speed_m_s);
    const double part = done_m / survey_.totalLength_m();
    const Seconds by_plan = planned * (1.0 - part);
    if (part < 0.05)
        return by_plan;
    const Seconds by_pace = elapsed * ((1.0 - part) / part);
    return by_plan * (1.0 - part) + by_pace * part + Seconds(beelineHome_m() / settings.transit_speed_m_s) * part;
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
    status.time_left = timeLeft();
    status.distance_flown_m = craft_.battery.flown_m();
    status.charges = craft_.battery.charges();
    status.paused = paused_;
    return status;
}

} // namespace usar::airrobot
