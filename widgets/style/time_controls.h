// Controls of time lines: a slider that jumps to the place of a click, and a list of speeds.
#pragma once

#include <QComboBox>
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

/// Offers 0.1 to 100 times the usual pace and "max", which is infinity. Emits QComboBox::activated only for choices of
/// the user. GUI thread.
class SpeedBox : public QComboBox {
public:
    explicit SpeedBox(QWidget* parent);

    /// The chosen multiple of the usual pace; infinity for "max".
    double speed() const { return currentData().toDouble(); }
    /// Shows the nearest speed of the list.
    void setSpeed(double speed);
    /// Moves by so many entries and stops at the ends of the list.
    void step(int entries);
};

} // namespace usar::widgets
