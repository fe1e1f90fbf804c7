#include "robots/airrobot/flight/landing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/QR>

namespace usar::airrobot {

namespace {

constexpr double body_radius_m = 1.2;
/// The base is known to be fit, but another place may have an edge that the drift of the pose makes it meet.
constexpr double roomy_radius_m = 2.2;
constexpr double even_m = 0.15;
/// A place on a slope is worse by this share of what makes it steeper than 6 degrees: the legs may find it steeper yet.
constexpr double slope_share = 0.4;
constexpr double easy_slope = 0.105;
/// A robot that sinks stays so far above all within this distance that is so much higher than the ground of its place.
constexpr double berth_m = 0.9;
constexpr double least_berth_m = 0.65; ///< Its rotors reach 0.5 m from its center.
constexpr double over_things_m = 1.2;
constexpr double no_ground_m = 1.0;
constexpr double low_m = 1.5; ///< over its place; lower, it is between those things, if there are any
constexpr double berth_step_m = 0.5;
/// The belly is so low between the legs that a board of 0.1 m below it breaks it. Few beams meet the top of a ball, so
/// that the scanner showed it only 0.07 m high (`tst_random_surveys_campaign`, number 161284).
constexpr double level_ground_m = 0.06;
constexpr double steepest_rad = radians(20.0); ///< steeper, it may slide
/// With 14 degrees and more between its legs and the ground, the robot fell onto its last leg so hard that it broke
/// (`tst_random_surveys_campaign`, numbers 74, 128 and 1059).
constexpr double gentle_rad = radians(14.0);
/// A place beside which the ground is so much lower, within this distance, is on top of something that may be a crown.
constexpr double stands_out_m = 1.5;
constexpr double stands_out_within_m = 3.5;
/// A battery that lasts no longer than a slow descent and this is spent on the descent.
constexpr Seconds spare_to_sink{5.0};
constexpr double ring_step_m = 1.0;
constexpr int spots = 12;
constexpr double seen_share = 0.8; ///< of the ground below the body
/// Where the middle of the ground that was seen is off by this share of the radius, the unseen part lies on one side,
/// and the ground may end there: beside the end of the world, the robot stood on two legs and fell (random survey 6).
constexpr double one_sided = 0.12;
constexpr double in_sight_m = 20.0; ///< as far as the scanner reaches
constexpr Seconds look_every{1.0};
constexpr double still_m_s = 0.06;
/// Slightly less than a second, because printed times are rounded.
constexpr Seconds still_needed{0.95};
constexpr double near_ground_m = 1.5;
/// Wind may push a robot that sinks so far from its place, around which there is room for it.
constexpr double over_place_m = 0.5;
constexpr double still_over_m = 0.9;
constexpr double nearly_down_m = 1.0;
constexpr Seconds longest_aside{15.0};
/// A robot in a hurry slows down bit by bit as it sinks, and is as slow as any other from this share of the height on.
constexpr double gentle_share = 0.43;
constexpr double apart_m = 1.5; ///< from a place that was no good to the next one
/// In need, it flies so much farther to ground that is not steep: on 20 degrees, it slid and turned over in a wind of
/// 3.8 m/s (`tst_random_surveys_campaign`, number 159488).
constexpr double farther_to_gentle_m = 6.0;
/// Any slope beyond this adds to the unevenness. Up to `even_m` of that is allowed, so that a plane of 16 degrees
/// passes.
constexpr double gentle_in_need_rad = radians(8.0);
/// Hits below the ring that differ by more than this in so many scans in a row are on something that it cannot stand
/// on.
constexpr double under_ring_m = 0.6;
constexpr double odd_m = 0.5;
constexpr int odd_scans = 3;
/// It turns around as it sinks between these heights over the ground, and lands so near to there.
constexpr double look_from_m = 3.0;
constexpr double look_to_m = 0.9;
constexpr double look_within_m = 2.0;
constexpr Seconds longest_look{12.0}; ///< Half a turn takes six.
/// A scanner with a bias sees the ground farther below. A robot that does not sink for so long stands on something.
constexpr double perhaps_ground_m = 4.0;
constexpr Seconds long_still{6.0};

/// How far these cells, within `radius_m`, depart from a plane, and more if that plane is steep for a robot that leans
/// as much, or by this share of its slope; infinite where too little is known.
double unevenness_m(const std::vector<Vec3>& tops_m, const Vec2& place_m, double steep_rad,
                    const Vec2& lean = Vec2::Zero(), double radius_m = body_radius_m, double share = 0.0) {
    const double disc_m2 = pi * radius_m * radius_m;
    const double seen_m2 = static_cast<double>(tops_m.size()) * ObstacleMemory::cell_m * ObstacleMemory::cell_m;
    if (tops_m.size() < 3 || seen_m2 < seen_share * disc_m2)
        return std::numeric_limits<double>::infinity();
    Vec2 middle_m = Vec2::Zero();
    for (const Vec3& top_m : tops_m)
        middle_m += (top_m.head<2>() - place_m) / static_cast<double>(tops_m.size());
    if (middle_m.norm() > one_sided * radius_m)
        return std::numeric_limits<double>::infinity();
    Eigen::MatrixX3d at(tops_m.size(), 3);
    Eigen::VectorXd height_m(tops_m.size());
    for (std::size_t i = 0; i < tops_m.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        at.row(row) << tops_m[i].x() - place_m.x(), tops_m[i].y() - place_m.y(), 1.0;
        height_m[row] = tops_m[i].z();
    }
    const Eigen::Vector3d plane = at.colPivHouseholderQr().solve(height_m);
    const double steep = std::max(0.0, (plane.head<2>() - lean).norm() - std::tan(steep_rad));
    const double slope = std::max(0.0, plane.head<2>().norm() - easy_slope);
    return (at * plane - height_m).cwiseAbs().maxCoeff() + steep + share * slope;
}

bool isEven(const ObstacleMemory& memory, const Vec2& place_m, double steep_rad) {
    return unevenness_m(memory.risenTops_m(place_m, body_radius_m), place_m, steep_rad) <= even_m;
}

/// True if the place is so much higher than the one that was wanted: on a crown, or on a roof.
bool isRaised(const ObstacleMemory& memory, const Vec2& place_m, const Vec2& wanted_m) {
    const auto there_m = memory.lowest_m(place_m, body_radius_m);
    const auto ground_m = memory.lowest_m(wanted_m, body_radius_m);
    return there_m && ground_m && *there_m > *ground_m + stands_out_m;
}

/// True if the place lies on top of something narrow. A crown is as even on top as the ground of a wood.
bool standsOut(const ObstacleMemory& memory, const Vec2& place_m) {
    const auto here_m = memory.lowest_m(place_m, body_radius_m);
    const auto around_m = memory.lowest_m(place_m, stands_out_within_m);
    return here_m && around_m && *around_m < *here_m - stands_out_m;
}

/// Judges ground by what the scanner has seen of it within `fresh`; for `lean` see landingPlace_m.
struct FreshGround {
    const ObstacleMemory& memory;
    Vec2 lean = Vec2::Zero();
    Seconds fresh{0.0};

