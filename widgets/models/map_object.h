// A thing of the world as map and list show it, and what it covers as seen from above.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/base/geometry.h"

namespace usar::widgets {

enum class ObjectForm { Box, Sphere, Cylinder };

struct MapObject {
    QString name;
    QString kind; ///< "Crate"; empty where nobody knows
    ObjectForm form = ObjectForm::Box;
    Vec3 size_m = Vec3::Ones(); ///< along its own axes
    Pose body_in_map;
    std::optional<double> speed_m_s;
    std::vector<Vec2> waypoints_in_map_m; ///< that it was given and has not lost
    bool carries = false;                 ///< a conveyor: its belt runs along its x axis
    bool operator==(const MapObject&) const = default;
};

/// The convex hull of its shadow under a high sun, counter-clockwise, in the map frame.
std::vector<Vec2> outlineOf(const MapObject& object);
/// Whether the point lies in or on a hull as outlineOf gives it.
bool covers(const std::vector<Vec2>& hull, const Vec2& point_m);

} // namespace usar::widgets
