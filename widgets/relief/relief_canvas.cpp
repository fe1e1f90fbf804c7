#include "widgets/relief/relief_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "widgets/map/map_painter.h"
#include "widgets/models/pan_zoom.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double turn_per_px = radians(0.35);
constexpr double key_turn = radians(5.0);
constexpr double key_pan_px = 64.0;
constexpr double slow_ms = 1000.0 / 30.0;
constexpr int rest_ms = 150;
constexpr double axes_px = 26.0; ///< length of an axis in the corner

} // namespace

ReliefCanvas::ReliefCanvas(QWidget* parent) : QWidget(parent) {
    camera_.yaw_rad = radians(135.0); // from the south-east
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(tr("3D view"));
    setAccessibleDescription(tr("Arrow keys orbit, with Shift they pan, plus and minus zoom, Home shows all, N turns y "
                                "up, T looks from above. The place in the middle is read."));
    rest_.setSingleShot(true);
    rest_.setInterval(rest_ms);
    connect(&rest_, &QTimer::timeout, this, &ReliefCanvas::frameWanted);
}

void ReliefCanvas::setFrame(const std::shared_ptr<const ReliefFrame>& frame) {
    if (!frame && !frame_)
        return;
    frame_ = frame;
    update();
    if (!frame)
        return;
    // An older frame may look from where the camera was before.
    if (shows_all_ && frame->show_all && frame->camera.yaw_rad == camera_.yaw_rad &&
        frame->camera.elevation_rad == camera_.elevation_rad)
        camera_ = frame->camera;
    if (frame->picture.width_px >= wholeSize_px().width())
        whole_took_ms_ = frame->took_ms;
    tellPointed();
}

void ReliefCanvas::tellPointed() {
    if (pointer_px_ || readsMiddle())
        emit pointed(pick(pointer_px_.value_or(QRectF(rect()).center())));
    else
        emit pointed(std::nullopt);
}

void ReliefCanvas::setCamera(const mapping::OrbitCamera& camera) {
    shows_all_ = false;
    camera_ = camera.limited();
    emit frameWanted();
}

void ReliefCanvas::setExaggeration(double exaggeration) {
    if (std::exchange(exaggeration_, std::clamp(exaggeration, 1.0, 5.0)) != exaggeration_)
        emit frameWanted();
}

void ReliefCanvas::showAll() {
    shows_all_ = true;
    emit frameWanted();
}

void ReliefCanvas::lookAt(const Vec3& point_in_map_m) {
    if (!point_in_map_m.allFinite() || (!shows_all_ && point_in_map_m == camera_.target_in_map_m))
        return;
    shows_all_ = false;
    camera_.target_in_map_m = point_in_map_m;
    emit frameWanted();
}

void ReliefCanvas::setLabels(const std::vector<Label>& labels) {
    if (std::exchange(labels_, labels) != labels)
        update();
}

void ReliefCanvas::setProbe(const QString& text) {
    if (std::exchange(probe_, text) != text)
        update();
}

