// A slider that goes where it is clicked, as time lines do, and not a page nearer.
#pragma once

#include <QSlider>

namespace usar::widgets {

/// A click tells by sliderMoved, as dragging does; a notch of the wheel is a key's step. GUI thread.
class TimeSlider : public QSlider {
public:
    explicit TimeSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    int turned_ = 0; ///< of the wheel, less than a notch
};

} // namespace usar::widgets
