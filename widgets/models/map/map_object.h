// An object of the world as map and list show it, and its outline as seen from above.
#pragma once

#include <optional>
#include <vector>

#include <QPolygonF>
#include <QString>

#include "core/base/geometry.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Basic shape. Spheres and cylinders have the diameter size_m.x(); a cylinder's axis is its z axis.
enum class ObjectForm { Box, Sphere, Cylinder };

/// An object of the world as the server or the simulator reports it.
struct MapObject {
    /// Name on the server, which identifies the object.
    QString name;
    QString kind; ///< "Crate"; empty: unknown
    ObjectForm form = ObjectForm::Box;
    Vec3 size_m = Vec3::Ones(); ///< in meters along its own axes
    /// Pose of the object's center.
    Pose body_in_map;
    std::optional<double> speed_m_s;      ///< nullopt: unknown
    std::vector<Vec2> waypoints_in_map_m; ///< the way that it was given, if any
    bool carries = false;                 ///< a conveyor; its belt runs along its own x axis
    bool operator==(const MapObject&) const = default;
};

/// Convex hull of the object as seen from above, counter-clockwise, in meters of the map frame.
std::vector<Vec2> outlineOf(const MapObject& object);
/// The same in pixels of the screen. A small object is enlarged around its center, so that it can be seen and clicked.
QPolygonF outlineOnScreen(const MapObject& object, const MapTransform& transform);
/// The object with its center at another place of the ground, at the same height.
MapObject movedTo(MapObject object, const Vec2& center_in_map_m);
/// True if the point is inside or on a hull as outlineOf returns it.
bool covers(const std::vector<Vec2>& hull, const Vec2& point_m);

} // namespace usar::widgets
