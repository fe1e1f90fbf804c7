#include "robots/airrobot/flight/time_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robots/airrobot/flight/ascent.h"
#include "robots/airrobot/flight/battery_model.h"

namespace usar::airrobot {

namespace {

/// Acceleration and turns cost a few seconds on every way between lanes, however long it is, and evasion makes it
/// longer than at transit speed. Means of surveys in `tall_test` and `volcano`: from lane to lane 8 m take 7.2 s to
/// 7.4 s, and home over 56 m and 250 m at 1.25 to 1.0 times the time at transit speed.
constexpr double transit_pace = 1.1;
constexpr double turn_s = 2.0;
constexpr double start_up_s = 4.0; ///< the rotors need it before the climb
/// A survey of rooms and doors may well take twice as long as one of open ground, and a small one longer than that.
constexpr double most_times = 3.0;
constexpr Seconds time_to_spare{900.0};
constexpr double piece_s = 20.0; ///< of a lane, at scan speed, after which it is noted
constexpr double piece_m = 10.0; ///< of a lane, after which the battery is watched in thought
/// Ways between added lanes, for each length of them: 396 m for 508 m of lanes in `tall_test`.
constexpr double way_per_added = 0.8;
constexpr double added_lane_m = 25.0;      ///< a usual length of an added lane
constexpr double added_lanes_unsure = 0.4; ///< share by which the time for them is often wrong

double planned_s(Stage stage, double way_m, const Settings& settings) {
    switch (stage) {
    case Stage::Lane:
        return way_m / settings.scan_speed_m_s;
    case Stage::Way:
        return turn_s + transit_pace * way_m / settings.transit_speed_m_s;
    case Stage::Landing:
        return settings.scan_altitude_m / settings.landing_speed_m_s;
    case Stage::Charge:
        return start_up_s + settings.recharge_time_s + settings.scan_altitude_m / settings.climb_speed_m_s;
    case Stage::None:
        break;
    }
    return 0.0;
}

/// A flight in thought, which adds up what the stages are planned to take.
class ThoughtFlight {
public:
    ThoughtFlight(const MissionState& state, double detour, const Settings& settings)
        : settings_(settings)
        , detour_(detour)
        , base_m_(state.base_m)
        , at_m_(state.position_m)
        , used_m_(state.since_charge_m) {}

    double used_m() const { return used_m_; }
    int charges() const { return charges_; }
    double added_s() const { return added_s_; } ///< planned time of `scanAbout`
    double stage_s(Stage stage) const { return stages_s_[static_cast<std::size_t>(stage)]; }
    void transit(const Vec2& to_m) {
        const double way_m = move(to_m);
        if (way_m > 0.0)
            add(Stage::Way, way_m);
    }
    void scan(const Vec2& to_m) { add(Stage::Lane, move(to_m)); }
    /// Flies a lane of this length, and the way to it, somewhere about here.
    void scanAbout(double length_m) {
        const double way_m = way_per_added * length_m;
        add(Stage::Way, way_m);
        add(Stage::Lane, length_m);
        added_s_ += planned_s(Stage::Way, way_m, settings_) + planned_s(Stage::Lane, length_m, settings_);
        used_m_ += (way_m + length_m) * detour_;
    }
    /// Flies home and lands.
    void land() {
        transit(base_m_);
        add(Stage::Landing);
    }
    /// Charges on the ground and takes off.
    void charge() {
        add(Stage::Charge);
        used_m_ = 0.0;
        ++charges_;
    }
    /// Flies home for a charge and back to this place if the battery does not last for `way_m` and the way home.
    void chargeBefore(double way_m) {
        if (used_m_ == 0.0 || used_m_ + way_m * detour_ + (at_m_ - base_m_).norm() <= usableRange_m(settings_))
            return;
        const Vec2 place_m = at_m_;
        land();
        charge();
        transit(place_m);
    }

private:
    void add(Stage stage, double way_m = 0.0) {
        stages_s_[static_cast<std::size_t>(stage)] += planned_s(stage, way_m, settings_);
    }
    double move(const Vec2& to_m) {
        const double way_m = (to_m - at_m_).norm();
        at_m_ = to_m;
        used_m_ += way_m * detour_;
        return way_m;
    }

