// Places all names on the map for one frame so that none covers another, and defines the sizes of the symbols that they
// label.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QPointF>
#include <QRectF>

#include "widgets/map/map_content.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// A label that needs a place. All lengths are in pixels of the screen.
struct LabelWish {
    QPointF anchor_px;      ///< middle of its symbol
    double clear_px = 0.0;  ///< distance from there to the nearest edge of the label
    QSizeF size_px;         ///< size of the label's box
    bool must_show = false; ///< without free room it is placed below, over whatever is there
};

/// Returns a box for each wish, or nullopt if there is no room. Earlier wishes take precedence. Tries below, right,
/// left and above, first near and then a little farther away, because a symbol may lie under a larger one. `taken_px`
/// are boxes that no label may cover.
std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelWish>& wishes, std::vector<QRectF> taken_px);

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
    QRectF area;       ///< of the mission area's size and summary; empty if the area is out of sight or hidden
    QString area_text; ///< shortened if the view is narrow
};

/// "R1", or "R1 (stale)".
QString robotLabel(const MapRobot& robot);
/// Computes the boxes of the labels. Robots take precedence, the selected one first, then the mission area; names of
/// start poses move aside or are left out. None lies under the axes, at the edge of the view, or under the `legends_px`
/// if there is room elsewhere. Hidden layers take no room. GUI thread, because it measures fonts.
MapLabels placeMapLabels(const MapContent& content, const MapTransform& transform,
                         const std::vector<QRectF>& legends_px = {});

} // namespace usar::widgets
