#include "widgets/drive/camera_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QAction>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QWheelEvent>

#include "core/base/geometry.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {
namespace {

constexpr double key_step = 0.125;
constexpr double wheel_notch = 120.0;

constexpr int slider_steps = 100;
constexpr double notch_factor = 1.15;
constexpr double old_s = 2.0;
/// Reach of the cross from the center; inside the nearer one the picture stays free. In pixels.
constexpr int cross_begin_px = 4;
constexpr int cross_end_px = 14;

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

void CameraCanvas::setNote(const QString& note) {
    if (std::exchange(note_, note) != note)
        update();
}

void CameraCanvas::setOverlayShown(bool shown) {
    if (std::exchange(overlay_shown_, shown) != shown)
        update();
}

void CameraCanvas::paintOverlay(QPainter& painter) const {
    const QRect place = pictureRect();
    painter.save();
    painter.setClipRect(place);
    for (const QPen& pen : {QPen(tokens().background, 3.0, Qt::SolidLine, Qt::FlatCap),
                            QPen(tokens().accent, 1.0, Qt::SolidLine, Qt::FlatCap)}) {
        painter.setPen(pen);
        for (const QPoint& way : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)})
            painter.drawLine(place.center() + way * cross_begin_px, place.center() + way * cross_end_px);
    }
    const QFontMetricsF metrics(themeFont(FontRole::Small));
    QPointF baseline(place.left() + gap::small, place.bottom() - gap::tiny - metrics.descent());
    const QStringList lines = note_.split(u'\n', Qt::SkipEmptyParts);
    for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
        paintSheetNote(painter, baseline, metrics.elidedText(*line, Qt::ElideRight, place.width() - 2.0 * gap::small));
        baseline.ry() -= metrics.height();
    }
    painter.restore();
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
    if (overlay_shown_)
        paintOverlay(painter);
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
    const QPointF way = key_step * arrowDirection(event->key());
    if (way.isNull())
        return QWidget::keyPressEvent(event);
    emit turned(way.x(), way.y());
}

CameraView::CameraView(QWidget* parent) : QWidget(parent) {
    auto* column =
        laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::tiny, {canvas_});
    column->setStretchFactor(canvas_, 1);
    auto* facts = laidOut(new QHBoxLayout, -1, {source_, cameras_, freshness_});
    facts->insertStretch(2, 1);
    column->addLayout(facts);
    makeControls();
    column->addLayout(controls_);
    connect(canvas_, &CameraCanvas::turned, this,
            [this](double right, double up) { emit turnRequested(right * zoom_.now_rad, up * zoom_.now_rad); });
    connect(canvas_, &CameraCanvas::zoomed, this,
            [this](double notches) { askZoom(zoom_.now_rad * std::pow(notch_factor, -notches)); });
    connect(cameras_, &QComboBox::textActivated, this, &CameraView::cameraChosen);
    connect(&age_timer_, &QTimer::timeout, this, &CameraView::showAge);
    setSource({}, {}, {});
    setZoom({});
    setEmpty(tr("No robot yet"), tr("Pictures of the selected robot's camera appear here."));
}

void CameraView::makeControls() {
    source_->setProperty("role", "title");
    freshness_->setFont(themeFont(FontRole::Small));
    named(freshness_, tr("Pictures per second and age of the last one"),
          tr("Pictures per second, and how long ago the last one arrived"));
    named(cameras_, tr("Camera"), tr("The robot's camera that is shown"));
    slider_->setRange(0, slider_steps);
    slider_->setMinimumHeight(minimum_target);
    slider_->setAccessibleName(tr("Zoom"));
    angle_->setFont(themeFont(FontRole::Small));
    named(angle_, tr("Angle of view"), tr("Angle of view across the picture, in degrees"));
    angle_->setMinimumWidth(angle_->fontMetrics().horizontalAdvance(QStringLiteral("120°")));
    angle_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    controls_ = laidOut(new QHBoxLayout, gap::tiny, {slider_, angle_});
    controls_->setStretchFactor(slider_, 1);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        askZoom(zoom_.largest_rad * std::pow(zoom_.smallest_rad / zoom_.largest_rad, double(value) / slider_steps));
    });
}

