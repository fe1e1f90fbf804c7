#include <cmath>

#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "widgets/map/map_view.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {
constexpr double reach_px = 16.0;

double distance_px(const QPointF& a, const QPointF& b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// Returns why no area can be drawn between these two corners; empty if it can.
QString refusal(const Vec2& from_m, const Vec2& to_m, const std::optional<Rectangle>& world) {
    if (spanned(from_m, to_m, std::nullopt).empty())
        return MapView::tr("The drawn area has no size. Drag from one corner to the opposite one.");
    if (!world || !spanned(from_m, to_m, world).empty())
        return {};
    return MapView::tr("The drawn area lies outside the world, which spans x %1 … %2 m and y %3 … %4 m. Draw it inside "
                       "the world's frame.")
        .arg(figure(world->min_m.x(), 1), figure(world->max_m.x(), 1), figure(world->min_m.y(), 1),
             figure(world->max_m.y(), 1));
}
} // namespace

std::optional<std::size_t> MapView::startPoseAt(const QPointF& point_px) const {
    std::optional<std::size_t> best;
    double best_px = reach_px;
    for (std::size_t i = 0; i < content_.start_poses.size(); ++i) {
        const QPointF at = transform_.toScreen(content_.start_poses[i].pose_in_map.position_m.head<2>());
        if (const double d = distance_px(at, point_px); d <= best_px) {
            best = i;
            best_px = d;
        }
    }
    return content_.layer(MapLayer::StartPoses).visible ? best : std::nullopt;
}

QString MapView::robotAt(const QPointF& point_px) const {
    QString best;
    double best_px = reach_px;
    for (const auto& [name, robot] : content_.robots) {
        const QPointF at = transform_.toScreen(robot.robot.base_in_map.position_m.head<2>());
        if (const double d = distance_px(at, point_px); d <= best_px) {
            best = name;
            best_px = d;
        }
    }
    return best;
}

void MapView::mousePressEvent(QMouseEvent* event) {
    pressed_px_ = last_px_ = event->position();
    pressed_m_ = transform_.toMap(pressed_px_);
    if (event->button() == Qt::MiddleButton || event->button() == Qt::RightButton)
        gesture_ = Gesture::Panning;
    else if (event->button() == Qt::LeftButton)
        gesture_ = Gesture::Pressed;
    updateCursor();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    const QPointF at = event->position();
    cursor_px_ = at;
    if (gesture_ == Gesture::Pressed && distance_px(at, pressed_px_) >= QApplication::startDragDistance() / 2.0) {
        if (tool_ == MapTool::Area)
            beginAreaGesture(pressed_px_);
        else if (!beginObjectDrag(pressed_px_))
            gesture_ = Gesture::Panning;
        updateCursor();
    }
    if (gesture_ == Gesture::Panning)
        panBy(at - last_px_);
    else if (gesture_ == Gesture::DrawingArea || gesture_ == Gesture::DraggingGrip)
        dragArea(at);
    else if (gesture_ == Gesture::DraggingObject)
        dragObject(at);
    else
        hover(at);
    showGhost(at);
    last_px_ = at;
    const Vec2 ground = transform_.toMap(at);
    emit probed(ground, heights_->probe(ground));
    update();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
    const Gesture gesture = std::exchange(gesture_, Gesture::None);
    if (gesture == Gesture::Pressed)
        click(event->position(), event->modifiers());
    else if (gesture == Gesture::DraggingObject)
        finishObjectDrag();
    else if (gesture == Gesture::DrawingArea || gesture == Gesture::DraggingGrip)
        finishAreaGesture(gesture, event->position());
    updateCursor();
    update();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
    // No gesture begins, so that the second release does not count as a click.
    if (event->button() != Qt::LeftButton)
        return;
    if (clickWithTool(event->position(), event->modifiers()))
        return;
    if (const auto pose = startPoseAt(event->position()))
        emit spawnRequested(static_cast<int>(*pose));
}

void MapView::click(const QPointF& point_px, Qt::KeyboardModifiers modifiers) {
    if (clickWithTool(point_px, modifiers))
        return;
    if (const QString robot = robotAt(point_px); !robot.isEmpty()) {
        selectRobot(robot);
        emit robotClicked(robot);
    } else if (const auto pose = startPoseAt(point_px)) {
        askAbout(*pose);
    } else {
        clickObject(point_px);
    }
}

void MapView::askAbout(std::size_t start_pose) {
    const QPointF at = transform_.toScreen(content_.start_poses[start_pose].pose_in_map.position_m.head<2>());
    emit startPoseClicked(static_cast<int>(start_pose), mapToGlobal((at + QPointF(24.0, 24.0)).toPoint()));
}

void MapView::hover(const QPointF& point_px) {
    content_.hot_start_pose = startPoseAt(point_px);
    content_.area.hot_grip.reset();
    if (tool_ == MapTool::Area && content_.area.area_in_map)
        content_.area.hot_grip = gripAt(*content_.area.area_in_map, transform_, point_px);
    updateCursor();
}

void MapView::beginAreaGesture(const QPointF& point_px) {
    area_before_ = content_.area.area_in_map;
    const auto grip = area_before_ ? gripAt(*area_before_, transform_, point_px) : std::nullopt;
    gesture_ = grip ? Gesture::DraggingGrip : Gesture::DrawingArea;
    held_grip_ = grip.value_or(AreaGrip{});
}

