#include "robots/airrobot/flight/time_estimate.h"

#include <algorithm>
#include <cmath>

#include "robots/airrobot/flight/battery_model.h"

namespace usar::airrobot {

namespace {

/// Acceleration and turns cost a few seconds on every way between lanes, however long it is, and evasion makes it
/// longer than at transit speed; the way flown is longer than the beeline. Means of surveys in `tall_test` and
/// `volcano`: from lane to lane 8 m take 7.2 s to 7.4 s, and home over 56 m and 250 m at 1.25 to 1.0 times the time at
/// transit speed.
constexpr double transit_pace = 1.1;
constexpr Seconds turn{2.0};
constexpr double detour = 1.06;
constexpr Seconds start_up{4.0}; ///< the rotors need it before the climb

/// A flight in thought.
class ThoughtFlight {
public:
    ThoughtFlight(const MissionState& state, double pace, const Settings& settings)
        : settings_(settings)
        , pace_(pace)
        , base_m_(state.base_m)
        , at_m_(state.position_m)
        , used_m_(state.since_charge_m)
        , time_(state.waiting) {}

    Seconds time() const { return time_; }
    void transit(const Vec2& to_m) {
        const double way_m = move(to_m);
        if (way_m > 0.0)
            time_ += turn + Seconds(transit_pace * way_m / settings_.transit_speed_m_s);
    }
    void scan(const Vec2& to_m) { time_ += Seconds(pace_ * move(to_m) / settings_.scan_speed_m_s); }
    /// Flies home and lands.
    void land() {
        transit(base_m_);
        time_ += Seconds(settings_.scan_altitude_m / settings_.landing_speed_m_s);
    }
    /// Charges on the ground and takes off.
    void charge() {
        time_ += start_up + Seconds(settings_.recharge_time_s + settings_.scan_altitude_m / settings_.climb_speed_m_s);
        used_m_ = 0.0;
    }
    /// Flies home for a charge and back to this place if the battery does not last for `way_m` and the way home.
    void chargeBefore(double way_m) {
        if (used_m_ == 0.0 || used_m_ + way_m * detour + (at_m_ - base_m_).norm() <= usableRange_m(settings_))
            return;
        const Vec2 place_m = at_m_;
        land();
        charge();
        transit(place_m);
    }

private:
    double move(const Vec2& to_m) {
        const double way_m = (to_m - at_m_).norm();
        at_m_ = to_m;
        used_m_ += way_m * detour;
        return way_m;
    }

    const Settings& settings_;
    double pace_;
    Vec2 base_m_;
    Vec2 at_m_;
    double used_m_; ///< distance taken from the battery's range
    Seconds time_;
};

/// Flies the rest of a lane, from `along_m` on, in pieces between which the battery is watched.
void flyLane(ThoughtFlight& flight, const mapping::Lane& lane, double along_m) {
    constexpr double piece_m = 10.0;
    const double length_m = (lane.end_m - lane.start_m).norm();
    const Vec2 way = length_m > 0.0 ? Vec2((lane.end_m - lane.start_m) / length_m) : Vec2(Vec2::Zero());
    const int pieces = std::clamp(static_cast<int>(std::ceil((length_m - along_m) / piece_m)), 1, 100);
    const double step_m = std::max(0.0, length_m - along_m) / pieces;
    flight.transit(lane.start_m + way * along_m);
    for (int piece = 1; piece <= pieces; ++piece) {
        flight.chargeBefore(step_m);
        flight.scan(lane.start_m + way * (along_m + piece * step_m));
    }
}

} // namespace

void TimeEstimate::note(bool on_lane, Seconds now, double done_m, const Settings& settings) {
    if (on_lane && last_) {
        flown_ += now - *last_;
        planned_ += Seconds(std::max(0.0, done_m - last_done_m_) / settings.scan_speed_m_s);
    }
    last_ = on_lane ? std::optional(now) : std::nullopt;
    last_done_m_ = done_m;
}

Seconds TimeEstimate::timeLeft(const Survey& survey, const MissionState& state, const Settings& settings) const {
    ThoughtFlight flight(state, pace(), settings);
    if (state.returning)
        flight.land();
    if (!state.lanes_left)
        return flight.time();
    if (state.returning)
        flight.charge();
    const auto& lanes = survey.plan().lanes;
    for (std::size_t i = survey.laneIndex(); i < lanes.size(); ++i) {
        const bool first = i == survey.laneIndex();
        if (!first && lanes[i].quadrant != lanes[i - 1].quadrant) {
            flight.land();
            flight.charge();
        }
        flyLane(flight, lanes[i], first ? survey.alongLane_m() : 0.0);
    }
    flight.land();
    return flight.time();
}

void TimeEstimate::update(Seconds now, const Survey& survey, const MissionState& state, const Settings& settings) {
    if (estimated_ && now - *estimated_ < Seconds(1.0))
        return;
    estimated_ = now;
    end_ = now + timeLeft(survey, state, settings);
}

std::optional<Seconds> TimeEstimate::left(Seconds now) const {
    return estimated_ ? std::optional(std::max(Seconds{0.0}, end_ - now)) : std::nullopt;
}

} // namespace usar::airrobot
