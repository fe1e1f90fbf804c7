#include "robots/airrobot/flight/reading_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace usar::airrobot {

namespace {

/// A robot that is told to fly so fast cannot have the same pose twice, to the last digit.
constexpr double moving_m_s = 0.2;
/// In a descent it can for a moment, and below a roof until it has noticed the roof and left it.
constexpr Seconds descent_patience{1.0};
constexpr Seconds climb_patience{3.0};
/// No robot is faster; a reading beyond that was damaged on its way, unless as many in a row say the same.
constexpr double fastest_m_s = 8.0;
constexpr double fastest_turn_rad_s = 4.0;
constexpr double jitter_m = 0.7;
constexpr double jitter_rad = 0.3;
/// The robot leans by at most 25 degrees, and as it sets off at once by 12 degrees within 0.2 s.
constexpr double fastest_lean_rad_s = 1.0;
constexpr double lean_jitter_rad = 0.3;
constexpr int believed_after = 3;
/// Ranges agree within this distance or this share of the greater one, whichever is more. The ground under a level scan
/// at an altitude of 6 m is within it from beam to beam up to the scanner's reach of 20 m.
constexpr double agree_m = 0.6;
constexpr double agree_share = 0.2;
constexpr std::size_t beside = 2;        ///< beams on each side with which a beam is compared
constexpr std::size_t beside_before = 4; ///< beams on each side of it in the last scan, because the robot rolls
constexpr double same_geometry = 0.01;   ///< share
/// From one reading to the next, 0.2 s later, the robot gets nearer by 0.4 m at most, and an echo may come from another
/// part of the same thing.
constexpr double sonar_jump_m = 1.0;
/// Two sonars that jump at once to ranges as equal as this hear one thing, such as a ledge as the robot rises to it.
constexpr double sonar_like_m = 0.6;
/// A ray that has met something so near shows what the robot is about to touch: the tip of a tree was heard once at
/// 0.8 m, 0.6 s before it broke the robot (`tst_random_surveys_campaign`, number 159552).
constexpr double farthest_glimpse_m = 1.5;
constexpr double nearest_glimpse_m = 0.2;
constexpr std::size_t most_glimpses = 4;
constexpr Seconds glimpses_within{120.0};
/// Noise of a thousandth of the range changes a number of four decimals nearly always.
constexpr int hangs_after = 5;
constexpr double touching_m = 0.5; ///< What is nearer may be at the least range of a sonar, which has no noise.

double between_rad(double one_rad, double other_rad) {
    return std::abs(normalizedAngle(one_rad - other_rad));
}

bool leansTooFar(const Pose& from_in_map, const Pose& to_in_map, double since_s) {
    return std::max(between_rad(from_in_map.roll_rad, to_in_map.roll_rad),
                    between_rad(from_in_map.pitch_rad, to_in_map.pitch_rad)) >
           lean_jitter_rad + fastest_lean_rad_s * since_s;
}

bool isTooFar(const Pose& from_in_map, const Pose& to_in_map, double since_s) {
    return (to_in_map.position_m - from_in_map.position_m).norm() > jitter_m + fastest_m_s * since_s ||
           between_rad(from_in_map.yaw_rad, to_in_map.yaw_rad) > jitter_rad + fastest_turn_rad_s * since_s ||
           leansTooFar(from_in_map, to_in_map, since_s);
}

bool agrees(double one_m, double other_m) {
    return std::abs(one_m - other_m) <= std::max(agree_m, agree_share * std::max(one_m, other_m));
}

/// True if a beam at most `within` beams beside `index` has about this range, be it the same beam or not.
bool hasLikeIt(const std::vector<double>& ranges_m, std::size_t index, double range_m, std::size_t within,
               bool itself) {
    const std::size_t first = index - std::min(index, within);
    const std::size_t end = std::min(ranges_m.size(), index + within + 1);
    for (std::size_t i = first; i < end; ++i)
        if ((itself || i != index) && agrees(ranges_m[i], range_m))
            return true;
    return false;
}

} // namespace

bool PoseCheck::believes(Seconds now, const Pose& pose_in_map, const Told& told) {
    lean_leapt_ = false;
    if (last_ && (hangs(now, pose_in_map, told) || leaps(now, pose_in_map)))
        return false;
    last_ = {now, pose_in_map};
    return true;
}