    const Settings& settings_;
    double detour_;
    Vec2 base_m_;
    Vec2 at_m_;
    double used_m_; ///< distance taken from the battery's range
    double stages_s_[5] = {};
    int charges_ = 0;
    double added_s_ = 0.0;
};

/// Flies the rest of a lane, from `along_m` on, in pieces between which the battery is watched.
void flyLane(ThoughtFlight& flight, const mapping::Lane& lane, double along_m) {
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

/// Flies all that is left.
void flyOn(ThoughtFlight& flight, const Survey& survey, const MissionState& state, const Settings& settings) {
    if (state.returning)
        flight.land();
    if (!state.lanes_left)
        return;
    if (state.returning)
        flight.charge();
    const auto& lanes = survey.plan().lanes;
    for (std::size_t i = survey.laneIndex(); i < lanes.size(); ++i) {
        const bool first = i == survey.laneIndex();
        if (!first && survey.goesHomeBefore(i, flight.used_m(), settings)) {
            flight.land();
            flight.charge();
        }
        flyLane(flight, lanes[i], first ? survey.alongLane_m() : 0.0);
    }
    for (double left_m = state.added_m; left_m > 0.0; left_m -= added_lane_m) {
        const double length_m = std::min(left_m, added_lane_m);
        flight.chargeBefore((1.0 + way_per_added) * length_m);
        flight.scanAbout(length_m);
    }
    flight.land();
}

} // namespace

void TimeEstimate::note(const MissionMoment& moment, const Settings& settings) {
    if (!last_)
        last_ = moment;
    if (moment.stage != last_->stage || moment.returning != last_->returning) {
        noteStage(settings);
        took_ = Seconds{0.0};
        from_m_ = last_->position_m;
    }
    const Seconds passed = moment.holding ? Seconds{0.0} : moment.now - last_->now;
    took_ += passed;
    spent_ += moment.stage == Stage::None ? Seconds{0.0} : passed;
    if (moment.stage == Stage::Lane)
        noteLane(moment, passed, settings);
    last_ = moment;
}

void TimeEstimate::noteLane(const MissionMoment& moment, Seconds passed, const Settings& settings) {
    piece_.took += passed;
    piece_.planned_m += std::max(0.0, moment.done_m - last_->done_m);
    piece_.flown_m += moment.flown_m - last_->flown_m;
    const double planned = planned_s(Stage::Lane, piece_.planned_m, settings);
    if (planned < piece_s)
        return;
    paceOf(Stage::Lane).note(planned, piece_.took.count());
    detour_.note(piece_.planned_m, piece_.flown_m);
    piece_ = {};
}

void TimeEstimate::noteStage(const Settings& settings) {
    if (last_->stage == Stage::None || last_->stage == Stage::Lane)
        return; // Lanes are noted in pieces
    paceOf(last_->stage).note(plannedStage_s(settings), took_.count());
}

double TimeEstimate::plannedStage_s(const Settings& settings) const {
    return planned_s(last_->stage, (last_->position_m - from_m_).norm(), settings);
}

agent::Pace TimeEstimate::paceSoFar(Stage stage, const Settings& settings) const {
    agent::Pace so_far = pace(stage);
    if (stage == Stage::Lane && piece_.took > Seconds{0.0})
        so_far.note(std::max(1.0, planned_s(Stage::Lane, piece_.planned_m, settings)), piece_.took.count());
    if (stage == Stage::Way && last_ && last_->stage == Stage::Way)
        so_far.note(plannedStage_s(settings), took_.count());
    return so_far;
}

WholeFlight TimeEstimate::flightInThought(double detour, const Survey& survey, const MissionState& state,
                                          const Settings& settings) const {
    ThoughtFlight flight(state, detour, settings);
    flyOn(flight, survey, state, settings);
    agent::Forecast sum{state.waiting.count(), 0.0};
    for (const Stage stage : {Stage::Lane, Stage::Way, Stage::Landing, Stage::Charge})
        sum += paceSoFar(stage, settings).forecast(flight.stage_s(stage));
    const double unsure_s = added_lanes_unsure * flight.added_s();
    sum.variance += unsure_s * unsure_s;
    return {sum, static_cast<double>(flight.charges())};
}

WholeFlight TimeEstimate::rest(const Survey& survey, const MissionState& state, const Settings& settings) const {
    const double charge_m = usableRange_m(settings);
    const double apart = std::sqrt(2.0) * detour_.forecast(charge_m).deviation() / charge_m;
    struct Thought {
        double share;
        WholeFlight flight;
    };
    std::array<Thought, 3> thoughts;
    for (std::size_t i = 0; i < thoughts.size(); ++i)
        thoughts[i] = {i == 1 ? 0.5 : 0.25, flightInThought(detour_.pace() + (static_cast<double>(i) - 1.0) * apart,
                                                            survey, state, settings)};
    WholeFlight all;
    for (const Thought& thought : thoughts) {
        all.time.mean += thought.share * thought.flight.time.mean;
        all.charges += thought.share * thought.flight.charges;
    }
    for (const Thought& thought : thoughts) {
        const double aside = thought.flight.time.mean - all.time.mean;
        all.time.variance += thought.share * (thought.flight.time.variance + aside * aside);
    }
    return all;
}

WholeFlight TimeEstimate::whole(const Survey& survey, const Vec2& base_m, double added_m,
                                const Settings& settings) const {
    const double climb_m_s = carefulClimb_m_s(settings);                            // Nobody has been up there yet.
    const Seconds setting(settings.navigate_by_truth ? 0.0 : settings.rest_time_s); // The INS is set before and after.
    const Seconds take_off(start_up_s + settings.scan_altitude_m / climb_m_s);
    MissionState state{.position_m = base_m, .base_m = base_m, .waiting = take_off + 2.0 * setting};
    state.added_m = added_m;
    return rest(survey, state, settings);
}

void TimeEstimate::update(Seconds now, const Survey& survey, const MissionState& state, const Settings& settings) {
    if (estimated_ && now - *estimated_ < Seconds(1.0))
        return;
    estimated_ = now;
    forecast_ = forecast(survey, state, settings);
    if (!expected_)
        expected_ = Seconds(forecast_.mean);
}

bool TimeEstimate::overdue() const {
    return expected_ && spent_ > most_times * *expected_ + time_to_spare;
}

std::optional<agent::Forecast> TimeEstimate::left(Seconds now) const {
    if (!estimated_)
        return std::nullopt;
    return agent::Forecast{std::max(0.0, forecast_.mean - (now - *estimated_).count()), forecast_.variance};
}

} // namespace usar::airrobot
