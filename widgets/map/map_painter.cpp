#include "widgets/map/map_painter.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "widgets/map/map_overlay.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

/// Opacity of what belongs to robots that are not selected.
constexpr double other_robots = 0.45;

Vec2 flat(const Vec3& point) {
    return point.head<2>();
}

} // namespace

MapPainter::MapPainter(QPainter& painter, const MapContent& content, const HeightLayer& heights,
                       const TraceLayer& traces, const MapTransform& transform, const MapLabels& labels,
                       const QRectF& part_px)
    : painter_(painter)
    , content_(content)
    , heights_(heights)
    , traces_(traces)
    , transform_(transform)
    , tokens_(tokens())
    , labels_(labels)
    , part_px_(part_px) {}

void MapPainter::paintLayers() {
    struct LayerPainter {
        void (MapPainter::*paint)();
        bool smooth; ///< with antialiasing
    };
    // In the order of MapLayer. GroundPicture has painted the first two.
    static constexpr LayerPainter painters[map_layer_count] = {{nullptr, false},
                                                               {nullptr, false},
                                                               {&MapPainter::paintHeights, false},
                                                               {&MapPainter::paintContours, false},
                                                               {&MapPainter::paintArea, false},
                                                               {&MapPainter::paintLanes, true},
                                                               {&MapPainter::paintTrails, true},
                                                               {&MapPainter::paintCorrected, true},
                                                               {&MapPainter::paintTraces, false},
                                                               {&MapPainter::paintMarks, true},
                                                               {&MapPainter::paintObjects, true},
                                                               {&MapPainter::paintStartPoses, true},
                                                               {&MapPainter::paintLaser, false},
                                                               {&MapPainter::paintGoals, true},
                                                               {&MapPainter::paintRadio, true},
                                                               {&MapPainter::paintRobots, true}};
    for (std::size_t i = 0; i < map_layer_count; ++i) {
        if (!painters[i].paint || !content_.layers[i].visible || content_.layers[i].opacity <= 0.0)
            continue;
        painter_.save();
        painter_.setOpacity(content_.layers[i].opacity);
        painter_.setRenderHint(QPainter::Antialiasing, painters[i].smooth);
        (this->*painters[i].paint)();
        painter_.restore();
    }
}

void MapPainter::paintHeights() {
    paintPages(&PagePicture::levelFor);
}

void MapPainter::paintContours() {
    paintPages(&PagePicture::contoursFor);
}

void MapPainter::paintPages(const QImage& (PagePicture::*pictureFor)(double) const) {
    const double cell_m = heights_.cellSize_m();
    for (const auto& [index, picture] : heights_.pages()) {
        const QRectF on_screen = transform_.toScreen(pageRectangle(index, cell_m));
        if (!on_screen.intersects(sight()))
            continue;
        // Edges are on whole pixels and shared by neighbors, so that no seams are visible.
        const QRect target(QPoint(qRound(on_screen.left()), qRound(on_screen.top())),
                           QPoint(qRound(on_screen.right()) - 1, qRound(on_screen.bottom()) - 1));
        painter_.drawImage(target, (picture.*pictureFor)(transform_.pixels_per_m * cell_m));
    }
}

void MapPainter::paintOtherAreas() {
    const double opacity = painter_.opacity();
    for (const auto& [name, robot] : content_.robots) {
        if (name == content_.selected_robot || robot.area_in_map.empty() ||
            robot.area_in_map == content_.area.area_in_map)
            continue;
        const QRectF rect = transform_.toScreen(robot.area_in_map);
        painter_.setOpacity(opacity * other_robots);
        frameInStrips(painter_, rect.adjusted(-1.5, -1.5, 1.5, 1.5) & sight(), 3.0, tokens_.background);
        dashFrame(painter_, rect, sight(), robotColor(robot.robot.number));
        painter_.setOpacity(opacity);
        paintLabel(QRectF(rect.topLeft() + QPointF(gap::tiny, gap::tiny), chipSize(name)), name, false);
    }
}

