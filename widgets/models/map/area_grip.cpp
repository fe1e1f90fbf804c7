#include "widgets/models/map/area_grip.h"

#include <cmath>

namespace usar::widgets {

namespace {

Vec2 snapped(const Vec2& point_m, double snap_m) {
    return (point_m / snap_m).array().round().matrix() * snap_m;
}

Vec2 limited(const Vec2& point_m, const std::optional<Rectangle>& limits) {
    return limits ? Vec2(point_m.cwiseMax(limits->min_m).cwiseMin(limits->max_m)) : point_m;
}

Rectangle moved(const Rectangle& area, Vec2 by_m, const std::optional<Rectangle>& limits) {
    if (limits) {
        by_m = by_m.cwiseMin(limits->max_m - area.max_m);
        by_m = by_m.cwiseMax(limits->min_m - area.min_m);
    }
    return {area.min_m + by_m, area.max_m + by_m};
}

} // namespace

Vec2 gripPoint(const Rectangle& area, AreaGrip grip) {
    const Vec2 half(area.width_m() / 2.0, area.height_m() / 2.0);
    return area.center_m() + Vec2(grip.x * half.x(), grip.y * half.y());
}

std::optional<AreaGrip> gripAt(const Rectangle& area, const MapTransform& transform, const QPointF& point_px,
                               double reach_px) {
    std::optional<AreaGrip> best;
    double best_px = reach_px;
    for (const AreaGrip grip : area_handles) {
        const QPointF d = transform.toScreen(gripPoint(area, grip)) - point_px;
        if (const double distance_px = std::hypot(d.x(), d.y()); distance_px <= best_px) {
            best = grip;
            best_px = distance_px;
        }
    }
    if (!best && area.contains(transform.toMap(point_px)))
        best = AreaGrip{};
    return best;
}

Rectangle dragged(const Rectangle& area, const AreaDrag& drag, const std::optional<Rectangle>& limits, double snap_m) {
    if (drag.grip.middle())
        return moved(area, snapped(drag.to_m - drag.from_m, snap_m), limits);
    Vec2 low = area.min_m;
    Vec2 high = area.max_m;
    const Vec2 to = limited(snapped(drag.to_m, snap_m), limits);
    if (drag.grip.x != 0)
        (drag.grip.x < 0 ? low : high).x() = to.x();
    if (drag.grip.y != 0)
        (drag.grip.y < 0 ? low : high).y() = to.y();
    return {low.cwiseMin(high), low.cwiseMax(high)};
}

Rectangle spanned(const Vec2& a_m, const Vec2& b_m, const std::optional<Rectangle>& limits, double snap_m) {
    const Vec2 a = limited(snapped(a_m, snap_m), limits);
    const Vec2 b = limited(snapped(b_m, snap_m), limits);
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

} // namespace usar::widgets
