#include "widgets/map/map_labels.h"

#include <algorithm>
#include <span>

#include <QFontMetricsF>
#include <QTransform>

#include "widgets/map/map_overlay.h"
#include "widgets/map/map_painter.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr double farther_px = 16.0;

QRectF box(const LabelWish& wish, const QPointF& direction, double clear_px) {
    const QPointF half(wish.size_px.width() / 2.0, wish.size_px.height() / 2.0);
    const QPointF middle =
        wish.anchor_px + QPointF(direction.x() * (clear_px + half.x()), direction.y() * (clear_px + half.y()));
    return {middle - half, wish.size_px};
}

std::optional<QRectF> freeBox(const LabelWish& wish, const std::vector<QRectF>& taken_px) {
    const QPointF below(0.0, 1.0);
    const QPointF right(1.0, 0.0);
    for (const double clear_px : {wish.clear_px, wish.clear_px + farther_px})
        for (const QPointF& direction : {below, right, -right, -below}) {
            const QRectF there = box(wish, direction, clear_px);
            if (std::ranges::none_of(taken_px, [&](const QRectF& other) { return other.intersects(there); }))
                return there;
        }
    return wish.must_show ? std::optional(box(wish, below, wish.clear_px)) : std::nullopt;
}

/// Input of the layout. Wishes are in the order of the results: robots first, then start poses.
struct Layout {
    std::vector<LabelWish> wishes;
    std::vector<QRectF> taken_px;
    std::vector<QString> robots;

    void takeAround(const QPointF& middle_px, double half_px) {
        taken_px.emplace_back(middle_px - QPointF(half_px, half_px), QSizeF(2.0 * half_px, 2.0 * half_px));
    }
};

/// Keeps names from crossing the edge of the view: four wide strips stand for everything outside of it.
void takeOutside(Layout& layout, const QSizeF& viewport) {
    constexpr double far_px = 400.0;
    const QRectF view(QPointF(), viewport);
    const QRectF around = view.adjusted(-far_px, -far_px, far_px, far_px);
    layout.taken_px.emplace_back(around.topLeft(), QPointF(around.right(), view.top()));
    layout.taken_px.emplace_back(QPointF(around.left(), view.bottom()), around.bottomRight());
    layout.taken_px.emplace_back(around.topLeft(), QPointF(view.left(), around.bottom()));
    layout.taken_px.emplace_back(QPointF(view.right(), around.top()), around.bottomRight());
}

QSizeF boxSize(const QString& text, bool bold) {
    const QFontMetricsF metrics(themeFont(FontRole::Small, bold ? QFont::DemiBold : QFont::Normal));
    return {metrics.horizontalAdvance(text) + gap::small, metrics.height() + 2.0};
}

void addRobot(Layout& layout, const MapRobot& robot, bool selected, const MapTransform& transform) {
    const QPointF at = transform.toScreen(Vec2(robot.base_in_map.position_m.head<2>()));
    const double half_px = reach_px(robot, transform, selected);
    layout.robots.push_back(robot.name);
    layout.wishes.push_back({at, half_px + gap::tiny, boxSize(robotLabel(robot), selected), true});
    layout.takeAround(at, half_px);
}

void addRobots(Layout& layout, const MapContent& content, const MapTransform& transform) {
    for (const bool selected : {true, false})
        for (const auto& [name, on_map] : content.robots)
            if ((name == content.selected_robot) == selected)
                addRobot(layout, on_map.robot, selected, transform);
}

void addStartPoses(Layout& layout, const MapContent& content, const MapTransform& transform) {
    for (std::size_t i = 0; i < content.start_poses.size(); ++i) {
        const protocol::StartPose& pose = content.start_poses[i];
        const bool hot = content.hot_start_pose == i;
        const QPointF at = transform.toScreen(Vec2(pose.pose_in_map.position_m.head<2>()));
        layout.wishes.push_back(
            {at, symbol::diamond_px + gap::tiny, boxSize(QString::fromStdString(pose.name), hot), hot});
        layout.takeAround(at, symbol::diamond_px);
        const QTransform turn = QTransform().rotate(degrees(transform.screenRotation_rad(pose.pose_in_map.yaw_rad)));
        layout.takeAround(at + turn.map(QPointF(0.0, -symbol::diamond_px - symbol::arrow_px / 2.0)),
                          symbol::arrow_px / 2.0);
    }
}

