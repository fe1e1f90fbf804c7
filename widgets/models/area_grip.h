// How a dragged corner, edge or middle changes the mission area. Arithmetic only.
#pragma once

#include <array>
#include <optional>

#include <QPointF>

#include "core/base/geometry.h"
#include "widgets/models/map_transform.h"

namespace usar::widgets {

/// What of the area is held: -1 is the low side of that axis, +1 the high side, 0 neither; both 0 is the middle.
struct AreaGrip {
    int x = 0;
    int y = 0;
    bool middle() const { return x == 0 && y == 0; }
    bool operator==(const AreaGrip&) const = default;
};

/// Corners and edges, each drawn as a handle.
inline constexpr std::array<AreaGrip, 8> area_handles = {
    {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};

/// Where a handle sits, in the map frame.
Vec2 gripPoint(const Rectangle& area_in_map, AreaGrip grip);
/// The nearest handle within `reach_px`, else the middle when the point is inside, else nothing.
std::optional<AreaGrip> gripAt(const Rectangle& area_in_map, const MapTransform& transform, const QPointF& point_px,
                               double reach_px = 12.0);

/// A drag from one ground point to another.
struct AreaDrag {
    AreaGrip grip;
    Vec2 from_m = Vec2::Zero();
    Vec2 to_m = Vec2::Zero();
};
/// The area after the drag: sides on multiples of `snap_m`, within `limits` where given. Sides may swap.
Rectangle dragged(const Rectangle& area_in_map, const AreaDrag& drag, const std::optional<Rectangle>& limits,
                  double snap_m = 0.5);
/// The area between two ground points, snapped and limited likewise.
Rectangle spanned(const Vec2& a_m, const Vec2& b_m, const std::optional<Rectangle>& limits, double snap_m = 0.5);

} // namespace usar::widgets
