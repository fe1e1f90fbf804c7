#include "widgets/map/robot_on_map.h"

#include <algorithm>

#include <QTransform>

#include "widgets/map/map_painter.h"

namespace usar::widgets {

namespace {

// Length of an outline on the screen between which the mark fades into it, in pixels.
constexpr double mark_alone_px = 14.0;
constexpr double outline_alone_px = 36.0;

QPointF placeOf(const MapRobot& robot, const MapTransform& transform) {
    return transform.toScreen(Vec2(robot.base_in_map.position_m.head<2>()));
}

double turn_deg(const MapRobot& robot, const MapTransform& transform) {
    return degrees(transform.screenRotation_rad(robot.base_in_map.yaw_rad));
}

/// Around the painter's origin; with an arrowhead that tells front from rear, which many outlines do not.
void paintOutline(QPainter& painter, const MapRobot& robot, const MapTransform& transform) {
    const QColor color = robotColor(robot.number);
    const QColor line = robot.stale ? tokens().stale : inkOn(color);
    const double scale = transform.pixels_per_m;
    painter.save();
    painter.rotate(turn_deg(robot, transform));
    const QPainterPath shape = QTransform::fromScale(scale, scale).map(robot.footprint->shape);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens().background, 4.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPath(shape);
    painter.setPen(QPen(line, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(robot.stale ? tokens().background : color);
    painter.drawPath(shape);
    const double r = std::min(0.22 * robot.footprint->length_m * scale, symbol::robot_px);
    painter.setPen(Qt::NoPen);
    painter.setBrush(line);
    painter.drawPolygon(QPolygonF({{0.0, -r}, {0.75 * r, 0.8 * r}, {0.0, 0.4 * r}, {-0.75 * r, 0.8 * r}}));
    painter.restore();
}

} // namespace

double outlineShare(const MapRobot& robot, const MapTransform& transform) {
    if (!robot.footprint || robot.station)
        return 0.0;
    const double length_px = robot.footprint->length_m * transform.pixels_per_m;
    return std::clamp((length_px - mark_alone_px) / (outline_alone_px - mark_alone_px), 0.0, 1.0);
}

double reach_px(const MapRobot& robot, const MapTransform& transform, bool selected) {
    const double mark_px = selected ? symbol::ring_px : symbol::robot_px;
    if (outlineShare(robot, transform) <= 0.0)
        return mark_px;
    const double outline_px = robot.footprint->reach_m * transform.pixels_per_m;
    return std::max(mark_px, outline_px + (selected ? symbol::ring_px - symbol::robot_px : 0.0));
}

bool outlineCovers(const MapRobot& robot, const MapTransform& transform, const QPointF& point_px) {
    if (outlineShare(robot, transform) <= 0.0)
        return false;
    const QPointF way_px = point_px - placeOf(robot, transform);
    return robot.footprint->shape.contains(QTransform().rotate(-turn_deg(robot, transform)).map(way_px) /
                                           transform.pixels_per_m);
}

void paintRobot(QPainter& painter, const MapRobot& robot, const MapTransform& transform, bool selected) {
    const double outline = outlineShare(robot, transform);
    painter.save();
    painter.translate(placeOf(robot, transform));
    if (selected) {
        const double ring_px = reach_px(robot, transform, true);
        painter.setPen(QPen(tokens().text, 2.0));
        painter.setBrush(faded(tokens().background, 0.35));
        painter.drawEllipse(QPointF(), ring_px, ring_px);
    }
    const double opacity = painter.opacity();
    if (outline > 0.0) {
        painter.setOpacity(opacity * outline);
        paintOutline(painter, robot, transform);
    }
    painter.setOpacity(opacity * (1.0 - outline));
    if (robot.station)
        paintStationSymbol(painter, robotColor(robot.number), robot.stale);
    else if (outline < 1.0)
        paintRobotSymbol(painter, transform.screenRotation_rad(robot.base_in_map.yaw_rad), robotColor(robot.number),
                         robot.stale);
    painter.restore();
}

} // namespace usar::widgets
