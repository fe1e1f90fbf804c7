#include "widgets/drive/drive_pad.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTouchEvent>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr double knob_px = 13.0;
constexpr int slider_px = 40;
constexpr int arrow_keys[] = {Qt::Key_Up, Qt::Key_Down, Qt::Key_Left, Qt::Key_Right};

int arrowBit(int key) {
    const auto* const found = std::ranges::find(arrow_keys, key);
    return found == std::end(arrow_keys) ? 0 : 1 << (found - arrow_keys);
}

} // namespace

DrivePad::DrivePad(PadShape shape, QWidget* parent) : QWidget(parent), shape_(shape) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setSizePolicy(shape == PadShape::Upright ? QSizePolicy::Fixed : QSizePolicy::Expanding,
                  shape == PadShape::Across ? QSizePolicy::Fixed : QSizePolicy::Expanding);
}

QSize DrivePad::sizeWith(int pad_px) const {
    return {shape_ == PadShape::Upright ? slider_px : pad_px, shape_ == PadShape::Across ? slider_px : pad_px};
}

void DrivePad::setShown(const QPointF& asked, const QPointF& sent) {
    if (asked_ == asked && sent_ == sent)
        return;
    asked_ = asked;
    sent_ = sent;
    update();
}

void DrivePad::setKeys(const QStringList& keys) {
    if (std::exchange(keys_, keys) != keys)
        update();
}

void DrivePad::letGo() {
    arrows_ = 0;
    put({}, false);
}

/// Returns the rectangle in which the middle of the knob can be.
QRectF DrivePad::travel() const {
    const double side = std::min(width(), height());
    const QPointF middle = QRectF(rect()).center();
    const double across = shape_ == PadShape::Upright ? 0.0 : (shape_ == PadShape::Across ? width() : side);
    const double upright = shape_ == PadShape::Across ? 0.0 : (shape_ == PadShape::Upright ? height() : side);
    const QSizeF size(std::max(0.0, across - 2.0 * knob_px - 4.0), std::max(0.0, upright - 2.0 * knob_px - 4.0));
    return {middle - QPointF(size.width() / 2.0, size.height() / 2.0), size};
}

QPointF DrivePad::toScreen(const QPointF& value) const {
    const QRectF way = travel();
    return way.center() + QPointF(value.x() * way.width() / 2.0, -value.y() * way.height() / 2.0);
}

void DrivePad::hold(const QPointF& at_px) {
    const QRectF way = travel();
    const QPointF from = at_px - way.center();
    const auto share = [](double px, double whole_px) {
        return whole_px > 0.0 ? std::clamp(px / (whole_px / 2.0), -1.0, 1.0) : 0.0;
    };
    QPointF value(share(from.x(), way.width()), -share(from.y(), way.height()));
    if (shape_ == PadShape::Both) // Ignores the slight sideways motion of a finger that moves straight.
        for (double* const part : {&value.rx(), &value.ry()})
            *part = std::abs(*part) < 0.06 ? 0.0 : *part;
    put(value, true);
}

void DrivePad::put(const QPointF& value, bool held) {
    const bool same = value == value_ && held == held_;
    held_ = held;
    if (same)
        return;
    value_ = value;
    update();
    emit moved(value_);
}

bool DrivePad::event(QEvent* event) {
    const QEvent::Type type = event->type();
    if (type == QEvent::TouchBegin || type == QEvent::TouchUpdate) {
        const auto& points = static_cast<QTouchEvent*>(event)->points();
        if (isEnabled() && !points.isEmpty())
            hold(points.front().position());
    } else if (type == QEvent::TouchEnd || type == QEvent::TouchCancel) {
        letGo();
    } else {
        if (type == QEvent::ShortcutOverride && arrowBit(static_cast<QKeyEvent*>(event)->key()) != 0)
            event->accept(); // Arrow keys pan the map elsewhere.
        return QWidget::event(event);
    }
    event->accept();
    return true;
}

void DrivePad::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        hold(event->position());
}

void DrivePad::mouseMoveEvent(QMouseEvent* event) {
    if (held_ && (event->buttons() & Qt::LeftButton))
        hold(event->position());
}