void MapPainter::paintArea() {
    paintOtherAreas();
    if (!content_.area.area_in_map || content_.area.area_in_map->empty())
        return;
    const Rectangle& area = *content_.area.area_in_map;
    const QRectF rect = transform_.toScreen(area);
    if (content_.area.editing) // At other times a tint would make the scan's colors differ from the legend's.
        fillInStrips(painter_, rect & sight(), faded(tokens_.accent, 0.12));
    frameInStrips(painter_, rect.adjusted(-1.5, -1.5, 1.5, 1.5) & sight(), 3.0, tokens_.background);
    dashFrame(painter_, rect, sight(), tokens_.accent);
    if (content_.area.editing)
        paintAreaHandles(area);
    if (labels_.area.intersects(sight()))
        paintChip(painter_, labels_.area.topLeft(), labels_.area_text, Qt::AlignLeft | Qt::AlignTop);
}

void MapPainter::paintAreaHandles(const Rectangle& area) {
    for (const AreaGrip grip : area_handles) {
        const bool hot = content_.area.hot_grip == grip;
        const double half = hot ? 6.0 : 4.5;
        const QPointF at = transform_.toScreen(gripPoint(area, grip));
        painter_.setPen(QPen(tokens_.accent, 1.5));
        painter_.setBrush(hot ? tokens_.accent : tokens_.surface);
        painter_.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    }
}

void MapPainter::paintSegments(const std::vector<Vec2>& points_m) {
    if (points_m.size() < 2)
        return;
    const QRectF in_sight = sight();
    QVector<QLineF> lines;
    lines.reserve(static_cast<qsizetype>(points_m.size()));
    QPointF last = transform_.toScreen(points_m.front());
    for (std::size_t i = 1; i < points_m.size(); ++i) {
        const QPointF next = transform_.toScreen(points_m[i]);
        if (i + 1 < points_m.size() && (next - last).manhattanLength() < 1.5)
            continue;
        const bool gap = !points_m[i].allFinite() || !points_m[i - 1].allFinite();
        if (!gap && QRectF(last, next).normalized().adjusted(-1.0, -1.0, 1.0, 1.0).intersects(in_sight))
            lines << QLineF(last, next);
        last = next;
    }
    painter_.drawLines(lines);
}

void MapPainter::paintLanes() {
    const std::vector<Vec2>& lanes_m = content_.area.lanes_in_map_m;
    if (lanes_m.empty())
        return;
    const QColor color = faded(tokens_.accent, 0.75);
    painter_.setPen(QPen(color, 1.0));
    for (std::size_t i = 1; i < lanes_m.size(); ++i) {
        const QLineF lane(transform_.toScreen(lanes_m[i - 1]), transform_.toScreen(lanes_m[i]));
        const QRectF line = QRectF(lane.p1(), lane.p2()).normalized();
        if (std::min(line.width(), line.height()) < 1.0) // Upright or level, as nearly all are.
            fillInStrips(painter_, line.adjusted(-0.5, -0.5, 0.5, 0.5) & sight(), color);
        else
            painter_.drawLine(lane);
    }
    painter_.setBrush(tokens_.accent);
    painter_.setPen(QPen(tokens_.background, 1.0));
    painter_.drawEllipse(transform_.toScreen(lanes_m.front()), 4.0, 4.0);
}

void MapPainter::paintTrails() {
    for (const auto& [name, robot] : content_.robots) {
        painter_.setPen(QPen(robotColor(robot.robot.number), 1.5));
        paintSegments(robot.trail.points_m());
    }
}

void MapPainter::paintCorrected() {
    for (const auto& [name, robot] : content_.robots)
        if (robot.corrected_in_map_m)
            paintCorrectedPath(painter_, *robot.corrected_in_map_m, transform_, sight());
}

void MapPainter::paintMarks() {
    painter_.save();
    painter_.setOpacity(painter_.opacity() * other_robots);
    for (const auto& [name, marks] : content_.marks)
        if (!content_.bright(name))
            paintMarksOf(marks);
    painter_.restore();
    for (const auto& [name, marks] : content_.marks)
        if (content_.bright(name))
            paintMarksOf(marks);
}

