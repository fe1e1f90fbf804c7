#include "widgets/models/map/map_object.h"

#include <algorithm>

#include "core/base/outline.h"

namespace usar::widgets {

namespace {

constexpr double least_px = 5.0; ///< smallest half size of an object on the screen

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

} // namespace

std::vector<Vec2> outlineOf(const MapObject& object) {
    switch (object.form) {
    case ObjectForm::Box:
        return outlineOfBox(object.body_in_map, object.size_m);
    case ObjectForm::Cylinder:
        return outlineOfCylinder(object.body_in_map, object.size_m);
    case ObjectForm::Sphere:
        break;
    }
    return outlineOfCylinder(Pose{object.body_in_map.position_m}, object.size_m); // However it has rolled.
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
