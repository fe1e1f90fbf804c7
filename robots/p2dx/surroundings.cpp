#include "robots/p2dx/surroundings.h"

#include <algorithm>
#include <cmath>

namespace usar::p2dx {

namespace {

/// Beams within this angle of straight ahead belong to neither side.
constexpr double middle_rad = radians(10.0);
constexpr double clearly_nearer = 0.8;

/// The sonars of a stock P2DX from left to right (robots-and-worlds.md 3.2).
struct SonarMount {
    const char* name;
    double yaw_rad;
};
constexpr std::array<SonarMount, 8> mounts{{{"F1", radians(90)},
                                            {"F2", radians(50)},
                                            {"F3", radians(30)},
                                            {"F4", radians(10)},
                                            {"F5", radians(-10)},
                                            {"F6", radians(-30)},
                                            {"F7", radians(-50)},
                                            {"F8", radians(-90)}}};
constexpr double front_rad = radians(40);
constexpr double diagonal_rad = radians(60);
/// Factor for the echoes of diagonal sonars, because what they hear is beside the strip unless it is near.
constexpr double diagonal_weight = 1.25;

double alongAxis_m(double at_m, double direction, double low_m, double high_m) {
    if (direction == 0.0)
        return Surroundings::far_m;
    return std::max(0.0, ((direction > 0.0 ? high_m : low_m) - at_m) / direction);
}

void hear(const std::vector<protocol::NamedRange>& sonars, Surroundings& around) {
    for (const protocol::NamedRange& echo : sonars) {
        const auto* const mount = std::ranges::find(mounts, echo.name, &SonarMount::name);
        if (mount == mounts.end() || !(echo.range_m > 0.0))
            continue;
        const double off_axis_rad = std::abs(mount->yaw_rad);
        if (off_axis_rad < diagonal_rad)
            around.low_ahead_m =
                std::min(around.low_ahead_m, echo.range_m * (off_axis_rad < front_rad ? 1.0 : diagonal_weight));
        double& side_m = mount->yaw_rad > 0.0 ? around.left_m : around.right_m;
        side_m = std::min(side_m, echo.range_m);
    }
}

} // namespace

double Fence::distance_m(double angle_rad) const {
    if (area_in_map.empty())
        return Surroundings::far_m;
    const double course_rad = yaw_rad + angle_rad;
    return std::min(
        alongAxis_m(robot_in_map_m.x(), std::cos(course_rad), area_in_map.min_m.x(), area_in_map.max_m.x()),
        alongAxis_m(robot_in_map_m.y(), std::sin(course_rad), area_in_map.min_m.y(), area_in_map.max_m.y()));
}

Third Surroundings::mostOpen() const {
    return std::ranges::max({Third::Ahead, Third::Left, Third::Right}, {},
                            [this](Third third) { return meanOf(third); });
}

bool Surroundings::betterToTheLeft() const {
    if (std::min(left_m, right_m) < clearly_nearer * std::max(left_m, right_m))
        return left_m > right_m;
    return meanOf(Third::Left) >= meanOf(Third::Right);
}

Surroundings look(const protocol::RangeScan& scan, const std::vector<protocol::NamedRange>& sonars, const Fence& fence,
                  const Settings& settings) {
    Surroundings around;
    std::array<int, 3> counts{};
    const std::size_t beams = scan.ranges_m.size();
    for (std::size_t beam = 0; beam < beams; ++beam) {
        const double angle_rad = scan.beamAngle_rad(beam);
        const double range_m = std::min(scan.ranges_m[beam], fence.distance_m(angle_rad));
        if (!(range_m >= 0.0)) // Also skips NaN
            continue;
        const std::size_t third = std::min<std::size_t>(2, 3 * beam / beams);
        around.mean_m[third] += range_m;
        ++counts[third];
        const double ahead_m = range_m * std::cos(angle_rad);
        if (ahead_m >= 0.0 && std::abs(range_m * std::sin(angle_rad)) < settings.strip_width_m / 2.0)
            around.ahead_m = std::min(around.ahead_m, ahead_m);
        if (std::abs(angle_rad) > middle_rad) {
            double& side_m = angle_rad > 0.0 ? around.left_m : around.right_m;
            side_m = std::min(side_m, range_m);
        }
    }
    for (std::size_t third = 0; third < counts.size(); ++third)
        around.mean_m[third] /= std::max(1, counts[third]);
    hear(sonars, around);
    return around;
}

} // namespace usar::p2dx
