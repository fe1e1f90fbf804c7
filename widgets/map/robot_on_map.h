// A robot on the map: what is known of it, and its mark or true outline.
#pragma once

#include <optional>
#include <vector>

#include <QPainter>
#include <QString>

#include "core/base/geometry.h"
#include "widgets/map/corrected_path.h"
#include "widgets/models/map/footprint.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/models/map/trail.h"

namespace usar::widgets {

/// A robot as the map needs it. `number` 1..9 selects its color and key.
struct MapRobot {
    QString name;
    int number = 1;
    /// Drawn from x, y and yaw; z appears only in the tooltip.
    Pose base_in_map;
    bool stale = false;       ///< the pose may be out of date
    bool station = false;     ///< a base station: it does not move and has no heading
    FootprintPtr footprint{}; ///< its true outline; nullptr: unknown
};

/// A robot with everything that belongs to it.
struct RobotOnMap {
    MapRobot robot;
    /// Path since the spawn, without stale poses.
    Trail trail;
    SharedPath corrected_in_map_m; ///< its path as the correction of its map has it; null: it has none
    /// Place toward which the behavior is driving; nullopt while it has no goal.
    std::optional<Vec3> goal_in_map_m;
    /// End points of the newest scan; NaN for beams that hit nothing.
    std::vector<Vec3> hits_in_map_m;
    /// Area of its newest behavior; empty: none. That of the selected robot is AreaOnMap's, which the user may change.
    Rectangle area_in_map;
};

/// How much of a robot is drawn as its outline, 0..1; the rest is its mark, which has the same size at every scale. An
/// outline that is shorter than a mark would be hard to see and to click; 0 where it is unknown.
double outlineShare(const MapRobot& robot, const MapTransform& transform);
/// Radius of what is drawn of a robot around its place, in pixels; with the ring if it is selected.
double reach_px(const MapRobot& robot, const MapTransform& transform, bool selected);
/// True if its outline is drawn and covers the point.
bool outlineCovers(const MapRobot& robot, const MapTransform& transform, const QPointF& point_px);
/// Paints mark, outline and ring; hollow and gray when stale. Leaves the painter's state as it was.
void paintRobot(QPainter& painter, const MapRobot& robot, const MapTransform& transform, bool selected);

} // namespace usar::widgets
