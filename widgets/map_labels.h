// The places of all names on the map for one frame, and the sizes of the symbols that they stand beside.
#pragma once

#include <map>

#include "widgets/map_content.h"
#include "widgets/models/map_transform.h"

namespace usar::widgets {

/// Half the size of a symbol on the screen, in pixels, whatever the scale.
namespace symbol {
inline constexpr double diamond_px = 8.0; ///< a start pose
inline constexpr double arrow_px = 15.0;  ///< its direction, from the diamond outwards
inline constexpr double robot_px = 11.0;
inline constexpr double ring_px = 18.0; ///< around the selected robot
} // namespace symbol

struct MapLabels {
    std::map<QString, QRectF> robots;
    std::vector<std::optional<QRectF>> start_poses; ///< in the order of the content; nothing: no room for the name
};

/// "R1", or "R1 (stale)".
QString robotLabel(const MapRobot& robot);
/// Robots win, the selected one first; names of start poses move aside or make way, also for the axes in the corner and
/// at the edge of the view. Hidden layers take no room. GUI thread, for the fonts.
MapLabels placeMapLabels(const MapContent& content, const MapTransform& transform);

} // namespace usar::widgets
