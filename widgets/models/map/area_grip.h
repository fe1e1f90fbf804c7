// Arithmetic of the mission area while a corner, an edge or the middle is dragged.
#pragma once

#include <array>
#include <optional>

#include <QPointF>

#include "core/base/geometry.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// The part of the area that is held: -1 is the low side of that axis, +1 the high side, 0 neither; both 0 is the
/// middle.
struct AreaGrip {
    int x = 0;
    int y = 0;
    bool middle() const { return x == 0 && y == 0; }
    bool operator==(const AreaGrip&) const = default;
};

/// Corners and edges; each is drawn as a handle.
inline constexpr std::array<AreaGrip, 8> area_handles = {
    {{-1, -1}, {-1, 0}, {-1, 1}, {0, -1}, {0, 1}, {1, -1}, {1, 0}, {1, 1}}};

/// Position of a handle, in meters of the map frame.
Vec2 gripPoint(const Rectangle& area_in_map, AreaGrip grip);
/// Returns the nearest handle within `reach_px`, else the middle if the point is inside the area, else nullopt.
std::optional<AreaGrip> gripAt(const Rectangle& area_in_map, const MapTransform& transform, const QPointF& point_px,
                               double reach_px = 12.0);

/// A drag from one point of the ground to another, in meters of the map frame.
struct AreaDrag {
    AreaGrip grip;
    Vec2 from_m = Vec2::Zero();
    Vec2 to_m = Vec2::Zero();
};
/// Returns the area after the drag: dragged sides are on multiples of `snap_m` and within `limits` if given; the middle
/// moves the whole area in multiples of `snap_m`. Sides may be dragged past each other. May be empty.
Rectangle dragged(const Rectangle& area_in_map, const AreaDrag& drag, const std::optional<Rectangle>& limits,
                  double snap_m = 0.5);
/// Returns the area between two points of the ground, snapped and limited likewise. May be empty.
Rectangle spanned(const Vec2& a_m, const Vec2& b_m, const std::optional<Rectangle>& limits, double snap_m = 0.5);

} // namespace usar::widgets