    double unevenness_m(const Vec2& place_m, double radius_m) const {
        return airrobot::unevenness_m(memory.freshTops_m(place_m, radius_m, fresh), place_m, gentle_rad, lean, radius_m,
                                      slope_share);
    }
};

/// The evenest place within `radius_m` of `wanted_m`, which is so uneven itself.
Vec2 evenestPlace_m(const FreshGround& ground, const Vec2& wanted_m, double wanted_unevenness_m, double radius_m) {
    Vec2 best_m = wanted_m;
    double best_unevenness_m = wanted_unevenness_m;
    for (const double needed_m : {roomy_radius_m, body_radius_m}) {
        for (double ring_m = ring_step_m; ring_m <= radius_m && best_unevenness_m > level_ground_m;
             ring_m += ring_step_m) {
            for (int i = 0; i < spots; ++i) {
                const double bearing_rad = 2.0 * pi * i / spots;
                const Vec2 place_m = wanted_m + ring_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
                if (const double there_m = ground.unevenness_m(place_m, needed_m);
                    there_m < best_unevenness_m && !isRaised(ground.memory, place_m, wanted_m)) {
                    best_m = place_m;
                    best_unevenness_m = there_m;
                }
            }
        }
    }
    return best_m;
}

} // namespace

Vec2 landingPlace_m(const ObstacleMemory& memory, const Vec2& wanted_m, double radius_m, const Vec2& lean,
                    Seconds fresh) {
    const FreshGround ground{memory, lean, fresh};
    double uneven_m = ground.unevenness_m(wanted_m, body_radius_m);
    if (std::isinf(uneven_m)) // The robot comes from one side, and may not have seen the place just now.
        uneven_m = unevenness_m(memory.risenTops_m(wanted_m, body_radius_m), wanted_m, gentle_rad, lean, body_radius_m,
                                slope_share);
    if (std::isinf(uneven_m)) // It looks at it before it lands, see Touchdown::looksAround.
        return wanted_m;
    return evenestPlace_m(ground, wanted_m, uneven_m, radius_m);
}

bool canLand(const ObstacleMemory& memory, const Vec2& place_m, double dry_m) {
    const auto low_m = memory.lowest_m(place_m, body_radius_m);
    return low_m && *low_m >= dry_m && isEven(memory, place_m, steepest_rad);
}

void Refuge::note(const Senses& senses, const ObstacleMemory& memory, double dry_m) {
    if (noted_ && senses.now - *noted_ < look_every)
        return;
    noted_ = senses.now;
    if (canLand(memory, senses.position2_m(), dry_m) && !standsOut(memory, senses.position2_m()))
        last_m_ = senses.position2_m();
}

std::optional<Vec2> Refuge::place_m(const Senses& senses, const ObstacleMemory& memory, double dry_m,
                                    std::span<const Vec2> refused_m, Room room) const {
    const Vec2 here_m = senses.position2_m();
    const auto refused = [&](const Vec2& place_m) {
        return std::ranges::any_of(refused_m, [&](const Vec2& one_m) { return (one_m - place_m).norm() < apart_m; });
    };
    std::optional<Vec2> steep_m;  ///< the nearest one that is steep
    std::optional<Vec2> behind_m; ///< the nearest one to which something stands in the way
    std::optional<Vec2> raised_m; ///< the nearest one on top of something narrow
    double farthest_m = in_sight_m;
    const auto isBest = [&](const Vec2& place_m, double ring_m) {
        if (isEven(memory, place_m, gentle_in_need_rad))
            return true;
        if (!steep_m)
            farthest_m = std::min(farthest_m, ring_m + farther_to_gentle_m);
        steep_m = steep_m.value_or(place_m);
        return false;
    };
    if (!refused(here_m) && canLand(memory, here_m, dry_m) && !standsOut(memory, here_m) && isBest(here_m, 0.0))
        return here_m;
    for (double ring_m = ring_step_m; ring_m <= farthest_m; ring_m += ring_step_m) {
        const int places = spots + static_cast<int>(2.0 * ring_m);
        for (int i = 0; i < places; ++i) {
            const double bearing_rad = 2.0 * pi * i / places;
            const Vec2 place_m = here_m + ring_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
            if (refused(place_m) || !canLand(memory, place_m, dry_m))
                continue;
            std::optional<Vec2>& second_m = standsOut(memory, place_m) ? raised_m : behind_m;
            if (&second_m == &raised_m || !Touchdown::isClearBelow(senses, memory, place_m, room))
                second_m = second_m.value_or(place_m);
            else if (isBest(place_m, ring_m))
                return place_m;
        }
    }
    if (steep_m)
        return steep_m;
    if (behind_m)
        return behind_m;
    return last_m_ && !refused(*last_m_) ? last_m_ : raised_m;
}

void Touchdown::mindBattery(const Senses& senses, const Settings& settings) {
    const double height_m = senses.heightOverGround_m(0.0);
    if (sinks_anyway_ || !senses.robot_battery ||
        *senses.robot_battery > spare_to_sink + Seconds(height_m / settings.landing_speed_m_s))
        return;
    sinks_anyway_ = true;
    better_m_ = senses.position2_m();
}

bool Touchdown::isOver(const Senses& senses, const Vec2& place_m) {
    // So low, its legs may be on the ground already, and it would not answer.
    const bool nearly_down = over_ && senses.heightOverGround_m(0.0) < nearly_down_m;
    over_ = nearly_down || (senses.position2_m() - place_m).norm() < (over_ ? still_over_m : over_place_m);
    if (!over_) { // It holds its height, so it has not touched the ground. It looks around anew once it is over its
                  // place.
        still_since_.reset();
        turning_since_.reset();
        last_yaw_rad_.reset();
        turned_rad_ = better_m_ ? pi : 0.0;
    }
    return over_;
}

bool Touchdown::looksAround(const Senses& senses, const ObstacleMemory& memory, const Vec2& place_m, const Vec2& lean) {
    const double height_m = senses.heightOverGround_m(0.0);
    const bool begins = !turning_since_ && (height_m > look_from_m || height_m < look_to_m);
    if (sinks_anyway_ || begins || turned_rad_ >= pi)
        return false;
    if (!turning_since_)
        turning_since_ = senses.now;
    const double yaw_rad = senses.base_in_map.yaw_rad;
    turned_rad_ += std::abs(normalizedAngle(yaw_rad - last_yaw_rad_.value_or(yaw_rad)));
    last_yaw_rad_ = yaw_rad;
    if (turned_rad_ < pi)
        return senses.now - *turning_since_ < longest_look / senses.steadyShare();
    const FreshGround ground{memory, lean, senses.now - *turning_since_};
    // Where there is no ground on one side, it stands at the brink of something, such as the end of the world.
    const double uneven_m = ground.unevenness_m(place_m, body_radius_m);
    if (uneven_m > level_ground_m) {
        better_m_ = evenestPlace_m(ground, place_m, std::min(uneven_m, even_m), look_within_m);
        if ((*better_m_ - place_m).norm() > over_place_m)
            over_ = false; // So low, it would go on sinking on its way there, into what is uneven.
    }
    return false;
}

bool Touchdown::isClearBelow(const Senses& senses, const ObstacleMemory& memory, const Vec2& place_m, Room room) {
    const double z_m = senses.position_m().z();
    const auto height_m = [](const Vec3& top_m) { return top_m.z(); };
    const std::vector<Vec3> place_tops_m = memory.risenTops_m(place_m, body_radius_m);
    if (place_tops_m.empty())
        return true;
    const double ground_m = height_m(std::ranges::min(place_tops_m, {}, height_m));
    if (z_m < ground_m + low_m)
        return true;
    const double level_m = std::max(ground_m + no_ground_m, z_m - over_things_m);
    const auto blocks = [&](const Vec2& at_m) {
        const auto tops_m =
            room == Room::Least ? memory.freshTops_m(at_m, least_berth_m, lately) : memory.risenTops_m(at_m, berth_m);
        return std::ranges::any_of(tops_m, [&](const Vec3& top_m) { return top_m.z() > level_m; });
    };
    const Vec2 way_m = place_m - senses.position2_m();
    const int steps = static_cast<int>(way_m.norm() / berth_step_m) + 1;
    for (int step = 0; step <= steps; ++step)
        if (blocks(senses.position2_m() + way_m * step / steps))
            return false;
    return true;
}

bool Touchdown::isUneven(const Senses& senses) {
    if (!senses.scan)
        return uneven_scans_ >= odd_scans && !sinks_anyway_;
    double low_m = std::numeric_limits<double>::infinity();
    double high_m = -low_m;
    for (const Vec3& hit : senses.scan->hits_in_map_m)
        if ((hit.head<2>() - senses.position2_m()).norm() < under_ring_m) {
            low_m = std::min(low_m, hit.z());
            high_m = std::max(high_m, hit.z());
        }
    uneven_scans_ = high_m - low_m > odd_m ? uneven_scans_ + 1 : 0;
    return uneven_scans_ >= odd_scans && !sinks_anyway_;
}

bool Touchdown::keptAway(const Senses& senses, bool holds) {
    if (holds) // So it has not touched the ground.
        still_since_.reset();
    if (!holds || sinks_anyway_)
        held_since_.reset();
    else if (!held_since_)
        held_since_ = senses.now;
    return held_since_ && senses.now - *held_since_ > longest_aside / senses.steadyShare();
}

double Touchdown::sinkRate_m_s(const Senses& senses, const Settings& settings) const {
    const double height_m = senses.heightOverGround_m(0.0);
    if (height_m >= settings.landing_slow_below_m)
        return settings.descent_speed_m_s;
    if (!settings.hurried())
        return settings.landing_speed_m_s;
    const double share = (height_m / settings.landing_slow_below_m - gentle_share) / (1.0 - gentle_share);
    return std::lerp(settings.landing_speed_m_s, settings.descent_speed_m_s, std::max(0.0, share));
}

bool Touchdown::touched(const Senses& senses) {
    const bool still = std::abs(senses.velocity_in_map_m_s.z()) < still_m_s;
    const double height_m = senses.heightOverGround_m(0.0);
    if (!still || height_m >= perhaps_ground_m)
        still_since_.reset();
    else if (!still_since_)
        still_since_ = senses.now;
    const Seconds needed = senses.late + (height_m < near_ground_m ? still_needed : long_still);
    return still_since_ && senses.now - *still_since_ >= needed;
}

} // namespace usar::airrobot
