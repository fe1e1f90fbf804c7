// Draws the layers of the map. One object a frame; holds references only.
#pragma once

#include <QPainter>

#include "widgets/height_layer.h"
#include "widgets/map_content.h"
#include "widgets/map_labels.h"
#include "widgets/theme.h"
#include "widgets/trace_layer.h"

namespace usar::widgets {

/// Every layer is drawn with one opacity. Dense layers are images or thin separate segments, never one thick polyline
/// (gui.md section 6). GUI thread.
class MapPainter {
public:
    MapPainter(QPainter& painter, const MapContent& content, const HeightLayer& heights, const TraceLayer& traces,
               const MapTransform& transform);

    /// All visible layers, lowest first.
    void paintLayers();

private:
    /// Under the layer's opacity, which the caller has set.
    void paint(MapLayer layer);
    /// Ground and picture at the layer's opacity; frame and name always in full.
    void paintWorld();
    void paintBackgroundImage();
    void paintGrid();
    /// Finished pages only, at the mip level that fits the scale, edges on whole pixels.
    void paintHeights();
    void paintArea();
    void paintAreaHandles(const Rectangle& area_in_map);
    void paintLanes();
    void paintTrails();
    /// Path marks closer than three pixels to the last one are left out; all others are drawn.
    void paintMarks();
    /// To scale, never smaller than a finger finds; way points of the selected one; what is dragged or would come.
    void paintObjects();
    void paintObject(const MapObject& object, bool selected);
    void paintWaypoints(const MapObject& object);
    /// Diamonds with an arrow along the yaw; the one under the cursor is larger and in the accent color.
    void paintStartPoses();
    void paintLaser();
    void paintGoals();
    /// Lines between robots in the color of their quality, with their dBm; dashed where there is no link.
    void paintRadio();
    void paintRobots();
    void paintStartPose(std::size_t start_pose);
    /// An arrowhead along the yaw; hollow and grey when stale.
    void paintRobot(const RobotOnMap& robot);
    /// Separate segments through the points, without those that are shorter than a pixel or out of sight.
    void paintSegments(const std::vector<Vec2>& points_m);
    /// On a backing of its own, so that it reads on every ground.
    void paintLabel(const QRectF& box_px, const QString& text, bool bold);

    QPainter& painter_;
    const MapContent& content_;
    const HeightLayer& heights_;
    const TraceLayer& traces_;
    const MapTransform& transform_;
    const Tokens& tokens_;
    const MapLabels labels_;
};

/// The mark's picture, for the map and its legend: shapes differ, so that color is never alone.
void paintMark(QPainter& painter, agent::MarkKind kind, const QPointF& center_px, double size_px);

/// The symbols of the map, around the painter's origin, turned clockwise from "up".
void paintStartPoseSymbol(QPainter& painter, double turn_rad, bool hot);
void paintRobotSymbol(QPainter& painter, double turn_rad, const QColor& color, bool stale);
/// A mast with waves.
void paintStationSymbol(QPainter& painter, const QColor& color, bool stale);

/// Around the painter's origin, in pixels; `selected` in the accent color.
void paintObjectSymbol(QPainter& painter, const QPolygonF& outline_px, bool selected);

/// Text on a raised chip; `at_px` is the chip's corner or middle named by `alignment`. Returns the chip.
QRectF paintChip(QPainter& painter, const QPointF& at_px, const QString& text, Qt::Alignment alignment);

} // namespace usar::widgets