void MapPainter::paintMarksOf(const std::vector<agent::MapMark>& marks) {
    const QRectF in_sight = sight();
    QVector<QPointF> path;
    std::optional<QPointF> last; // Also out of sight, so that each part of the view shows the same marks.
    for (const agent::MapMark& mark : marks) {
        if (mark.kind != agent::MarkKind::Path)
            continue;
        const QPointF at = transform_.toScreen(flat(mark.position_in_map_m));
        if (last && (at - *last).manhattanLength() < 3.0)
            continue;
        last = at;
        if (in_sight.contains(at))
            path << at;
    }
    painter_.setPen(QPen(markColor(agent::MarkKind::Path), 3.0, Qt::SolidLine, Qt::SquareCap));
    painter_.drawPoints(path.data(), static_cast<int>(path.size()));
    for (const agent::MapMark& mark : marks)
        if (const QPointF at = transform_.toScreen(flat(mark.position_in_map_m));
            mark.kind != agent::MarkKind::Path && in_sight.contains(at))
            paintMark(painter_, mark.kind, at, 10.0);
}

void MapPainter::paintStartPoses() {
    constexpr double reach = symbol::diamond_px + symbol::arrow_px;
    const QRectF near = sight().adjusted(-reach, -reach, reach, reach);
    for (std::size_t i = 0; i < content_.start_poses.size(); ++i) {
        const protocol::StartPose& pose = content_.start_poses[i];
        const bool hot = content_.hot_start_pose == i;
        if (const QPointF at = transform_.toScreen(flat(pose.pose_in_map.position_m)); near.contains(at)) {
            painter_.save();
            painter_.translate(at);
            paintStartPoseSymbol(painter_, transform_.screenRotation_rad(pose.pose_in_map.yaw_rad), hot);
            painter_.restore();
        }
        if (const auto& box = labels_.start_poses[i])
            paintLabel(*box, QString::fromStdString(pose.name), hot);
    }
    paintSpawnDraft();
}

void MapPainter::paintSpawnDraft() {
    if (!content_.spawn_draft_in_map)
        return;
    constexpr double way_px = 56.0;
    const Pose& draft = *content_.spawn_draft_in_map;
    painter_.save();
    painter_.translate(transform_.toScreen(flat(draft.position_m)));
    const double turn_rad = transform_.screenRotation_rad(draft.yaw_rad);
    painter_.setPen(dashedPen(tokens_.accent, 1.5, {3.0, 3.0}));
    painter_.drawLine(QPointF(), way_px * QPointF(std::sin(turn_rad), -std::cos(turn_rad)));
    paintStartPoseSymbol(painter_, turn_rad, true);
    painter_.restore();
}

void MapPainter::paintLaser() {
    for (const auto& [name, robot] : content_.robots) {
        QVector<QPointF> points;
        for (const Vec3& hit : robot.hits_in_map_m)
            if (hit.allFinite())
                points << transform_.toScreen(flat(hit));
        painter_.setPen(QPen(tokens_.laser, 2.0, Qt::SolidLine, Qt::SquareCap));
        painter_.drawPoints(points.data(), static_cast<int>(points.size()));
    }
}

void MapPainter::paintGoals() {
    for (const auto& [name, robot] : content_.robots) {
        if (!robot.goal_in_map_m)
            continue;
        const QPointF from = transform_.toScreen(flat(robot.robot.base_in_map.position_m));
        const QPointF to = transform_.toScreen(flat(*robot.goal_in_map_m));
        painter_.setPen(dashedPen(robotColor(robot.robot.number), 1.5, {2.0, 3.0}));
        painter_.drawLine(from, to);
        painter_.setPen(QPen(robotColor(robot.robot.number), 2.0));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawEllipse(to, 6.0, 6.0);
        painter_.drawPoint(to);
    }
}

void MapPainter::paintRadio() {
    constexpr double room_px = 96.0; // Shorter links have no figure.
    for (const RadioLink& link : content_.radio_links) {
        const auto a = content_.robots.find(link.a);
        const auto b = content_.robots.find(link.b);
        if (a == content_.robots.end() || b == content_.robots.end())
            continue;
        const RadioQuality quality = radioQuality(link.strength_dbm);
        const QLineF line(transform_.toScreen(flat(a->second.robot.base_in_map.position_m)),
                          transform_.toScreen(flat(b->second.robot.base_in_map.position_m)));
        const bool linked = quality != RadioQuality::Lost && quality != RadioQuality::Unknown;
        painter_.setPen(linked ? QPen(radioColor(quality), 2.0) : dashedPen(radioColor(quality), 2.0, {2.0, 4.0}));
        painter_.drawLine(line);
        if (link.strength_dbm && line.length() >= room_px)
            paintChip(painter_, line.center(), figure(*link.strength_dbm, 0) + QStringLiteral(" dBm"),
                      Qt::AlignHCenter | Qt::AlignBottom);
    }
}

