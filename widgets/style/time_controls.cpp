#include "widgets/style/time_controls.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>

namespace usar::widgets {

void TimeSlider::mousePressEvent(QMouseEvent* event) {
    const int handle_px = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
    const int x = static_cast<int>(std::lround(event->position().x()));
    const int here =
        QStyle::sliderValueFromPosition(minimum(), maximum(), x - handle_px / 2, width() - handle_px, false);
    const int now_x = QStyle::sliderPositionFromValue(minimum(), maximum(), value(), width() - handle_px);
    if (event->button() == Qt::LeftButton && (x < now_x || x > now_x + handle_px)) {
        setSliderPosition(here);
        emit sliderMoved(here);
    }
    QSlider::mousePressEvent(event); // The handle is under the cursor now, and dragging continues from there.
}

/// QSlider itself would report SliderMove, as for dragging, instead of a step.
void TimeSlider::wheelEvent(QWheelEvent* event) {
    constexpr int notch = QWheelEvent::DefaultDeltasPerStep;
    turned_ += event->angleDelta().y();
    for (; turned_ >= notch; turned_ -= notch)
        triggerAction(SliderSingleStepAdd);
    for (; turned_ <= -notch; turned_ += notch)
        triggerAction(SliderSingleStepSub);
    event->accept();
}

SpeedBox::SpeedBox(QWidget* parent) : QComboBox(parent) {
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        addItem(QStringLiteral("%1×").arg(speed), speed);
    addItem(tr("max"), double(INFINITY));
    setSpeed(1.0);
}

void SpeedBox::setSpeed(double speed) {
    const auto off = [&](int row) { return std::abs(std::log(itemData(row).toDouble() / speed)); };
    int nearest = std::isinf(speed) ? count() - 1 : 0;
    for (int i = 1; i < count() && std::isfinite(speed); ++i)
        if (off(i) < off(nearest))
            nearest = i;
    setCurrentIndex(nearest);
}

void SpeedBox::step(int entries) {
    setCurrentIndex(std::clamp(currentIndex() + entries, 0, count() - 1));
}

} // namespace usar::widgets
