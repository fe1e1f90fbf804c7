#include "robots/airrobot/flight/overhead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace usar::airrobot {

namespace {

/// Hits of one ceiling agree within this height, and lie farther apart than those of a wall or of one crown.
constexpr double flat_m = 0.12;
constexpr double wide_m = 2.5;
constexpr std::size_t least_hits = 4;
/// A ceiling on which fewer hits lie shows in two scans of one look, at this height or nearly so. A crown with four
/// hits looked like one in a single scan, and the robot flew below it for 20 minutes (`quick_scan`, seed 4145). In
/// rooms, a look shows seven or eight hits, but often in one scan only.
constexpr std::size_t sure_hits = 5;
constexpr double passed_m = 0.5; ///< A beam that ends so much higher than a ceiling has not hit it.
constexpr Seconds one_look{1.5};
constexpr double same_height_m = 0.4;
constexpr double above_m = 0.3;
/// Where something higher than the robot stands within this distance, something may be above the robot, too: among
/// trees, crowns are ahead and behind as well, where the scanner does not look.
constexpr double crowded_m = 20.0;
/// Finds nearer to one another than this are one, but not what lies beyond a small one.
constexpr double same_place_m = 5.0;
constexpr double another_m = 1.0; ///< One that is so much lower is another one, such as a beam below a roof.
/// Beams of two scans in a row that get so far above a ceiling nearby show that it was a crown, or wind that pressed
/// the robot down. The attitude is not known well enough for less.
constexpr double surely_above_m = 1.3;
/// The same if the drift of the INS's lean is not known: 0.2 rad make 2 m at 10 m.
constexpr double surely_above_drift_m = 3.3;
constexpr double least_push_m_s = 0.12;
/// A climb that gains less than this share of the way in this time has met something.
constexpr Seconds push_time{1.4};
constexpr double pushed_share = 0.25;
/// The time constant with which the rate of a climb follows its command: `tall_test`, a robot at 2 m/s beside crowns.
constexpr Seconds answer_time{0.6};
/// A robot that is so fast on the level is held by nothing: what it touched would turn it over.
constexpr double slides_at_most_m_s = 1.5;
constexpr double sinks_m = 0.03; ///< An estimate that wavers by less than this does not show that the robot sinks.
/// A robot that gets so far above a ceiling shows that there is none: on a slow link, a climb begins late.
constexpr double through_m = 0.3;
constexpr double lifted_m = 0.6; ///< A lower robot may not have left the ground yet.
/// Within this time, a robot in a building sees the floor between what stands on it. Its estimate of the height has
/// been off by 0.75 m in half an hour (`tst_random_surveys_campaign`, number 156413); a floor that is lower by more is
/// another.
constexpr Seconds sees_floor_within{15.0};
constexpr double most_drift_m = 1.2;

/// A wall is upright over this height, up to the robot or nearly so, in so many scans in a row: one of a trunk is not,
/// because the robot passes it.
constexpr double upright_m = 0.1;
constexpr double wall_height_m = 1.5;
constexpr double nearly_m = 0.5;
constexpr int wall_scans = 5;

/// True if the first of these hits, in the order of the beams, lie on something upright that reaches up to `level_m`
/// (map z).
bool startsWall(std::span<const Vec3> hits, const Vec3& from_m, double level_m) {
    const double away_m = (hits.front() - from_m).head<2>().norm();
    double low_m = hits.front().z();
    double high_m = low_m;
    std::size_t count = 0;
    for (; count < hits.size() && std::abs((hits[count] - from_m).head<2>().norm() - away_m) < upright_m; ++count) {
        low_m = std::min(low_m, hits[count].z());
        high_m = std::max(high_m, hits[count].z());
    }
    return count >= least_hits && high_m - low_m >= wall_height_m && high_m > level_m;
}

struct LevelHits {
    double z_m = 0.0; ///< the lowest
    std::size_t count = 0;
};

/// The ceiling that the first of these hits, in the order of the beams, lie on. Their beams turn evenly, so hits on a
/// level plane move steadily outward or inward.
std::optional<LevelHits> ceilingFrom(std::span<const Vec3> hits, const Vec3& from_m) {
    double low_m = hits.front().z();
    double high_m = low_m;
    std::size_t count = 0;
    double last_m = 0.0;
    int direction = 0;
    for (; count < hits.size(); ++count) {
        const Vec3& hit = hits[count];
        if (hit.z() < from_m.z() + above_m || std::max(high_m, hit.z()) - std::min(low_m, hit.z()) > flat_m)
            break;
        const double away_m = (hit - from_m).head<2>().norm();
        const int outward = away_m > last_m ? 1 : -1;
        if (count > 1 && outward != direction)
            break;
        direction = count > 0 ? outward : 0;
        last_m = away_m;
        low_m = std::min(low_m, hit.z());
        high_m = std::max(high_m, hit.z());
    }
    if (count < least_hits || (hits[count - 1] - hits.front()).head<2>().norm() < wide_m)
        return std::nullopt;
    return LevelHits{low_m, count};
}

/// True if a beam that is steeper than those that hit `patch` has passed its height: that is the underside of a crown
/// or of a floor on posts, and nothing like it is above the robot.
bool endsBeforeRobot(const PlacedScan& scan, std::span<const Vec3> patch) {
    const Vec3 from_m = scan.base_in_map.position_m;
    const auto away_m = [&](const Vec3& at) { return (at - from_m).head<2>().norm(); };
    const Vec3 near = std::ranges::min(patch, {}, away_m);
    const auto passes = [&](const Vec3& end) {
        const double risen_m = end.z() - from_m.z();
        const double level_m = near.z() - from_m.z();
        const bool same_side = (end - from_m).head<2>().dot((near - from_m).head<2>()) > 0.0;
        return same_side && risen_m > level_m + passed_m && away_m(end) * level_m < away_m(near) * risen_m;
    };
    return std::ranges::any_of(scan.hits_in_map_m, passes) || std::ranges::any_of(scan.misses_in_map_m, passes);
}

} // namespace