void CameraView::setActions(const QList<QAction*>& actions) {
    for (QAction* const action : actions) {
        auto* button = new QToolButton(this);
        showAction(button, action);
        makeFlat(button);
        button->setFocusPolicy(Qt::StrongFocus);
        controls_->addWidget(button);
    }
}

void CameraView::setPicture(const QImage& picture, double frames_per_s) {
    const bool first = isEmpty();
    ++pictures_;
    frames_per_s_ = frames_per_s;
    age_.start();
    empty_->hide();
    canvas_->setPicture(picture);
    if (!first)
        return; // The figures are updated by the slower timer: setting a label's text lays out the whole dock again.
    slider_->setEnabled(zoom_.largest_rad > zoom_.smallest_rad);
    showAge();
}

void CameraView::setSource(const QString& robot, const QStringList& cameras, const QString& shown) {
    const bool choice = cameras.size() > 1;
    source_->setText(choice || shown.isEmpty() ? robot : tr("%1 · %2").arg(robot, shown));
    const QSignalBlocker quiet(cameras_);
    cameras_->clear();
    cameras_->addItems(cameras);
    cameras_->setCurrentText(shown);
    cameras_->setVisible(choice);
    showNote();
}

void CameraView::setZoom(const CameraZoom& zoom) {
    zoom_ = zoom;
    const bool fixed = zoom.largest_rad <= zoom.smallest_rad;
    slider_->setEnabled(!fixed && !isEmpty());
    const auto angle = [](double rad) { return figure(degrees(rad), 0) + QStringLiteral("°"); };
    tellRange(slider_, tr("Angle of view: wide on the left, close on the right"), angle(zoom.largest_rad),
              angle(zoom.smallest_rad));
    angle_->setText(angle(zoom.now_rad));
    showNote();
    if (fixed || slider_->isSliderDown())
        return;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(slider_steps * std::log(zoom.now_rad / zoom.largest_rad) /
                                                   std::log(zoom.smallest_rad / zoom.largest_rad))));
}

void CameraView::askZoom(double field_of_view_rad) {
    const double asked_rad = std::clamp(field_of_view_rad, std::min(zoom_.smallest_rad, zoom_.largest_rad),
                                        std::max(zoom_.smallest_rad, zoom_.largest_rad));
    if (asked_rad != zoom_.now_rad)
        emit zoomRequested(asked_rad);
}

void CameraView::setEmpty(const QString& title, const QString& hint, QAction* action) {
    if (isEmpty() && empty_->isVisibleTo(this) && empty_->accessibleName() == title &&
        empty_->accessibleDescription() == hint)
        return;
    canvas_->setPicture({});
    empty_->setText(title, hint);
    empty_->setAction(action);
    empty_->show();
    slider_->setEnabled(false);
    freshness_->clear();
    age_.invalidate();
}

void CameraView::showAge() {
    if (!age_.isValid())
        return;
    const double age_s = static_cast<double>(age_.elapsed()) / 1000.0;
    canvas_->setStale(age_s > old_s);
    freshness_->setText(age_s > old_s ? tr("%1 s old").arg(figure(age_s, 0))
                                      : tr("%1 frames/s · %2 s").arg(figure(frames_per_s_, 1), figure(age_s, 1)));
    showNote();
}

void CameraView::showNote() {
    const bool choice = cameras_->count() > 1;
    const QString source = choice ? tr("%1 · %2").arg(source_->text(), cameras_->currentText()) : source_->text();
    canvas_->setNote(source + '\n' + tr("%1 · %2").arg(freshness_->text(), angle_->text()));
}

void CameraView::watchedOrNot() {
    age_timer_.stop();
    if (wantsPictures())
        age_timer_.start(250);
    emit wantsPicturesChanged(wantsPictures());
}

void CameraView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    watchedOrNot();
}

void CameraView::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    watchedOrNot();
}

} // namespace usar::widgets
