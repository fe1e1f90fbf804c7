#include "robots/p2dx/explorer.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::p2dx {

namespace {

// Dimensions of a stock P2DX (robots-and-worlds.md 3.2).
constexpr double wheel_radius_m = 0.097;
constexpr double wheel_separation_m = 0.337;

constexpr Seconds never{1e9};
constexpr double least_speed_m_s = 0.1;
constexpr double backing_speed_m_s = 0.2;
constexpr double backing_lead_m_s = 0.02; ///< speed offset of each wheel: a slight turn while backing away
constexpr Seconds longest_backing{4.0};
constexpr double least_way_back_m = 0.05;
/// The way is free if everything is farther away than the distance that is too close plus this margin.
constexpr double free_beyond_m = 0.3;
constexpr double low_free_beyond_m = 0.1;
/// Speed allowed per meter of free way.
constexpr double speed_per_m_hz = 0.8;
constexpr double scanner_margin_m = 0.35;
constexpr double sonar_margin_m = 0.12;
constexpr double downhill_rad = radians(4.0);
constexpr double downhill_share = 0.6;
/// Speed of the inner wheel in a curve as a share of the outer one; it is faster if that side is not free.
constexpr double tightest_inner_share = 0.3;
constexpr double side_blocked_m = 0.45;
constexpr double side_free_m = 0.75;
/// A danger within this distance after another one counts as the same, because turning back and forth in a corner leads
/// nowhere.
constexpr double same_danger_m = 1.5;
constexpr double escape_rad = radians(150.0);
constexpr double escape_back_m = 0.5;
constexpr double same_trap_m = 2.0;
/// A scanner whose ranges are identical to the last digit after this much motion is frozen.
constexpr double frozen_after_m = 0.15;
constexpr double hull_radius_m = 0.22;
constexpr double scanner_reach_m = 20.0;

} // namespace

void Explorer::hear(const protocol::InfoLine& line) {
    if (const auto* scan = std::get_if<protocol::RangeScan>(&line.message)) {
        scan_ = *scan;
        scan_is_new_ = true;
    } else if (const auto* sonars = std::get_if<protocol::SonarReadings>(&line.message)) {
        for (const protocol::NamedRange& echo : sonars->ranges) { // A line has one sonar or all of them
            const auto known = std::ranges::find(sonars_, echo.name, &protocol::NamedRange::name);
            (known == sonars_.end() ? sonars_.emplace_back() : *known) = echo;
        }
    } else if (const auto* ins = std::get_if<protocol::InsReading>(&line.message)) {
        ins_in_map_ = ins->base_in_map;
    }
}

void Explorer::perceive(const agent::Tick& tick) {
    const Seconds dt = run_.step(tick.now);
    takeReadings();
    watchScanner();
    if (const Seconds whole(settings_.drive_time_s); run_.isOver(whole))
        run_.ending = {true,
                       "Drove for " + fixed(whole.count(), 0) + " s and " + fixed(track_.distance_m(), 1) + " m."};
    if (waiting() || blind())
        track_.forgetPlaces();
    else
        stepManeuver(dt);
}

void Explorer::takeReadings() {
    if (ins_in_map_)
        track_.update(run_.now, *ins_in_map_, motion_);
    if (!std::exchange(scan_is_new_, false))
        return;
    watchForIce();
    if (frozen())
        return;
    scan_at_ = run_.now;
    const Pose base_in_map = track_.base_in_map();
    const Fence fence{ins_in_map_ ? area_in_map_ : Rectangle{}, base_in_map.position_m.head<2>(), base_in_map.yaw_rad};
    around_ = look(*scan_, sonars_, fence, settings_);
    const Third best = around_.mostOpen();
    const double lead = 1.0 + settings_.side_lead_pct / 100.0;
    if (around_.meanOf(best) > lead * around_.meanOf(chosen_))
        chosen_ = best;
}

/// Ignores scans with nothing in reach, which are all alike; see the class comment.
void Explorer::watchForIce() {
    const bool sees = std::ranges::any_of(scan_->ranges_m, [](double range_m) { return range_m < scanner_reach_m; });
    const bool same = sees && scan_->ranges_m == former_ranges_m_;
    former_ranges_m_ = scan_->ranges_m;
    const double step_m = track_.lastStep_m() + hull_radius_m * std::abs(track_.lastTurn_rad());
    moved_with_same_scan_m_ = same ? moved_with_same_scan_m_ + step_m : 0.0;
}

bool Explorer::frozen() const {
    return moved_with_same_scan_m_ > frozen_after_m;
}

void Explorer::watchScanner() {
    const bool silent = blind() && !waiting();
    if (silent && !blind_told_)
        events_.push_back(
            {Severity::Warning, frozen() ? "The range scanner is frozen: it says the same while the robot moves. The "
                                           "robot stands until it says something else."
                                         : "The range scanner is silent; the robot stands until it speaks."});
    blind_told_ = silent;
}

Seconds Explorer::scanAge() const {
    return scan_at_ && !frozen() ? run_.now - *scan_at_ : never;
}

bool Explorer::trapped() const {
    return maneuver_ == Maneuver::None && track_.progress_m(Seconds(settings_.trap_time_s)) < settings_.trap_radius_m;
}

bool Explorer::tooClose() const {
    return around_.ahead_m < settings_.safety_distance_m || around_.low_ahead_m < settings_.low_distance_m ||
           track_.descent_rad() > settings_.steepest_descent_rad;
}