void Overhead::observe(const Senses& senses, const Doing& doing) {
    found_.reset();
    lookDown(senses);
    if (senses.scan) {
        lookUp(*senses.scan, senses.now, doing.ascending);
        lookBeside(*senses.scan, senses.now);
    }
    feelAbove(senses, doing.climb_m_s);
    const Vec3 here_m = senses.position_m();
    std::erase_if(ceilings_, [&](const Ceiling& one) {
        return here_m.z() > one.z_m + through_m && (one.at_m - here_m.head<2>()).norm() < same_place_m;
    });
}

void Overhead::lookDown(const Senses& senses) {
    if (!senses.ground_m)
        return;
    if (const Seconds since = senses.now - floor_since_; since > sees_floor_within) {
        floor_since_ = senses.now;
        const double floor_m = std::exchange(floor_now_m_, unknown_floor_m);
        floor_before_m_ = since < 2.0 * sees_floor_within ? floor_m : unknown_floor_m;
    }
    floor_now_m_ = std::min(floor_now_m_, *senses.ground_m);
}

/// Returns the present height (map z) of a ceiling that was at `z_m` when the floor seemed to be at `floor_then_m`.
double Overhead::drifted_m(double z_m, double floor_then_m) const {
    const double sunk_m = floor_then_m - floor_m();
    const bool known = floor_then_m < unknown_floor_m && floor_m() < unknown_floor_m;
    return known && sunk_m > 0.0 && sunk_m < most_drift_m ? z_m - sunk_m : z_m;
}

void Overhead::lookUp(const PlacedScan& scan, Seconds now, bool ascending) {
    const Vec3 from_m = scan.base_in_map.position_m;
    const bool crowded = std::ranges::any_of(scan.hits_in_map_m, [&](const Vec3& hit) {
        return hit.z() > from_m.z() + above_m && (hit - from_m).head<2>().norm() < crowded_m;
    });
    const double twice_m = std::min(scan.highest_near_m, std::exchange(highest_near_m_, scan.highest_near_m));
    lookPast(twice_m - (scan.lean_known ? surely_above_m : surely_above_drift_m), now);
    seen_to_m_ = std::max(seen_to_m_, scan.highest_m);
    if (!crowded && scan.lean_known)
        free_to_m_ = std::max(free_to_m_, scan.highest_m);
    const std::span<const Vec3> hits(scan.hits_in_map_m);
    for (std::size_t first = 0; ascending && first < hits.size(); ++first)
        if (const auto level = ceilingFrom(hits.subspan(first), from_m)) {
            if (endsBeforeRobot(scan, hits.subspan(first, level->count)))
                return;
            const auto before = std::exchange(glimpse_, Glimpse{level->z_m, now});
            const bool again =
                before && now - before->time < one_look && std::abs(before->z_m - level->z_m) < same_height_m;
            if (again || level->count >= sure_hits)
                add({.at_m = from_m.head<2>(),
                     .z_m = again ? std::min(before->z_m, level->z_m) : level->z_m,
                     .found_at = now});
            return;
        }
}

void Overhead::lookPast(double past_m, Seconds now) {
    const auto justTouched = [&](const Ceiling& one) { return one.touched && now - one.found_at < touch_memory; };
    std::erase_if(ceilings_, [&](const Ceiling& one) { return past_m > one.z_m && !justTouched(one); });
    for (Ceiling& one : ceilings_)
        if (past_m > one.z_m)
            one.reach_m = small_reach_m;
}

