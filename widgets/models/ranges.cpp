#include "widgets/models/ranges.h"

#include <algorithm>
#include <cmath>

#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "core/mapping/hit.h"

namespace usar::widgets {
namespace {

/// Returns the place in the ring: L4 = -4 … M0 = 0 … R4 = 4; other names come last.
long long ringPlace(const std::string& name) {
    constexpr long long last = 1000000;
    const auto number = name.size() > 1 ? readInteger(std::string_view(name).substr(1)) : std::nullopt;
    if (!number)
        return last;
    const char side = name.front();
    return side == 'L' ? -*number : side == 'M' ? 0 : side == 'R' ? *number : last;
}

} // namespace

double LaserSection::depthShown_m() const {
    double deepest_m = 0.0;
    for (const LaserRay& ray : rays)
        if (ray.hit && std::abs(ray.end_m.x()) <= 1.5 * ray.end_m.y())
            deepest_m = std::max(deepest_m, ray.end_m.y());
    for (const double depth_m : {2.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0})
        if (depth_m >= 1.15 * deepest_m && depth_m <= 1.25 * maximum_m && deepest_m > 0.0)
            return depth_m;
    return maximum_m;
}

LaserSection laserSection(const protocol::RangeScan& scan, double maximum_m) {
    LaserSection section;
    section.maximum_m = maximum_m;
    section.rays.reserve(scan.ranges_m.size());
    double sum_m = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
        const double range_m = scan.ranges_m[i];
        const double angle_rad = scan.beamAngle_rad(i);
        const bool hit = mapping::isHit(range_m, maximum_m);
        const double length_m = hit ? range_m : maximum_m;
        section.rays.push_back({QPointF(-std::sin(angle_rad), std::cos(angle_rad)) * length_m, hit});
        if (!hit)
            continue;
        section.nearest_m = std::min(section.nearest_m.value_or(range_m), range_m);
        if (std::abs(angle_rad) <= radians(2.0)) {
            sum_m += range_m * std::cos(angle_rad);
            ++count;
        }
    }
    if (count > 0)
        section.clearance_m = sum_m / count;
    return section;
}

agent::SonarZones zonesOf(const std::map<std::string, double>& ranges_m, double maximum_m) {
    agent::SonarZones all;
    for (const auto& [name, range_m] : ranges_m)
        all.zones.push_back({.name = name, .range_m = range_m, .maximum_m = maximum_m});
    std::ranges::stable_sort(all.zones, {}, [](const agent::SonarZone& zone) { return ringPlace(zone.name); });
    return all;
}

QString riskWord(agent::Risk risk) {
    const QString words[] = {QString(), QStringLiteral("low"), QStringLiteral("high")};
    return words[static_cast<std::size_t>(risk)];
}

} // namespace usar::widgets
