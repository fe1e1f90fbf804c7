// Slider that jumps to the place of a click, as time lines do, instead of moving by a page.
#pragma once

#include <QSlider>

namespace usar::widgets {

/// A click emits sliderMoved, like dragging; a notch of the wheel has the effect of an arrow key. GUI thread.
class TimeSlider : public QSlider {
public:
    explicit TimeSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    int turned_ = 0; ///< rotation of the wheel that is less than a notch so far
};

} // namespace usar::widgets
