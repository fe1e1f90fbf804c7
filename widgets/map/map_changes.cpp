#include "widgets/map/map_changes.h"

#include <algorithm>
#include <utility>

#include "widgets/map/map_painter.h"

namespace usar::widgets {

namespace {

/// Pens and antialiasing reach this far beyond a place.
constexpr double margin_px = 4.0;

QPointF onScreen(const Vec3& point_in_map_m, const MapTransform& transform) {
    return transform.toScreen(Vec2(point_in_map_m.head<2>()));
}

QRectF around(const QPointF& middle_px, double half_px) {
    return {middle_px - QPointF(half_px, half_px), QSizeF(2.0 * half_px, 2.0 * half_px)};
}

QRectF between(const QPointF& a_px, const QPointF& b_px) {
    return QRectF(a_px, b_px).normalized();
}

/// Extends a box, which may be empty, by a point.
void include(std::optional<QRectF>& box_px, const QPointF& point_px) {
    const QRectF point(point_px, QSizeF());
    box_px = box_px ? QRectF(QPointF(std::min(box_px->left(), point.x()), std::min(box_px->top(), point.y())),
                             QPointF(std::max(box_px->right(), point.x()), std::max(box_px->bottom(), point.y())))
                    : point;
}

double hashOf(const QString& text) {
    return static_cast<double>(qHash(text));
}

QRect pixelsOf(const QRectF& place_px) {
    constexpr double far_px = 1e6; // Beyond any screen, and within what an int holds.
    return (place_px & QRectF(-far_px, -far_px, 2.0 * far_px, 2.0 * far_px)).toAlignedRect();
}

} // namespace

void MapChanges::Frame::add(const QRectF& place_px, std::vector<double> state) {
    sprites.push_back({place_px.adjusted(-margin_px, -margin_px, margin_px, margin_px), std::move(state)});
}

void MapChanges::Frame::addRobot(const RobotOnMap& on_map, bool selected, const Frame& before) {
    const MapRobot& robot = on_map.robot;
    const Pose& base = robot.base_in_map;
    const QPointF at = onScreen(base.position_m, transform);
    add(around(at, reach_px(robot, transform, selected)),
        {at.x(), at.y(), base.yaw_rad, double(robot.number), double(robot.stale), double(robot.station),
         robot.footprint ? robot.footprint->length_m : 0.0});
    const QPointF goal = on_map.goal_in_map_m ? onScreen(*on_map.goal_in_map_m, transform) : at;
    constexpr double ring_px = 6.0;
    add(between(at, goal).united(around(goal, ring_px)),
        {at.x(), at.y(), goal.x(), goal.y(), double(on_map.goal_in_map_m.has_value())});

    std::vector<double> hits;
    std::optional<QRectF> box;
    for (const Vec3& hit : on_map.hits_in_map_m)
        if (hit.allFinite()) {
            const QPointF point = onScreen(hit, transform);
            hits.insert(hits.end(), {point.x(), point.y()});
            include(box, point);
        }
    add(box.value_or(QRectF()), std::move(hits));

    // A new point may replace the last one, and so moves the last segment.
    const std::vector<Vec2>& trail_m = on_map.trail.points_m();
    std::size_t& points = trail_points[robot.name];
    points = trail_m.size();
    const auto known = before.trail_points.find(robot.name);
    const std::size_t from = known == before.trail_points.end() ? 0 : std::min(known->second, points);
    box.reset();
    for (std::size_t i = from < 3 ? 0 : from - 3; i < points; ++i)
        if (trail_m[i].allFinite())
            include(box, transform.toScreen(trail_m[i]));
    const Vec2 end_m = trail_m.empty() ? Vec2::Zero() : trail_m.back();
    add(box.value_or(QRectF()), {double(points), end_m.x(), end_m.y()});
}

void MapChanges::Frame::addMarks(const MapContent& content, const Frame& before) {
    constexpr double half_px = 6.0;
    for (const auto& [name, of_robot] : content.marks) {
        marks[name] = of_robot.size();
        const auto known = before.marks.find(name);
        std::optional<QRectF> box;
        for (std::size_t i = known == before.marks.end() ? 0 : known->second; i < of_robot.size(); ++i)
            include(box, onScreen(of_robot[i].position_in_map_m, transform));
        add(box ? box->adjusted(-half_px, -half_px, half_px, half_px) : QRectF(), {double(of_robot.size())});
    }
}

void MapChanges::Frame::addLabels(const MapContent& content) {
    for (const auto& [name, box] : labels.robots)
        add(box, {hashOf(robotLabel(content.robots.at(name).robot))});
    for (std::size_t i = 0; i < labels.start_poses.size(); ++i)
        add(labels.start_poses[i].value_or(QRectF()), {hashOf(QString::fromStdString(content.start_poses[i].name))});
    add(labels.area, {hashOf(labels.area_text)});
}

void MapChanges::Frame::addRadio(const MapContent& content) {
    if (!content.layer(MapLayer::Radio).visible)
        return;
    constexpr double figure_px = 80.0; // A chip in the middle of the line is not larger.
    for (const RadioLink& link : content.radio_links) {
        const auto a = content.robots.find(link.a);
        const auto b = content.robots.find(link.b);
        if (a == content.robots.end() || b == content.robots.end())
            continue;
        const QPointF from = onScreen(a->second.robot.base_in_map.position_m, transform);
        const QPointF to = onScreen(b->second.robot.base_in_map.position_m, transform);
        add(between(from, to).united(around((from + to) / 2.0, figure_px)),
            {from.x(), from.y(), to.x(), to.y(), link.strength_dbm.value_or(0.0),
             double(link.strength_dbm.has_value())});
    }
}

void MapChanges::Frame::addOverlay(const MapContent& content, const HeightLayer& heights, const MapOverlay& overlay) {
    const OverlayPlaces places(legends, transform);
    const mapping::HeightRange range = heights.range();
    add(places.heights, {double(range.minimum_m), double(range.maximum_m),
                         double(content.layer(MapLayer::Contours).visible), double(heights.style().color_map)});
    add(overlay.probe.isEmpty() ? QRectF() : probePlace(overlay.probe, places, transform), {hashOf(overlay.probe)});
}

std::optional<QRegion> MapChanges::take(const MapContent& content, const HeightLayer& heights,
                                        const MapOverlay& overlay, const MapTransform& transform) {
    Frame now{transform, legendsOf(content, heights), {}, {}, {}, {}};
    now.labels = placeMapLabels(content, transform, OverlayPlaces(now.legends, transform).all());
    for (const auto& [name, on_map] : content.robots)
        now.addRobot(on_map, name == content.selected_robot, painted_);
    now.addMarks(content, painted_);
    now.addLabels(content);
    now.addRadio(content);
    now.addOverlay(content, heights, overlay);

    const Frame before = std::exchange(painted_, std::move(now));
    const std::vector<Rectangle> touched_in_map = std::exchange(touched_in_map_, {});
    if (before.transform != transform || before.legends != painted_.legends ||
        before.sprites.size() != painted_.sprites.size() || content.measured)
        return std::nullopt;
    QRegion different;
    for (const Rectangle& ground : touched_in_map)
        different |= pixelsOf(transform.toScreen(ground).adjusted(-margin_px, -margin_px, margin_px, margin_px));
    for (std::size_t i = 0; i < before.sprites.size(); ++i)
        if (before.sprites[i] != painted_.sprites[i])
            different |= QRegion(pixelsOf(before.sprites[i].place_px)) | pixelsOf(painted_.sprites[i].place_px);
    return different & QRectF(QPointF(), transform.viewport).toAlignedRect();
}

std::vector<QRect> apart(const QRegion& region) {
    std::vector<QRect> parts;
    for (QRect part : region) {
        // Each one that it touches makes it larger, and so it may touch others.
        for (auto other = parts.begin(); other != parts.end();)
            if (other->adjusted(-1, -1, 1, 1).intersects(part)) {
                part |= *other;
                parts.erase(other);
                other = parts.begin();
            } else {
                ++other;
            }
        parts.push_back(part);
    }
    return parts;
}

} // namespace usar::widgets
