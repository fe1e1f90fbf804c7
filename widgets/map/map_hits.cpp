#include "widgets/map/map_hits.h"

#include <algorithm>
#include <cmath>

#include <QObject>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

/// Finds the nearest of some points within reach.
class Nearest {
public:
    explicit Nearest(const QPointF& to_px) : to_px_(to_px) {}
    /// True if this point is within reach and no farther than all before.
    bool take(const QPointF& at_px) {
        const double distance_px = std::hypot(at_px.x() - to_px_.x(), at_px.y() - to_px_.y());
        if (!(distance_px <= best_px_)) // Also rejects NaN.
            return false;
        best_px_ = distance_px;
        return true;
    }

private:
    QPointF to_px_;
    double best_px_ = 16.0;
};

QString robotText(const MapRobot& robot) {
    return QObject::tr("%1, z %2 m, yaw %3°. Click selects it (key %4).")
        .arg(robot.name, figure(robot.base_in_map.position_m.z(), 2), figure(degrees(robot.base_in_map.yaw_rad), 0))
        .arg(robot.number);
}

QString objectText(const MapObject& object) {
    return QObject::tr("%1 %2, %3 × %4 × %5 m. Drag moves it, Delete removes it.")
        .arg(object.kind, object.name, figure(object.size_m.x(), 2), figure(object.size_m.y(), 2),
             figure(object.size_m.z(), 2));
}

} // namespace

std::optional<std::size_t> MapHits::startPoseAt(const QPointF& point_px) const {
    if (!content_.layer(MapLayer::StartPoses).visible)
        return std::nullopt;
    std::optional<std::size_t> best;
    Nearest nearest(point_px);
    for (std::size_t i = 0; i < content_.start_poses.size(); ++i)
        if (nearest.take(transform_.toScreen(content_.start_poses[i].pose_in_map.position_m.head<2>())))
            best = i;
    return best;
}

QString MapHits::robotAt(const QPointF& point_px) const {
    QString best;
    Nearest nearest(point_px);
    for (const auto& [name, robot] : content_.robots)
        if (nearest.take(transform_.toScreen(robot.robot.base_in_map.position_m.head<2>())))
            best = name;
    return best;
}

QString MapHits::objectAt(const QPointF& point_px) const {
    if (!content_.layer(MapLayer::Objects).visible)
        return {};
    const auto hit = [&](const MapObject& object) {
        const QPolygonF outline = outlineOnScreen(object, transform_);
        return outline.containsPoint(point_px, Qt::OddEvenFill) ||
               outline.boundingRect().adjusted(-3.0, -3.0, 3.0, 3.0).contains(point_px);
    };
    const auto& objects = content_.objects.objects;
    const auto found = std::find_if(objects.rbegin(), objects.rend(), hit);
    return found == objects.rend() ? QString() : found->name;
}

std::optional<AreaGrip> MapHits::gripAt(const QPointF& point_px) const {
    const auto& area = content_.area.area_in_map;
    return area ? widgets::gripAt(*area, transform_, point_px) : std::nullopt;
}

QString MapHits::toolTipAt(const QPointF& point_px) const {
    if (const QString robot = robotAt(point_px); !robot.isEmpty())
        return robotText(content_.robots.at(robot).robot);
    if (const auto i = startPoseAt(point_px))
        return QObject::tr("Start pose %1. Double-click spawns a robot here; one click asks which.")
            .arg(QString::fromStdString(content_.start_poses[*i].name));
    const MapObject* const object = content_.object(objectAt(point_px));
    return object ? objectText(*object) : QString();
}

} // namespace usar::widgets