void MapView::dragArea(const QPointF& point_px) {
    const Vec2 to = transform_.toMap(point_px);
    const Rectangle area = gesture_ == Gesture::DrawingArea
                               ? spanned(pressed_m_, to, content_.world_in_map)
                               : dragged(*area_before_, {held_grip_, pressed_m_, to}, content_.world_in_map);
    if (area.empty())
        return;
    content_.area.area_in_map = area;
    emit areaEdited(area);
}

void MapView::finishAreaGesture(Gesture gesture, const QPointF& point_px) {
    const QString reason = gesture == Gesture::DrawingArea
                               ? refusal(pressed_m_, transform_.toMap(point_px), content_.world_in_map)
                               : QString();
    if (!reason.isEmpty()) {
        restoreArea();
        emit areaRefused(reason);
    } else if (content_.area.area_in_map) {
        emit areaChanged(*content_.area.area_in_map);
    }
}

void MapView::restoreArea() {
    content_.area.area_in_map = area_before_;
    emit areaEdited(area_before_.value_or(Rectangle{}));
}

void MapView::cancelGesture() {
    if (gesture_ == Gesture::DrawingArea || gesture_ == Gesture::DraggingGrip)
        restoreArea();
    content_.objects.held.clear();
    gesture_ = Gesture::None;
    updateCursor();
    update();
}

void MapView::panBy(const QPointF& by_px) {
    transform_.pan(by_px);
    view_touched_ = true;
    setFollowing(false);
}

void MapView::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    if (notches != 0.0) {
        transform_.zoomAt(event->position(), std::pow(1.2, notches));
        view_touched_ = true;
        update();
    }
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent* event) {
    const double step = event->modifiers() & Qt::ShiftModifier ? 240.0 : 64.0;
    switch (event->key()) {
    case Qt::Key_Left:
        return panBy(QPointF(step, 0.0));
    case Qt::Key_Right:
        return panBy(QPointF(-step, 0.0));
    case Qt::Key_Up:
        return panBy(QPointF(0.0, step));
    case Qt::Key_Down:
        return panBy(QPointF(0.0, -step));
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomIn();
    case Qt::Key_Minus:
        return zoomOut();
    case Qt::Key_N:
        return walkStartPoses(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
    case Qt::Key_Escape:
        if (gesture_ != Gesture::None)
            return cancelGesture();
        if (tool_ == MapTool::Place || tool_ == MapTool::Waypoint)
            return setTool(MapTool::Pan);
        break;
    case Qt::Key_Delete:
        if (!content_.objects.selected.isEmpty())
            return emit objectRemovalRequested(content_.objects.selected);
        break;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (content_.hot_start_pose)
            return emit spawnRequested(static_cast<int>(*content_.hot_start_pose));
        break;
    case Qt::Key_Space:
        if (content_.hot_start_pose)
            return askAbout(*content_.hot_start_pose);
        break;
    default:
        break;
    }
    QWidget::keyPressEvent(event);
}

void MapView::walkStartPoses(int by) {
    const int count = static_cast<int>(content_.start_poses.size());
    if (count == 0)
        return;
    const int from = content_.hot_start_pose ? static_cast<int>(*content_.hot_start_pose) : (by > 0 ? -1 : 0);
    content_.hot_start_pose = static_cast<std::size_t>((from + by + count) % count);
    const auto& pose = content_.start_poses[*content_.hot_start_pose];
    setAccessibleDescription(
        tr("Start pose %1. Return spawns a robot, Space asks first.").arg(QString::fromStdString(pose.name)));
    const Vec2 at = pose.pose_in_map.position_m.head<2>();
    if (!QRectF(QPointF(), transform_.viewport).contains(transform_.toScreen(at)))
        transform_.center_m = at;
    update();
}

void MapView::leaveEvent(QEvent*) {
    cursor_px_.reset();
    showGhost({});
    content_.hot_start_pose.reset();
    content_.area.hot_grip.reset();
    update();
}

void MapView::updateCursor() {
    Qt::CursorShape shape = tool_ == MapTool::Pan ? Qt::ArrowCursor : Qt::CrossCursor;
    if (gesture_ == Gesture::DraggingObject)
        shape = Qt::SizeAllCursor;
    else if (gesture_ == Gesture::Panning)
        shape = Qt::ClosedHandCursor;
    else if (content_.area.hot_grip)
        shape = content_.area.hot_grip->middle() ? Qt::SizeAllCursor : Qt::PointingHandCursor;
    else if (content_.hot_start_pose && tool_ == MapTool::Pan)
        shape = Qt::PointingHandCursor;
    setCursor(shape);
}

QString MapView::toolTipAt(const QPointF& point_px) const {
    if (const QString robot = robotAt(point_px); !robot.isEmpty()) {
        const MapRobot& r = content_.robots.at(robot).robot;
        return tr("%1, z %2 m, yaw %3°. Click selects it (key %4).")
            .arg(robot, figure(r.base_in_map.position_m.z(), 2), figure(degrees(r.base_in_map.yaw_rad), 0))
            .arg(r.number);
    }
    if (const auto i = startPoseAt(point_px))
        return tr("Start pose %1. Double-click spawns a robot here; one click asks which.")
            .arg(QString::fromStdString(content_.start_poses[*i].name));
    return objectToolTip(point_px);
}

bool MapView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace usar::widgets
