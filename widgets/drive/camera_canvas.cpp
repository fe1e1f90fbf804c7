#include "widgets/drive/camera_canvas.h"

#include <algorithm>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double key_step = 0.125;
constexpr double wheel_notch = 120.0;

} // namespace

CameraCanvas::CameraCanvas(QWidget* parent) : Instrument(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    named(this, tr("Camera picture"),
          tr("Drag to turn the camera, use the wheel to zoom; with the focus here, the arrow keys turn it"));
}

void CameraCanvas::setPicture(const QImage& picture) {
    picture_ = picture;
    showFresh({});
}

QRect CameraCanvas::pictureRect() const {
    QRect place({}, picture_.size().scaled(size(), Qt::KeepAspectRatio));
    place.moveCenter(rect().center());
    return place;
}

void CameraCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), picture_.isNull() ? tokens().surface : tokens().background);
    if (picture_.isNull())
        return;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(stale() ? 0.35 : 1.0);
    painter.drawImage(pictureRect(), picture_);
    painter.setOpacity(1.0);
    if (hasFocus()) {
        painter.setPen(QPen(tokens().accent, 2.0));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void CameraCanvas::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || picture_.isNull())
        return event->ignore();
    grabbing_ = true;
    grabbed_ = event->position().toPoint();
    setCursor(Qt::ClosedHandCursor);
}

void CameraCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!grabbing_)
        return;
    const QPoint way = event->position().toPoint() - grabbed_;
    grabbed_ += way;
    const double width_px = std::max(1, pictureRect().width());
    emit turned(-way.x() / width_px, way.y() / width_px);
}

void CameraCanvas::mouseReleaseEvent(QMouseEvent*) {
    grabbing_ = false;
    setCursor(Qt::OpenHandCursor);
}

void CameraCanvas::wheelEvent(QWheelEvent* event) {
    if (picture_.isNull())
        return event->ignore();
    emit zoomed(event->angleDelta().y() / wheel_notch);
    event->accept();
}

void CameraCanvas::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Left:
        return emit turned(-key_step, 0.0);
    case Qt::Key_Right:
        return emit turned(key_step, 0.0);
    case Qt::Key_Up:
        return emit turned(0.0, key_step);
    case Qt::Key_Down:
        return emit turned(0.0, -key_step);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace usar::widgets
