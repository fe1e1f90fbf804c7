// Draws the layers of the map, or a part of them. One object for each part; it only holds references.
#pragma once

#include <QPainter>

#include "widgets/map/height_layer.h"
#include "widgets/map/map_content.h"
#include "widgets/map/map_labels.h"
#include "widgets/map/trace_layer.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

/// Each layer has one opacity. Dense layers are images or thin separate segments, never one thick polyline (window.md
/// section 6). GUI thread; everything passed to the constructor must outlive the painter.
class MapPainter {
public:
    /// `part_px` is the part of the view that is painted; `labels` are those of the whole view.
    MapPainter(QPainter& painter, const MapContent& content, const HeightLayer& heights, const TraceLayer& traces,
               const MapTransform& transform, const MapLabels& labels, const QRectF& part_px);

    /// Paints all visible layers above the ground (GroundPicture), lowest first.
    void paintLayers();

private:
    // Each of these functions paints one layer; the caller has set its opacity.
    /// Paints finished pages only, at the mip level that fits the scale, with edges on whole pixels.
    void paintHeights();
    void paintContours();
    /// Paints one picture of each page in sight; `pictureFor` takes a page and its pixels on the screen per cell.
    void paintPages(const QImage& (PagePicture::*pictureFor)(double) const);
    /// Paints the area with its handles and label, above the areas of the other robots.
    void paintArea();
    void paintOtherAreas();
    void paintAreaHandles(const Rectangle& area_in_map);
    void paintLanes();
    void paintTrails();
    void paintCorrected();
    void paintTraces() { traces_.paint(painter_, transform_); }
    /// Paints those of the selected robot on top; those of others are dimmed.
    void paintMarks();
    /// Leaves out path marks closer than three pixels to the previous one; draws all others.
    void paintMarksOf(const std::vector<agent::MapMark>& marks);
    /// Paints objects to scale, but never too small to click; the way points of the selected one; the object that is
    /// dragged or would be placed.
    void paintObjects();
    void paintObject(const MapObject& object, bool selected);
    void paintWaypoints(const MapObject& object);
    /// Paints diamonds with an arrow along the yaw; the one under the cursor is larger and in the accent color.
    void paintStartPoses();
    /// Paints the robot to spawn as a start pose with a long way ahead.
    void paintSpawnDraft();
    void paintLaser();
    void paintGoals();
    /// Paints lines between robots in the color of their quality, with their dBm; dashed if there is no link.
    void paintRadio();
    /// Paints their marks or, where the map is large enough, their outlines, with their names.
    void paintRobots();
    /// Paints separate segments through the points, without segments that are shorter than a pixel or out of sight; a
    /// point of NaN interrupts them.
    void paintSegments(const std::vector<Vec2>& points_m);
    /// The part of the screen that is painted, in pixels, with a margin for what is wider than its place.
    QRectF sight() const { return part_px_.adjusted(-10.0, -10.0, 10.0, 10.0); }
    /// Paints text on a background of its own, so that it is readable everywhere.
    void paintLabel(const QRectF& box_px, const QString& text, bool bold);

    QPainter& painter_;
    const MapContent& content_;
    const HeightLayer& heights_;
    const TraceLayer& traces_;
    const MapTransform& transform_;
    const Tokens& tokens_;
    const MapLabels& labels_;
    const QRectF part_px_;
};

/// Paints the symbol of a mark, for the map and its legend; shapes differ, so that color is never the only distinction.
/// `size_px` is the symbol's size in pixels.
void paintMark(QPainter& painter, agent::MarkKind kind, const QPointF& center_px, double size_px);

/// The following symbols are painted around the painter's origin, turned clockwise from "up".
void paintStartPoseSymbol(QPainter& painter, double turn_rad, bool hot);
void paintRobotSymbol(QPainter& painter, double turn_rad, const QColor& color, bool stale);
/// Paints a mast with waves.
void paintStationSymbol(QPainter& painter, const QColor& color, bool stale);

/// Paints an outline given in pixels around the painter's origin; in the accent color if `selected`.
void paintObjectSymbol(QPainter& painter, const QPolygonF& outline_px, bool selected);

/// Size of the chip that paintChip makes for a text, in pixels.
QSizeF chipSize(const QString& text);
/// Paints text on a raised chip; `at_px` is the corner or the middle of the chip that `alignment` names. Returns the
/// rectangle of the chip.
QRectF paintChip(QPainter& painter, const QPointF& at_px, const QString& text, Qt::Alignment alignment);

} // namespace usar::widgets