void Overhead::lookBeside(const PlacedScan& scan, Seconds now) {
    const Vec3 from_m = scan.scanner_in_map.position_m;
    const std::span<const Vec3> hits(scan.hits_in_map_m);
    bool wall = false;
    for (std::size_t first = 0; !wall && first < hits.size(); ++first)
        wall = startsWall(hits.subspan(first), from_m, from_m.z() - nearly_m);
    walls_ = wall ? walls_ + 1 : 0;
    if (walls_ >= wall_scans)
        walled_at_ = now;
}

void Overhead::feelAbove(const Senses& senses, double commanded_climb_m_s) {
    const double z_m = senses.position_m().z();
    const Seconds since_last = senses.now - std::exchange(felt_at_, senses.now);
    const bool on_ground = senses.heightOverGround_m(lifted_m) < lifted_m;
    const bool may_be_held = senses.velocity_in_map_m_s.head<2>().norm() < slides_at_most_m_s;
    // A robot on a late link climbs more gently, and pushes all the same.
    if (commanded_climb_m_s < least_push_m_s * senses.steadyShare() || on_ground || !may_be_held) {
        pushing_since_.reset();
        return;
    }
    const double answered = std::min(1.0, since_last / answer_time);
    pushed_m_s_ += answered * (commanded_climb_m_s - pushed_m_s_); // It follows a command that grew bit by bit.
    pushed_m_ += pushed_m_s_ * since_last.count();
    const double gained_m = z_m - pushed_from_m_;
    const bool still_sinks = gained_m < -sinks_m; // The climb has not begun yet, and nothing above holds it up.
    if (!pushing_since_ || still_sinks || gained_m > pushed_share * commanded_climb_m_s * push_time.count()) {
        pushing_since_ = senses.now;
        pushed_from_m_ = z_m;
        pushed_m_ = 0.0;
        pushed_m_s_ = 0.0;
    } else if (senses.now - *pushing_since_ >= push_time + senses.late) {
        pushing_since_.reset();
        if (gained_m < pushed_share * pushed_m_)
            add({.at_m = senses.position2_m(), .z_m = z_m, .touched = true, .found_at = senses.now});
    }
}

void Overhead::add(const Ceiling& ceiling) {
    had_ceiling_ = true;
    const auto known = std::ranges::find_if(ceilings_, [&](const Ceiling& one) {
        const double away_m = (one.at_m - ceiling.at_m).norm();
        return away_m < std::min(same_place_m, one.reach_m) &&
               ceiling.z_m > drifted_m(one.z_m, one.floor_m) - another_m;
    });
    if (known == ceilings_.end()) {
        const bool anew = std::ranges::none_of(
            ceilings_, [&](const Ceiling& one) { return std::abs(one.z_m - ceiling.z_m) < same_height_m; });
        ceilings_.push_back(ceiling);
        ceilings_.back().floor_m = floor_m();
        found_ = {ceiling.z_m, ceiling.touched, anew};
        return;
    }
    if (ceiling.z_m < drifted_m(known->z_m, known->floor_m) - flat_m)
        found_ = {ceiling.z_m, ceiling.touched};
    known->z_m = std::min(known->z_m, ceiling.z_m);
    known->floor_m = floor_m();
    known->touched = known->touched && ceiling.touched;
    known->found_at = ceiling.found_at;
}

std::optional<double> Overhead::ceiling_m(const Vec2& at_m) const {
    std::optional<double> lowest_m;
    if (lid_m_)
        lowest_m = drifted_m(*lid_m_, lid_floor_m_);
    for (const Ceiling& one : ceilings_) {
        const double z_m = drifted_m(one.z_m, one.floor_m);
        if ((one.at_m - at_m).norm() < one.reach_m)
            lowest_m = std::min(lowest_m.value_or(z_m), z_m);
    }
    return lowest_m;
}

double Overhead::nearestFind_m(const Vec2& at_m, double otherwise_m) const {
    for (const Ceiling& one : ceilings_)
        otherwise_m = std::min(otherwise_m, (one.at_m - at_m).norm());
    return otherwise_m;
}

double Overhead::limit_m(const Vec2& at_m) const {
    const auto ceiling = ceiling_m(at_m);
    return ceiling ? *ceiling - margin_m : std::numeric_limits<double>::infinity();
}

double Overhead::allowed_m_s(const Senses& senses, double climb_m_s, double at_most_m_s) const {
    if (climb_m_s <= 0.0)
        return climb_m_s;
    const double room_m = limit_m(senses.position2_m()) - senses.position_m().z();
    return std::min({climb_m_s, std::max(0.0, room_m), at_most_m_s});
}

} // namespace usar::airrobot
