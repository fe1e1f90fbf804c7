// Keys, wheel and tooltips of the map; the mouse is in map_gestures.cpp.
#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "widgets/map/map_view.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

void MapView::wheelEvent(QWheelEvent* event) {
    if (const int delta = event->angleDelta().y(); delta != 0)
        zoomAt(event->position(), zoom_step::ofWheel(delta));
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent* event) {
    const double step_px = event->modifiers() & Qt::ShiftModifier ? 240.0 : 64.0;
    if (const QPointF way = arrowDirection(event->key()); !way.isNull())
        panBy(QPointF(-way.x(), way.y()) * step_px); // The ground moves against the arrow.
    else if (!actByKey(*event))
        QWidget::keyPressEvent(event);
}

bool MapView::actByKey(const QKeyEvent& event) {
    const auto hot = content_.hot_start_pose;
    switch (event.key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomIn(), true;
    case Qt::Key_Minus:
        return zoomOut(), true;
    case Qt::Key_N:
        return walkStartPoses(event.modifiers() & Qt::ShiftModifier ? -1 : 1), true;
    case Qt::Key_Escape:
        if (!gestures_.escape())
            return false;
        emit escapeUsed();
        return true;
    case Qt::Key_Delete:
        if (content_.objects.selected.isEmpty())
            return false;
        emit objectRemovalRequested(content_.objects.selected);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (hot)
            emit spawnRequested(static_cast<int>(*hot));
        return hot.has_value();
    case Qt::Key_Space:
        if (hot)
            askAbout(*hot);
        return hot.has_value();
    default:
        return false;
    }
}

void MapView::walkStartPoses(int by) {
    const protocol::StartPose* const pose = content_.stepStartPose(by);
    if (!pose)
        return;
    setAccessibleDescription(
        tr("Start pose %1. Return spawns a robot, Space asks first.").arg(QString::fromStdString(pose->name)));
    const Vec2 at = pose->pose_in_map.position_m.head<2>();
    if (!QRectF(QPointF(), transform_.viewport).contains(transform_.toScreen(at)))
        transform_.center_m = at;
    moved();
}

void MapView::askAbout(std::size_t start_pose) {
    const QPointF at = transform_.toScreen(content_.start_poses[start_pose].pose_in_map.position_m.head<2>());
    emit startPoseClicked(static_cast<int>(start_pose), mapToGlobal((at + QPointF(24.0, 24.0)).toPoint()));
}

bool MapView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), MapHits(content_, transform_).toolTipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace usar::widgets