QString areaText(const AreaOnMap& area, double room_px) {
    const QString dot = QStringLiteral("  ·  ");
    const Rectangle& rectangle = *area.area_in_map;
    QString text = QStringLiteral("x %1 × y %2 m").arg(figure(rectangle.width_m(), 1), figure(rectangle.height_m(), 1));
    if (!area.summary.isEmpty())
        text += dot + area.summary;
    while (chipSize(text).width() > room_px && text.contains(QStringLiteral("·")))
        text = text.section(QStringLiteral("·"), 0, -2).trimmed();
    return text;
}

/// Moves the box into the view, as far as it has room there.
QRectF movedInto(QRectF box, const QRectF& view) {
    box.moveLeft(std::max(view.left(), std::min(box.left(), view.right() - box.width())));
    box.moveTop(std::max(view.top(), std::min(box.top(), view.bottom() - box.height())));
    return box;
}

/// Corners of the area's label in order of preference: below the area, above it, inside at its corners, beside it.
std::vector<QPointF> areaCorners(const QRectF& area, const QRectF& in_sight, const QSizeF& size) {
    constexpr double away_px = gap::small;
    const double right = in_sight.right() - size.width();
    const double above = area.top() - away_px - size.height();
    std::vector<QPointF> corners;
    for (const double x : {in_sight.left(), right})
        corners.insert(corners.end(), {{x, area.bottom() + away_px}, {x, above}});
    for (const double x : {in_sight.left() + away_px, right - away_px})
        corners.insert(corners.end(),
                       {{x, in_sight.top() + away_px}, {x, in_sight.bottom() - away_px - size.height()}});
    for (const double x : {area.left() - away_px - size.width(), area.right() + away_px})
        for (const double steps : {0.0, -1.0, 1.0, -2.0})
            corners.emplace_back(x, in_sight.top() + steps * size.height());
    return corners;
}

/// The first of these places that covers nothing; else the first of all.
void placeArea(MapLabels& labels, const MapContent& content, const MapTransform& transform,
               const std::vector<QRectF>& taken_px) {
    if (!content.layer(MapLayer::Area).visible || !content.area.area_in_map)
        return;
    const QRectF view = QRectF(QPointF(), transform.viewport).adjusted(4.0, 4.0, -4.0, -4.0);
    const QRectF area = transform.toScreen(*content.area.area_in_map);
    const QRectF in_sight = area.intersected(view);
    if (in_sight.isEmpty())
        return;
    labels.area_text = areaText(content.area, view.width());
    const QSizeF size = chipSize(labels.area_text);
    for (const QPointF& corner : areaCorners(area, in_sight, size)) {
        const QRectF there = movedInto(QRectF(corner, size), view);
        if (labels.area.isEmpty())
            labels.area = there;
        if (std::ranges::none_of(taken_px, [&](const QRectF& other) { return other.intersects(there); })) {
            labels.area = there;
            return;
        }
    }
}

} // namespace

std::vector<std::optional<QRectF>> placeLabels(const std::vector<LabelWish>& wishes, std::vector<QRectF> taken_px) {
    std::vector<std::optional<QRectF>> places;
    places.reserve(wishes.size());
    for (const LabelWish& wish : wishes) {
        places.push_back(freeBox(wish, taken_px));
        if (places.back())
            taken_px.push_back(*places.back());
    }
    return places;
}

QString robotLabel(const MapRobot& robot) {
    return robot.stale ? robot.name + QStringLiteral(" (stale)") : robot.name;
}

MapLabels placeMapLabels(const MapContent& content, const MapTransform& transform,
                         const std::vector<QRectF>& legends_px) {
    Layout layout;
    layout.taken_px = legends_px;
    layout.taken_px.push_back(axesGlass_px(transform));
    takeOutside(layout, transform.viewport);
    if (content.layer(MapLayer::Robots).visible)
        addRobots(layout, content, transform);
    const std::size_t robots = layout.wishes.size();
    if (content.layer(MapLayer::StartPoses).visible)
        addStartPoses(layout, content, transform);
    // Symbols of robots and start poses are taken now; the names follow in the order of their importance.
    const auto wishes = std::span(layout.wishes);
    MapLabels labels;
    const auto robot_places = placeLabels({wishes.begin(), wishes.begin() + std::ptrdiff_t(robots)}, layout.taken_px);
    for (std::size_t i = 0; i < robots; ++i) {
        labels.robots[layout.robots[i]] = *robot_places[i];
        layout.taken_px.push_back(*robot_places[i]);
    }
    placeArea(labels, content, transform, layout.taken_px);
    layout.taken_px.push_back(labels.area);
    labels.start_poses = placeLabels({wishes.begin() + std::ptrdiff_t(robots), wishes.end()}, layout.taken_px);
    return labels;
}

} // namespace usar::widgets