void DrivePad::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        letGo();
}

void DrivePad::takeArrow(int key, bool down) {
    arrows_ = down ? arrows_ | arrowBit(key) : arrows_ & ~arrowBit(key);
    const auto share = [this](int more, int less) {
        return double((arrows_ & arrowBit(more)) != 0) - double((arrows_ & arrowBit(less)) != 0);
    };
    put({shape_ == PadShape::Upright ? 0.0 : share(Qt::Key_Right, Qt::Key_Left),
         shape_ == PadShape::Across ? 0.0 : share(Qt::Key_Up, Qt::Key_Down)},
        arrows_ != 0);
}

void DrivePad::keyPressEvent(QKeyEvent* event) {
    if (arrowBit(event->key()) == 0)
        return QWidget::keyPressEvent(event);
    if (!event->isAutoRepeat())
        takeArrow(event->key(), true);
}

void DrivePad::keyReleaseEvent(QKeyEvent* event) {
    if (arrowBit(event->key()) == 0)
        return QWidget::keyReleaseEvent(event);
    if (!event->isAutoRepeat())
        takeArrow(event->key(), false);
}

void DrivePad::focusOutEvent(QFocusEvent* event) {
    letGo();
    QWidget::focusOutEvent(event);
}

void DrivePad::hideEvent(QHideEvent* event) {
    letGo();
    QWidget::hideEvent(event);
}

void DrivePad::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        letGo();
    QWidget::changeEvent(event);
}

void DrivePad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintGround(painter);
    paintKeys(painter);
    paintStick(painter);
}

void DrivePad::paintGround(QPainter& painter) const {
    const Tokens& t = tokens();
    const QRectF ground = travel().adjusted(-knob_px - 1.0, -knob_px - 1.0, knob_px + 1.0, knob_px + 1.0);
    const QPointF middle = ground.center();
    painter.setPen(QPen(hasFocus() ? t.accent : t.line, hasFocus() ? 2.0 : 1.0));
    painter.setBrush(isEnabled() ? t.raised : t.surface);
    const double corner = shape_ == PadShape::Both ? ground.width() / 2.0 : knob_px + 1.0;
    painter.drawRoundedRect(ground, corner, corner);
    painter.setPen(QPen(t.line, 1.0));
    const QRectF way = travel();
    if (shape_ == PadShape::Both) {
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(middle, way.width() / 4.0, way.height() / 4.0);
    }
    painter.drawLine(QLineF(way.left(), middle.y(), way.right(), middle.y()));
    painter.drawLine(QLineF(middle.x(), way.top(), middle.x(), way.bottom()));
}

void DrivePad::paintKeys(QPainter& painter) const {
    const QPointF places[] = {{0.0, 1.0}, {0.0, -1.0}, {-1.0, 0.0}, {1.0, 0.0}};
    painter.setFont(themeFont(FontRole::Small, QFont::DemiBold));
    painter.setPen(isEnabled() ? tokens().text_muted : tokens().stale);
    for (qsizetype i = 0; i < std::min<qsizetype>(keys_.size(), 4); ++i)
        painter.drawText(QRectF(toScreen(places[i]) - QPointF(12.0, 10.0), QSizeF(24.0, 20.0)), Qt::AlignCenter,
                         keys_[i]);
}

void DrivePad::paintStick(QPainter& painter) const {
    const Tokens& t = tokens();
    const QPointF stick = held_ ? value_ : asked_;
    const bool moved = !stick.isNull();
    const QPointF at = toScreen(stick);
    if (!isEnabled())
        return;
    painter.setPen(QPen(moved ? t.accent : t.text_muted, 2.0));
    painter.drawLine(toScreen({}), at);
    painter.setBrush(moved ? t.accent : t.surface);
    painter.drawEllipse(at, knob_px - 2.0, knob_px - 2.0);
    if (sent_.isNull())
        return;
    painter.setPen(QPen(t.text, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(toScreen(sent_), 5.0, 5.0);
}

} // namespace usar::widgets
