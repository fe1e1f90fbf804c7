// Places all names on the map for one frame, and defines the sizes of the symbols that they label.
#pragma once

#include <map>

#include "widgets/map/map_content.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Half the size of each symbol on the screen, in pixels, independent of the map's scale.
namespace symbol {
inline constexpr double diamond_px = 8.0; ///< start pose
inline constexpr double arrow_px = 15.0;  ///< arrow of a start pose, from the diamond outward
inline constexpr double robot_px = 11.0;
inline constexpr double ring_px = 18.0; ///< ring around the selected robot
} // namespace symbol

/// Boxes of the names in pixels.
struct MapLabels {
    std::map<QString, QRectF> robots;
    std::vector<std::optional<QRectF>> start_poses; ///< in the order of the content; nullopt: no room for the name
};

/// "R1", or "R1 (stale)".
QString robotLabel(const MapRobot& robot);
/// Computes the boxes of the labels. Robots take precedence, the selected one first; names of start poses move aside or
/// are left out, also near the axes in the corner and at the edge of the view. Hidden layers take no room. GUI thread,
/// because it measures fonts.
MapLabels placeMapLabels(const MapContent& content, const MapTransform& transform);

} // namespace usar::widgets
