#include "robots/airrobot/survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robots/airrobot/flight/battery_model.h"
#include "robots/airrobot/lane_order.h"

namespace usar::airrobot {

namespace {
/// A goal within a lane counts as reached if the robot passes it no farther to the side than this.
constexpr double passing_m = 8.0;
constexpr double end_passing_m = 3.0;
constexpr double very_end_m = 0.5; ///< The end of the last lane counts as reached at this distance.
constexpr double resume_back_m = 1.0;
/// A lane is looked at in such steps for what of it can be reached.
constexpr double look_every_m = 1.0;
constexpr double worth_a_flight_m = 1.0;
/// A robot that has flown no farther than this since its charge need not charge.
constexpr double just_charged_m = 75.0;

std::pair<Vec2, Vec2> endsOf_m(const mapping::Lane& lane) {
    return {lane.start_m, lane.end_m};
}
} // namespace

Result<Survey> Survey::make(const agent::Task& task, const Settings& settings) {
    auto plan = planSurvey(task.area_in_map, task.start_in_map.position_m.head<2>(), settings);
    if (!plan)
        return tl::unexpected(plan.error());
    return Survey(std::move(plan->coverage), plan->routed, plan->lane_spacing_m);
}

double Survey::length_m() const {
    const mapping::Lane& lane = plan_.lanes[lane_];
    return (lane.end_m - lane.start_m).norm();
}

Vec2 Survey::pointAt_m(double along_m) const {
    const mapping::Lane& lane = plan_.lanes[lane_];
    const double length = length_m();
    const Vec2 start_m = lane.start_m + shift_m_;
    return length > 0.0 ? Vec2(start_m + (lane.end_m - lane.start_m) * (along_m / length)) : start_m;
}

double Survey::pieceEnd_m(const Settings& settings) const {
    if (short_end_m_)
        return *short_end_m_;
    const double end_m = piece_start_m_ + settings.goal_distance_m;
    const double length = length_m();
    return length - end_m < settings.goal_distance_m / 2.0 ? length : end_m;
}

Vec2 Survey::aim_m(const Vec2& position_m, const Settings& settings) const {
    if (!on_lane_)
        return pointAt_m(entry_along_m_);
    const double here_m = placeOf(position_m).along_m;
    return pointAt_m(std::clamp(here_m + settings.lookahead_m, piece_start_m_, length_m()));
}

Survey::Place Survey::placeOf(const Vec2& position_m) const {
    const mapping::Lane& lane = plan_.lanes[lane_];
    const Vec2 along = (lane.end_m - lane.start_m).normalized();
    const Vec2 offset_m = position_m - lane.start_m - shift_m_;
    return {along.dot(offset_m), std::abs(along.x() * offset_m.y() - along.y() * offset_m.x())};
}

void Survey::note(const Vec2& position_m) {
    if (done() || !on_lane_)
        return;
    const Place place = placeOf(position_m);
    if (place.aside_m < passing_m)
        reached_m_ = std::clamp(place.along_m, reached_m_, length_m());
}

bool Survey::goalReached(const Vec2& position_m, const Settings& settings, bool in_the_open) const {
    if (done())
        return false;
    const double closely_m = in_the_open ? std::min(very_end_m, settings.goal_reached_m) : settings.goal_reached_m;
    if (!on_lane_)
        return (position_m - pointAt_m(entry_along_m_)).norm() <= settings.goal_reached_m;
    const Place place = placeOf(position_m);
    const double end_m = pieceEnd_m(settings);
    const bool last = end_m >= length_m();
    const bool very_end = last && lane_ + 1 == plan_.lanes.size();
    return place.along_m >= end_m - (very_end ? closely_m : settings.goal_reached_m) &&
           place.aside_m <= (last ? end_passing_m : passing_m);
}

SurveyEvent Survey::next(const Settings& settings) {
    if (done())
        return SurveyEvent::AllDone;
    if (on_lane_)
        return endPiece(settings);
    on_lane_ = true;
    piece_start_m_ = reached_m_ = entry_along_m_;
    return SurveyEvent::LaneEntered;
}

SurveyEvent Survey::endPiece(const Settings& settings) {
    piece_start_m_ = pieceEnd_m(settings);
    short_end_m_.reset();
    return piece_start_m_ < length_m() ? SurveyEvent::GoalReached : nextLane();
}

SurveyEvent Survey::nextLane() {
    const int sortie = plan_.lanes[lane_].sortie;
    finished_lanes_m_ += length_m();
    ++lane_;
    on_lane_ = false;
    entry_along_m_ = piece_start_m_ = reached_m_ = 0.0;
    short_end_m_.reset();
    if (done())
        return SurveyEvent::AllDone;
    return plan_.lanes[lane_].sortie != sortie ? SurveyEvent::SortieDone : SurveyEvent::LaneDone;
}

void Survey::leaveOut(double from_m, double to_m, LeftOut why) {
    const double left_out_m = std::max(0.0, to_m - from_m);
    if (!counts_[lane_]) {
        ++added_left_out_;
        return;
    }
    goals_given_up_ += why == LeftOut::Late ? 1 : 0;
    (why == LeftOut::Late ? given_up_m_ : cut_off_m_) += left_out_m;
    if (why == LeftOut::NoWayFound && left_out_m > 0.0)
        cut_off_.push_back({pointAt_m(from_m), pointAt_m(to_m), 0});
}

void Survey::append(mapping::Lane lane, bool counts) {
    lane.quadrant = plan_.lanes.empty() ? 0 : plan_.lanes.back().quadrant;
    const double length_m = (lane.end_m - lane.start_m).norm();
    plan_.lanes.push_back(lane);
    plan_.lane_length_m += length_m;
    added_m_ += length_m;
    counts_.push_back(counts);
}

void Survey::add(const std::vector<mapping::Lane>& lanes) {
    const int last_sortie = plan_.lanes.empty() ? 0 : plan_.lanes.back().sortie;
    for (mapping::Lane lane : lanes) {
        lane.sortie += last_sortie; // With sortie 0, no flight home is due before it.
        append(lane, false);
    }
}

bool Survey::goesHomeBefore(std::size_t lane, double since_charge_m, const Settings& settings) const {
    if (lane == 0 || lane >= plan_.lanes.size() || plan_.lanes[lane].sortie == plan_.lanes[lane - 1].sortie)
        return false;
    if (routed_ || !counts_[lane])
        return since_charge_m > just_charged_m;
    return !settings.navigate_by_truth && isWorthACharge(since_charge_m, settings);
}

void Survey::divideLane() {
    if (entry_along_m_ <= 0.0)
        return;
    mapping::Lane rest = plan_.lanes[lane_];
    rest.start_m += (rest.end_m - rest.start_m).normalized() * entry_along_m_;
    plan_.lanes[lane_].end_m = rest.start_m;
    finished_lanes_m_ += entry_along_m_;
    ++lane_;
    plan_.lanes.insert(plan_.lanes.begin() + static_cast<std::ptrdiff_t>(lane_), rest);
    counts_.insert(counts_.begin() + static_cast<std::ptrdiff_t>(lane_), counts_[lane_ - 1]);
    entry_along_m_ = piece_start_m_ = reached_m_ = 0.0;
    short_end_m_.reset();
}

bool Survey::replan(const ScanLedger& ledger, const Vec2& base_m, const Settings& settings, double detour,
                    const Choice& added) {
    const bool routes = routed_ || (settings.hurried() && laneCount() - lane_ <= few_lanes);
    if (done() || on_lane_ || !routes)
        return false;
    const bool planned = counts_[lane_];
    if (std::find(counts_.begin() + static_cast<std::ptrdiff_t>(lane_), counts_.end(), !planned) != counts_.end())
        return false;
    routed_ = true;
    Settings as_planned = settings;
    as_planned.lane_spacing_m = lane_spacing_m_;
    divideLane();
    const auto first = plan_.lanes.begin() + static_cast<std::ptrdiff_t>(lane_);
    const std::vector<mapping::Lane> before(first, plan_.lanes.end());
    const auto first_added = plan_.lanes.begin() + (std::ranges::find(counts_, false) - counts_.begin());
    const bool chosen = !planned && added;
    std::vector<mapping::Lane> rest =
        chosen ? added({std::min(first_added, first), first})
               : replanned(before, planned ? ledger : ScanLedger(), base_m, as_planned, detour);
    if (!chosen && rest.empty()) { // At the end of a lane, the robot looks for what is hidden.
        rest = {before.back()};
        rest[0].start_m = rest[0].end_m - (rest[0].end_m - rest[0].start_m).normalized();
    }
    plan_.lanes.erase(first, plan_.lanes.end());
    counts_.resize(lane_);
    const int last_sortie = lane_ == 0 ? -1 : plan_.lanes.back().sortie;
    for (mapping::Lane lane : rest) {
        lane.sortie += last_sortie + 1;
        plan_.lanes.push_back(lane);
        counts_.push_back(planned);
    }
    const double saved_m = lengthOf_m(before) - lengthOf_m(rest);
    if (!chosen) { // Ends that were shown and short rests count as done.
        finished_lanes_m_ += saved_m;
    } else {
        plan_.lane_length_m -= saved_m;
        added_m_ -= saved_m;
    }
    return !std::ranges::equal(before, rest, {}, endsOf_m, endsOf_m);
}

void Survey::retryCutOff() {
    const auto again = std::exchange(cut_off_, {});
    for (mapping::Lane lane : again) {
        lane.sortie = plan_.lanes.back().sortie; // No flight home is due before it.
        append(lane, true);
    }
    cut_off_m_ = 0.0;
}

SurveyEvent Survey::giveUp(const Settings& settings, LeftOut why) {
    if (done())
        return SurveyEvent::AllDone;
    if (on_lane_) {
        leaveOut(std::max(piece_start_m_, reached_m_), pieceEnd_m(settings), why);
        return endPiece(settings);
    }
    piece_start_m_ = entry_along_m_;
    leaveOut(entry_along_m_, pieceEnd_m(settings), why);
    entry_along_m_ = pieceEnd_m(settings);
    return entry_along_m_ < length_m() ? SurveyEvent::GoalReached : nextLane();
}

SurveyEvent Survey::cutOff(const Settings& settings, const std::function<bool(const Vec2&)>& can_reach) {
    if (done())
        return SurveyEvent::AllDone;
    const double here_m = on_lane_ ? std::max(piece_start_m_, reached_m_) : entry_along_m_;
    if (on_lane_) {
        const double end_m = pieceEnd_m(settings);
        double along_m = end_m - look_every_m;
        while (along_m > here_m + worth_a_flight_m && !can_reach(pointAt_m(along_m)))
            along_m -= look_every_m;
        if (along_m > here_m + worth_a_flight_m) {
            short_end_m_ = along_m;
            return SurveyEvent::GoalReached;
        }
    }
    short_end_m_.reset();
    double along_m = here_m + look_every_m;
    while (along_m < length_m() && !can_reach(pointAt_m(along_m)))
        along_m += look_every_m;
    along_m = std::min(along_m, length_m());
    leaveOut(here_m, along_m, LeftOut::NoWayFound);
    if (along_m > length_m() - worth_a_flight_m)
        return nextLane();
    on_lane_ = false;
    entry_along_m_ = piece_start_m_ = reached_m_ = along_m;
    return SurveyEvent::GoalReached;
}

void Survey::interrupt() {
    if (on_lane_)
        entry_along_m_ = std::max(0.0, std::max(reached_m_, piece_start_m_) - resume_back_m);
    on_lane_ = false;
}

double Survey::doneLength_m() const {
    return done() ? plan_.lane_length_m : finished_lanes_m_ + alongLane_m();
}

std::vector<Vec2> Survey::path_m(const Vec2& base_m, const Settings& settings) const {
    constexpr double far_m = std::numeric_limits<double>::infinity();
    std::vector<Vec2> path;
    for (std::size_t i = 0; i < plan_.lanes.size(); ++i) {
        if (goesHomeBefore(i, far_m, settings))
            path.push_back(base_m);
        path.insert(path.end(), {plan_.lanes[i].start_m, plan_.lanes[i].end_m});
    }
    return path;
}

} // namespace usar::airrobot