QSize ReliefCanvas::wholeSize_px() const {
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

QSize ReliefCanvas::wantedSize_px() const {
    const bool half = rest_.isActive() && whole_took_ms_ > slow_ms;
    return half ? (wholeSize_px() / 2).expandedTo({1, 1}) : wholeSize_px();
}

std::optional<Vec3> ReliefCanvas::pick(const QPointF& at_px) const {
    if (!frame_ || size().isEmpty())
        return std::nullopt;
    const mapping::ReliefPicture& picture = frame_->picture;
    return picture.pick(static_cast<int>(std::floor(at_px.x() * picture.width_px / width())),
                        static_cast<int>(std::floor(at_px.y() * picture.height_px / height())), frame_->projection());
}

mapping::ReliefProjection ReliefCanvas::projection() const {
    return {camera_, std::max(width(), 1), std::max(height(), 1), exaggeration_};
}

void ReliefCanvas::moveTo(const mapping::OrbitCamera& camera) {
    shows_all_ = false;
    camera_ = camera.limited();
    rest_.start();
    emit frameWanted();
}

void ReliefCanvas::orbit(double right_px, double down_px) {
    mapping::OrbitCamera camera = camera_;
    camera.yaw_rad -= right_px * turn_per_px;
    camera.elevation_rad += down_px * turn_per_px;
    moveTo(camera);
}

void ReliefCanvas::pan(const QPointF& from_px, const QPointF& to_px) {
    const mapping::ReliefProjection now = projection();
    const auto from_m = now.onPlane(from_px.x(), from_px.y(), grabbed_height_m_);
    const auto to_m = now.onPlane(to_px.x(), to_px.y(), grabbed_height_m_);
    // Near the horizon a pixel is a long way.
    const double most_m = 4.0 * camera_.distance_m;
    if (!from_m || !to_m || (*from_m - *to_m).norm() > most_m)
        return;
    mapping::OrbitCamera camera = camera_;
    camera.target_in_map_m += *from_m - *to_m;
    moveTo(camera);
    emit movedByUser();
}

/// As far at any elevation, unlike a drag, which grasps nothing above the horizon.
void ReliefCanvas::panOverGround(const QPointF& way) {
    mapping::OrbitCamera camera = camera_;
    const Vec3 ahead(std::cos(camera.yaw_rad), std::sin(camera.yaw_rad), 0.0);
    const Vec3 right(ahead.y(), -ahead.x(), 0.0);
    const double step_m = key_pan_px * camera.distance_m / projection().focal_px();
    camera.target_in_map_m += step_m * (way.x() * right + way.y() * ahead);
    moveTo(camera);
    emit movedByUser();
}

void ReliefCanvas::zoom(const Vec3& toward_m, double factor) {
    mapping::OrbitCamera camera = camera_;
    camera.distance_m /= factor;
    camera = camera.limited();
    const double left = camera.distance_m / camera_.distance_m;
    camera.target_in_map_m = toward_m + (camera.target_in_map_m - toward_m) * left;
    moveTo(camera);
}

bool ReliefCanvas::event(QEvent* event) {
    // The window has commands with the same keys.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* const key = static_cast<QKeyEvent*>(event);
        const bool plain = (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
        constexpr std::array own{Qt::Key_Home, Qt::Key_N, Qt::Key_T, Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus};
        if (plain && (std::ranges::find(own, key->key()) != own.end() || !arrowDirection(key->key()).isNull())) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void ReliefCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    emit frameWanted();
}

void ReliefCanvas::mousePressEvent(QMouseEvent* event) {
    grabbed_px_ = event->position();
    grabbed_height_m_ = pick(event->position()).value_or(camera_.target_in_map_m).z();
    setCursor(Qt::ClosedHandCursor);
}

void ReliefCanvas::mouseMoveEvent(QMouseEvent* event) {
    if (!grabbed_px_ || event->buttons() == Qt::NoButton) {
        pointer_px_ = event->position();
        update(); // The cross in the middle goes.
        return tellPointed();
    }
    const QPointF from_px = std::exchange(*grabbed_px_, event->position());
    const QPointF by_px = event->position() - from_px;
    if (event->buttons() & Qt::LeftButton && !(event->modifiers() & Qt::ShiftModifier))
        orbit(by_px.x(), by_px.y());
    else
        pan(from_px, event->position());
}

void ReliefCanvas::mouseReleaseEvent(QMouseEvent*) {
    grabbed_px_.reset();
    setCursor(Qt::OpenHandCursor);
}

void ReliefCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
    if (const auto point_m = pick(event->position())) {
        lookAt(*point_m);
        emit movedByUser();
    }
}

void ReliefCanvas::wheelEvent(QWheelEvent* event) {
    const auto under_m = keeps_target_ ? std::nullopt : pick(event->position());
    if (const int delta = event->angleDelta().y(); delta != 0)
        zoom(under_m.value_or(camera_.target_in_map_m), zoom_step::ofWheel(delta));
    event->accept();
}

void ReliefCanvas::leaveEvent(QEvent*) {
    pointer_px_.reset();
    update();
    tellPointed();
}

void ReliefCanvas::focusInEvent(QFocusEvent* event) {
    QWidget::focusInEvent(event);
    tellPointed();
}

void ReliefCanvas::focusOutEvent(QFocusEvent* event) {
    QWidget::focusOutEvent(event);
    tellPointed();
}

bool ReliefCanvas::actByKey(int key, bool shift) {
    if (const QPointF way = arrowDirection(key); !way.isNull()) {
        if (shift)
            panOverGround(way);
        else
            orbit(-way.x() * key_turn / turn_per_px, way.y() * key_turn / turn_per_px);
        return true;
    }
    mapping::OrbitCamera camera = camera_;
    switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(camera_.target_in_map_m, zoom_step::closer), true;
    case Qt::Key_Minus:
        return zoom(camera_.target_in_map_m, zoom_step::farther), true;
    case Qt::Key_Home:
        showAll();
        emit movedByUser();
        return true;
    case Qt::Key_N:
        camera.yaw_rad = pi / 2;
        return moveTo(camera), true;
    case Qt::Key_T:
        camera.elevation_rad = mapping::OrbitCamera::highest_elevation_rad;
        return moveTo(camera), true;
    default:
        return false;
    }
}