bool PoseCheck::hangs(Seconds now, const Pose& pose_in_map, const Told& told) {
    if (hung_at_ && pose_in_map == *hung_at_) {
        hanging_ = true;
        others_ = 0;
        return true;
    }
    if (hanging_ && ++others_ < believed_after)
        return true;
    hanging_ = false;
    const bool repeated = pose_in_map == last_->pose_in_map;
    const bool turned = told.climb_m_s * vertical_m_s_ < 0.0; // A robot that leaves a roof has climbed a moment ago.
    if (!repeated || std::abs(told.climb_m_s) <= moving_m_s)
        vertical_since_.reset();
    else if (!vertical_since_ || turned)
        vertical_since_ = last_->at;
    vertical_m_s_ = told.climb_m_s;
    const Seconds patience = told.climb_m_s > 0.0 ? climb_patience : descent_patience;
    hanging_ = repeated && (told.speed_m_s > moving_m_s || (vertical_since_ && now - *vertical_since_ >= patience));
    if (hanging_) {
        hung_at_ = pose_in_map;
        others_ = 0;
        vertical_since_.reset();
    }
    return hanging_;
}

bool PoseCheck::leaps(Seconds now, const Pose& pose_in_map) {
    const double since_s = (now - last_->at).count();
    if (!isTooFar(last_->pose_in_map, pose_in_map, since_s)) {
        leaps_ = 0;
        return false;
    }
    leaps_ = leaps_ == 0 || isTooFar(leapt_to_, pose_in_map, since_s) ? 1 : leaps_ + 1;
    leapt_to_ = pose_in_map;
    lean_leapt_ = leaps_ < believed_after && leansTooFar(last_->pose_in_map, pose_in_map, since_s);
    return leaps_ < believed_after;
}

std::vector<double> ScanCheck::believed(const protocol::RangeScan& scan) {
    if (isOtherGeometry(scan))
        return {};
    std::vector<double> ranges_m = scan.ranges_m;
    for (std::size_t i = 0; i < ranges_m.size(); ++i) {
        const double range_m = scan.ranges_m[i];
        if (!hasLikeIt(scan.ranges_m, i, range_m, beside, false) &&
            !hasLikeIt(last_m_, i, range_m, beside_before, true))
            ranges_m[i] = std::numeric_limits<double>::quiet_NaN();
    }
    last_m_ = scan.ranges_m;
    return ranges_m;
}

bool ScanCheck::isOtherGeometry(const protocol::RangeScan& scan) {
    const bool same = std::abs(scan.fov_rad - fov_rad_) <= same_geometry * fov_rad_ &&
                      std::abs(scan.resolution_rad - resolution_rad_) <= same_geometry * resolution_rad_;
    others_ = same ? 0 : others_ + 1;
    if (fov_rad_ > 0.0 && others_ > 0 && others_ < believed_after)
        return true;
    fov_rad_ = scan.fov_rad;
    resolution_rad_ = scan.resolution_rad;
    others_ = 0;
    return false;
}

void SonarCheck::begin(Seconds now, bool high) {
    nearer_m_.clear();
    now_ = now;
    high_ = high;
    while (!glimpses_.empty() && now - glimpses_.front() > glimpses_within)
        glimpses_.pop_front();
}

void SonarCheck::noteGlimpse(double told_m) {
    if (!high_ || told_m < nearest_glimpse_m || told_m > farthest_glimpse_m)
        return;
    glimpses_.push_back(now_);
    glimpsed_ = glimpses_.size() <= most_glimpses;
}

bool SonarCheck::believes(const Range& range, double told_m) {
    if (std::abs(told_m - range.believed_m) <= sonar_jump_m || std::abs(told_m - range.told_m) <= sonar_jump_m)
        return true;
    const double nearer_m = range.believed_m - sonar_jump_m;
    if (told_m > nearer_m)
        return false;
    const bool another =
        std::ranges::any_of(nearer_m_, [&](double other_m) { return std::abs(other_m - told_m) <= sonar_like_m; });
    nearer_m_.push_back(told_m);
    const bool again = range.told_m < nearer_m;
    if (!another && !again)
        noteGlimpse(told_m);
    else if (!glimpses_.empty() && (another || range.told_m < farthest_glimpse_m))
        glimpses_.pop_back(); // This reading confirms the last glimpse, so the link did not damage that.
    return another || again;
}

std::optional<double> SonarCheck::believed_m(const std::string& sonar, double range_m, bool echo, const Told& told) {
    glimpsed_ = false;
    const auto [known, is_new] = ranges_.try_emplace(sonar, Range{range_m, range_m});
    Range& range = known->second;
    const bool repeated = !is_new && echo && range_m > touching_m && range_m == range.told_m;
    if (!repeated)
        range.repeats = 0;
    else if (told.speed_m_s > moving_m_s)
        ++range.repeats;
    if (range.repeats >= hangs_after)
        return std::nullopt;
    if (!is_new && believes(range, range_m))
        range.believed_m = range_m;
    range.told_m = range_m;
    return range.believed_m;
}

} // namespace usar::airrobot
