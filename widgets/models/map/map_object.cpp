#include "widgets/models/map/map_object.h"

#include <algorithm>
#include <cmath>

namespace usar::widgets {

namespace {

constexpr int corners_of_a_circle = 24;
constexpr double least_px = 5.0; ///< smallest half size of an object on the screen

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Computes the convex hull with Andrew's monotone chain.
std::vector<Vec2> hullOf(std::vector<Vec2> points) {
    std::ranges::sort(points,
                      [](const Vec2& a, const Vec2& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); });
    std::vector<Vec2> hull;
    const auto addAll = [&hull](auto first, auto last) {
        const std::size_t begin = hull.size();
        for (; first != last; ++first) {
            while (hull.size() >= begin + 2 && cross(hull[hull.size() - 2], hull.back(), *first) <= 0.0)
                hull.pop_back();
            hull.push_back(*first);
        }
        hull.pop_back(); // The other chain begins with this point.
    };
    addAll(points.begin(), points.end());
    addAll(points.rbegin(), points.rend());
    return hull;
}

std::vector<Vec3> pointsOf(const MapObject& object) {
    std::vector<Vec3> points;
    const Vec3 half_m = object.size_m / 2.0;
    if (object.form == ObjectForm::Box) {
        for (int corner = 0; corner < 8; ++corner)
            points.emplace_back(corner & 1 ? half_m.x() : -half_m.x(), corner & 2 ? half_m.y() : -half_m.y(),
                                corner & 4 ? half_m.z() : -half_m.z());
        return points;
    }
    for (int i = 0; i < corners_of_a_circle; ++i) {
        const double angle_rad = 2.0 * pi * i / corners_of_a_circle;
        const Vec2 on_circle(half_m.x() * std::cos(angle_rad), half_m.y() * std::sin(angle_rad));
        points.emplace_back(on_circle.x(), on_circle.y(), half_m.z());
        points.emplace_back(on_circle.x(), on_circle.y(), -half_m.z());
    }
    return points;
}

} // namespace

std::vector<Vec2> outlineOf(const MapObject& object) {
    MapObject seen = object;
    if (object.form == ObjectForm::Sphere) { // Its rotation does not matter.
        seen.size_m.z() = 0.0;
        seen.body_in_map = Pose{object.body_in_map.position_m};
    }
    std::vector<Vec2> points;
    for (const Vec3& point_m : pointsOf(seen))
        points.emplace_back((seen.body_in_map * point_m).head<2>());
    return hullOf(std::move(points));
}

QPolygonF outlineOnScreen(const MapObject& object, const MapTransform& transform) {
    QPolygonF outline;
    for (const Vec2& corner_m : outlineOf(object))
        outline << transform.toScreen(corner_m);
    const QPointF center = transform.toScreen(object.body_in_map.position_m.head<2>());
    const QRectF bounds = outline.boundingRect();
    const double half = std::max(bounds.width(), bounds.height()) / 2.0;
    if (half > 0.0 && half < least_px)
        for (QPointF& corner : outline)
            corner = center + (corner - center) * least_px / half;
    return outline;
}

MapObject movedTo(MapObject object, const Vec2& center_in_map_m) {
    object.body_in_map.position_m.head<2>() = center_in_map_m;
    return object;
}

bool covers(const std::vector<Vec2>& hull, const Vec2& point_m) {
    for (std::size_t i = 0; i < hull.size(); ++i)
        if (cross(hull[i], hull[(i + 1) % hull.size()], point_m) < 0.0)
            return false;
    return hull.size() >= 3;
}

} // namespace usar::widgets
