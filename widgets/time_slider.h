// A slider that goes where it is clicked, as time lines do, and not a page nearer.
#pragma once

#include <QSlider>

namespace usar::widgets {

/// A click tells by sliderMoved, as dragging does. GUI thread.
class TimeSlider : public QSlider {
public:
    explicit TimeSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

protected:
    void mousePressEvent(QMouseEvent* event) override;
};

} // namespace usar::widgets
