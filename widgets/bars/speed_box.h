// List of speeds at which time can run, for simulators and replays.
#pragma once

#include <QComboBox>

namespace usar::widgets {

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