void ReliefCanvas::keyPressEvent(QKeyEvent* event) {
    if (!actByKey(event->key(), event->modifiers() & Qt::ShiftModifier))
        return QWidget::keyPressEvent(event);
    pointer_px_.reset(); // Whoever uses keys reads the middle, even if the mouse lies over the view.
    tellPointed();
}

void ReliefCanvas::paintLabels(QPainter& painter) const {
    const mapping::ReliefProjection shown(frame_->camera, width(), height(), frame_->exaggeration);
    for (const Label& label : labels_)
        if (const auto at = shown.project(label.place_in_map_m))
            paintChip(painter, QPointF(at->x_px, at->y_px + 12.0), label.text, Qt::AlignHCenter | Qt::AlignTop);
}

void ReliefCanvas::paintAxes(QPainter& painter) const {
    const Tokens& t = tokens();
    const QPointF origin(width() - gap::medium - axes_px, gap::medium + axes_px + gap::small);
    painter.setPen(Qt::NoPen);
    painter.setBrush(faded(t.background, 0.7));
    painter.drawEllipse(origin, axes_px + 12.0, axes_px + 12.0);
    painter.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    mapping::OrbitCamera around = frame_->camera;
    around.target_in_map_m = Vec3::Zero();
    const mapping::ReliefProjection turn(around, 100, 100);
    const Vec3 middle = turn.toCamera(Vec3::Zero());
    const std::array<std::pair<Vec3, QString>, 3> axes{{{Vec3::UnitX(), QStringLiteral("x")},
                                                        {Vec3::UnitY(), QStringLiteral("y")},
                                                        {Vec3::UnitZ(), QStringLiteral("z")}}};
    for (const auto& [axis, name] : axes) {
        const Vec3 way = turn.toCamera(axis) - middle;
        const QPointF by(way.x() * axes_px * 0.72, -way.y() * axes_px * 0.72);
        if (std::hypot(by.x(), by.y()) < 3.0) // It points to the viewer.
            continue;
        painter.setPen(QPen(name == QStringLiteral("y") ? t.text : t.text_muted, 2.0));
        painter.drawLine(origin, origin + by);
        const QPointF at = origin + by + by / std::hypot(by.x(), by.y()) * 8.0;
        painter.drawText(QRectF(at.x() - 8.0, at.y() - 9.0, 16.0, 18.0), Qt::AlignCenter, name);
    }
}

void ReliefCanvas::paintMiddle(QPainter& painter) const {
    const QPointF middle = QRectF(rect()).center();
    constexpr double inner_px = 4.0, outer_px = 11.0;
    for (const QPen& pen : {QPen(faded(tokens().background, 0.8), 3.5), QPen(tokens().accent, 1.5)}) {
        painter.setPen(pen);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(middle + inner_px * way, middle + outer_px * way);
    }
}

void ReliefCanvas::paintFrame(QPainter& painter) const {
    const mapping::ReliefPicture& picture = frame_->picture;
    const QImage image(reinterpret_cast<const uchar*>(picture.argb.data()), picture.width_px, picture.height_px,
                       picture.width_px * 4, QImage::Format_RGB32);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image.width() < wholeSize_px().width());
    painter.drawImage(rect(), image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLabels(painter);
    paintAxes(painter);
}

QImage ReliefCanvas::picture() const {
    if (!frame_)
        return {};
    QImage image(frame_->picture.width_px, frame_->picture.height_px, QImage::Format_RGB32);
    QPainter painter(&image);
    painter.scale(double(image.width()) / std::max(width(), 1), double(image.height()) / std::max(height(), 1));
    paintFrame(painter);
    return image;
}

void ReliefCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (!frame_) {
        painter.fillRect(rect(), tokens().background);
        return;
    }
    paintFrame(painter);
    if (readsMiddle())
        paintMiddle(painter);
    if (!probe_.isEmpty())
        paintChip(painter, QPointF(gap::medium, height() - gap::medium), probe_, Qt::AlignLeft | Qt::AlignBottom);
    if (hasFocus()) {
        painter.setPen(QPen(tokens().accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    }
}

} // namespace usar::widgets
