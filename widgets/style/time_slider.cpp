#include "widgets/style/time_slider.h"

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

} // namespace usar::widgets
