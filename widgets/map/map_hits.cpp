#include "widgets/map/map_hits.h"

#include <algorithm>
#include <cmath>

#include <QLineF>
#include <QObject>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

constexpr double near_px = 16.0;

/// Finds the item that is nearest to a point within reach, the last one of equals; the end if there is none.
/// `place_in_map` returns where an item is, in meters of the map frame.
template <class Items, class Place>
auto nearest(const Items& items, const QPointF& to_px, const MapTransform& transform, Place place_in_map) {
    double best_px = near_px;
    auto best = items.end();
    for (auto item = items.begin(); item != items.end(); ++item) {
        const Vec3 at_m = place_in_map(*item);
        const QPointF way = transform.toScreen(at_m.head<2>()) - to_px;
        if (const double distance_px = std::hypot(way.x(), way.y()); distance_px <= best_px) { // False for NaN.
            best_px = distance_px;
            best = item;
        }
    }
    return best;
}

QString robotText(const MapRobot& robot) {
    return QObject::tr("%1, z %2 m, yaw %3°. Click selects it (key %4).")
        .arg(robot.name, figure(robot.base_in_map.position_m.z(), 2), figure(degrees(robot.base_in_map.yaw_rad), 0))
        .arg(robot.number);
}

QString treeText(const SceneryTree& tree) {
    const QString crown = QObject::tr("crown %1 m across").arg(figure(2.0 * tree.crown_radius_m, 1));
    if (tree.trunk_radius_m <= 0.0)
        return QObject::tr("Bush, %1").arg(crown);
    return QObject::tr("Tree, %1, trunk %2 m").arg(crown, figure(2.0 * tree.trunk_radius_m, 2));
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
    const auto& poses = content_.start_poses;
    const auto found = nearest(poses, point_px, transform_,
                               [](const protocol::StartPose& pose) { return pose.pose_in_map.position_m; });
    return found == poses.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - poses.begin()));
}

bool MapHits::draftAt(const QPointF& point_px) const {
    if (!content_.spawn_draft_in_map)
        return false;
    const QPointF at = transform_.toScreen(Vec2(content_.spawn_draft_in_map->position_m.head<2>()));
    return QLineF(at, point_px).length() <= near_px;
}

QString MapHits::robotAt(const QPointF& point_px) const {
    const auto found = nearest(content_.robots, point_px, transform_,
                               [](const auto& named) { return named.second.robot.base_in_map.position_m; });
    if (found != content_.robots.end())
        return found->first;
    for (const auto& [name, on_map] : content_.robots)
        if (outlineCovers(on_map.robot, transform_, point_px))
            return name;
    return {};
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

const SceneryTree* MapHits::treeAt(const QPointF& point_px) const {
    if (!content_.scenery || !content_.layer(MapLayer::Objects).visible)
        return nullptr;
    const Vec2 at_m = transform_.toMap(point_px);
    const auto& trees = content_.scenery->trees;
    const auto found = std::ranges::find_if(trees, [&](const SceneryTree& tree) {
        return (tree.center_m - at_m).norm() <= std::max(tree.crown_radius_m, tree.trunk_radius_m);
    });
    return found == trees.end() ? nullptr : &*found;
}

std::optional<AreaGrip> MapHits::gripAt(const QPointF& point_px) const {
    const auto& area = content_.area.area_in_map;
    return area ? widgets::gripAt(*area, transform_, point_px) : std::nullopt;
}

QString MapHits::toolTipAt(const QPointF& point_px) const {
    if (const QString robot = robotAt(point_px); !robot.isEmpty())
        return robotText(content_.robots.at(robot).robot);
    if (draftAt(point_px))
        return QObject::tr("A robot to spawn here. One click asks which; Undo or Esc takes it away.");
    if (const auto i = startPoseAt(point_px))
        return QObject::tr("Start pose %1. Double-click spawns a robot here; one click asks which.")
            .arg(QString::fromStdString(content_.start_poses[*i].name));
    if (const MapObject* const object = content_.object(objectAt(point_px)))
        return objectText(*object);
    const SceneryTree* const tree = treeAt(point_px);
    return tree ? treeText(*tree) : QString();
}

} // namespace usar::widgets