void MapPainter::paintRobots() {
    for (const auto& [name, on_map] : content_.robots) {
        const bool selected = name == content_.selected_robot;
        paintRobot(painter_, on_map.robot, transform_, selected);
        paintLabel(labels_.robots.at(name), robotLabel(on_map.robot), selected);
    }
}

void MapPainter::paintLabel(const QRectF& box, const QString& text, bool bold) {
    if (!box.intersects(sight()))
        return;
    painter_.setFont(themeFont(FontRole::Small, bold ? QFont::DemiBold : QFont::Normal));
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(faded(tokens_.background, 0.72));
    painter_.drawRoundedRect(box, 3.0, 3.0);
    painter_.setPen(tokens_.text);
    painter_.drawText(box, Qt::AlignCenter, text);
}

void paintObjectSymbol(QPainter& painter, const QPolygonF& outline, bool selected) {
    const Tokens& t = tokens();
    painter.setPen(QPen(t.background, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
    painter.setPen(
        QPen(selected ? t.accent : t.text, selected ? 2.0 : 1.25, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(faded(selected ? t.accent : t.text_muted, 0.45));
    painter.drawPolygon(outline);
}

void MapPainter::paintObjects() {
    const ObjectsOnMap& things = content_.objects;
    const MapObject* selected = nullptr;
    for (const MapObject& object : things.objects)
        if (object.name == things.selected)
            selected = &object;
        else
            paintObject(object, false);
    if (selected) { // Above its neighbors.
        paintWaypoints(*selected);
        paintObject(*selected, true);
    }
    painter_.setOpacity(0.6);
    for (const MapObject& object : things.objects)
        if (object.name == things.held)
            paintObject(movedTo(object, things.held_to_m), true);
    if (things.ghost)
        paintObject(*things.ghost, true);
}

void MapPainter::paintObject(const MapObject& object, bool selected) {
    const QPolygonF outline = outlineOnScreen(object, transform_);
    const QRectF bounds = outline.boundingRect();
    if (!bounds.adjusted(-80.0, -8.0, 80.0, 24.0).intersects(sight()))
        return;
    paintObjectSymbol(painter_, outline, selected);
    const QPointF center = bounds.center();
    if (object.carries) { // Arrow in the direction of the belt.
        const Vec3 along = object.body_in_map * Vec3(0.35 * object.size_m.x(), 0.0, 0.0);
        const QPointF tip = transform_.toScreen(Vec2(along.head<2>()));
        painter_.drawLine(2.0 * center - tip, tip);
        const double turn = std::atan2(tip.y() - center.y(), tip.x() - center.x());
        for (const double side : {2.6, -2.6})
            painter_.drawLine(tip, tip + 5.0 * QPointF(std::cos(turn + side), std::sin(turn + side)));
    }
    if (!selected)
        return;
    const QSizeF size(QFontMetricsF(themeFont(FontRole::Small, QFont::DemiBold)).horizontalAdvance(object.name) + 10.0,
                      18.0);
    paintLabel(QRectF(QPointF(center.x() - size.width() / 2.0, bounds.top() - gap::tiny - size.height()), size),
               object.name, true);
}

void MapPainter::paintWaypoints(const MapObject& object) {
    QPointF from = transform_.toScreen(Vec2(object.body_in_map.position_m.head<2>()));
    const QPen dashed = dashedPen(tokens_.accent, 1.5, {3.0, 3.0});
    painter_.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    int number = 0;
    for (const Vec2& point_m : object.waypoints_in_map_m) {
        const QPointF at = transform_.toScreen(point_m);
        painter_.setPen(dashed);
        painter_.drawLine(from, at);
        painter_.setPen(QPen(tokens_.accent, 1.5));
        painter_.setBrush(tokens_.background);
        painter_.drawEllipse(at, 8.0, 8.0);
        painter_.setPen(tokens_.text);
        painter_.drawText(QRectF(at - QPointF(8.0, 8.0), QSizeF(16.0, 16.0)), Qt::AlignCenter,
                          QString::number(++number));
        from = at;
    }
}

} // namespace usar::widgets