bool Explorer::wayIsFree() const {
    return around_.ahead_m > settings_.safety_distance_m + free_beyond_m &&
           around_.low_ahead_m > settings_.low_distance_m + low_free_beyond_m;
}

void Explorer::stepManeuver(Seconds dt) {
    maneuver_time_ += dt;
    if (maneuver_ == Maneuver::Turning)
        return stepTurn();
    if (maneuver_ == Maneuver::None)
        return;
    backed_m_ += track_.lastStep_m();
    if (backed_m_ >= to_back_m_ || maneuver_time_ > longest_backing)
        beginTurn(settings_.turn_rad);
}

void Explorer::stepTurn() {
    turned_rad_ += std::abs(track_.lastTurn_rad());
    const Seconds longest(1.5 * 2.0 * pi / settings_.turn_rate_rad_s);
    const bool turned = turned_rad_ >= to_turn_rad_ && wayIsFree();
    if (!turned && turned_rad_ < 2.0 * pi && maneuver_time_ < longest)
        return;
    maneuver_ = Maneuver::None;
    straight_until_ = run_.now + Seconds(settings_.keep_straight_s);
}

/// Begins to back away from a danger. Turns that closely follow one another go to the same side.
void Explorer::backAway() {
    if (track_.distance_m() > side_kept_until_m_)
        turns_left_ = around_.betterToTheLeft();
    side_kept_until_m_ = track_.distance_m() + same_danger_m;
    beginBacking(std::min(settings_.back_distance_m, track_.wayBehind_m()));
}

void Explorer::beginBacking(double distance_m) {
    if (distance_m < least_way_back_m)
        return beginTurn(settings_.turn_rad);
    maneuver_ = Maneuver::Backing;
    maneuver_time_ = Seconds{0.0};
    to_back_m_ = distance_m;
    backed_m_ = 0.0;
}

void Explorer::beginTurn(double angle_rad) {
    maneuver_ = Maneuver::Turning;
    maneuver_time_ = Seconds{0.0};
    to_turn_rad_ = angle_rad;
    turned_rad_ = 0.0;
    track_.leaveWay();
}

protocol::SkidDrive Explorer::drive(double left_m_s, double right_m_s, Motion motion, const char* state) {
    motion_ = motion;
    run_.state = state;
    return {.left_rad_s = left_m_s / wheel_radius_m, .right_rad_s = right_m_s / wheel_radius_m};
}

protocol::SkidDrive Explorer::halt() {
    return drive(0.0, 0.0, Motion::Standing,
                 run_.paused ? "paused"
                 : frozen()  ? "waiting for another scan"
                 : blind()   ? "waiting for a scan"
                             : "at rest");
}

protocol::SkidDrive Explorer::reverse() {
    if (maneuver_ == Maneuver::None)
        backAway();
    if (maneuver_ == Maneuver::Turning) // No known ground behind the robot
        return turnAway();
    const double lead_m_s = turns_left_ ? backing_lead_m_s : -backing_lead_m_s;
    return drive(-backing_speed_m_s - lead_m_s, -backing_speed_m_s + lead_m_s, Motion::Back, "backing away");
}

protocol::SkidDrive Explorer::turnAway() {
    const double speed_m_s = settings_.turn_rate_rad_s * wheel_separation_m / 2.0 * (turns_left_ ? 1.0 : -1.0);
    return drive(-speed_m_s, speed_m_s, Motion::Turning, turns_left_ ? "turning left" : "turning right");
}

protocol::SkidDrive Explorer::goAhead() {
    const double speed_m_s = roamingSpeed_m_s();
    return drive(speed_m_s, speed_m_s, Motion::Straight, "heading ahead");
}

protocol::SkidDrive Explorer::steerLeft() {
    const double speed_m_s = roamingSpeed_m_s();
    return drive(innerShare(around_.left_m) * speed_m_s, speed_m_s, Motion::Curve, "heading left");
}

protocol::SkidDrive Explorer::steerRight() {
    const double speed_m_s = roamingSpeed_m_s();
    return drive(speed_m_s, innerShare(around_.right_m) * speed_m_s, Motion::Curve, "heading right");
}

double Explorer::roamingSpeed_m_s() const {
    const double before_things_m_s = speed_per_m_hz * (around_.ahead_m - scanner_margin_m);
    const double before_low_things_m_s = speed_per_m_hz * (around_.low_ahead_m - sonar_margin_m);
    const double free_m_s = settings_.cruise_speed_m_s * (track_.descent_rad() > downhill_rad ? downhill_share : 1.0);
    return std::max(least_speed_m_s, std::min({free_m_s, before_things_m_s, before_low_things_m_s}));
}

double Explorer::innerShare(double side_m) const {
    const double freedom = std::clamp((side_m - side_blocked_m) / (side_free_m - side_blocked_m), 0.0, 1.0);
    return std::lerp(1.0, tightest_inner_share, freedom);
}

void Explorer::escape() {
    const Vec2 here_m = track_.base_in_map().position_m.head<2>();
    const bool again = (here_m - std::exchange(escaped_from_m_, here_m)).norm() < same_trap_m;
    turns_left_ = !turns_left_;
    side_kept_until_m_ = track_.distance_m() + same_danger_m;
    track_.forgetPlaces();
    if (again)
        beginBacking(escape_back_m);
    else
        beginTurn(escape_rad);
}

} // namespace usar::p2dx
