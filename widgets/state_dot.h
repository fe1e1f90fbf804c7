// A state as a shape and a color, always beside its word.
#pragma once

#include <QWidget>

namespace usar::widgets {

/// Each has a shape of its own, so that color is never alone.
enum class StateShape {
    Off,     ///< hollow circle, muted
    Busy,    ///< half circle, accent
    Good,    ///< full circle, ok
    Waiting, ///< hollow triangle, caution
    Bad      ///< cross in a circle, danger
};

/// 16 x 16; takes no focus, because the word beside it is what assistive tools read.
class StateDot : public QWidget {
    Q_OBJECT
public:
    explicit StateDot(QWidget* parent = nullptr);
    /// The word beside it is the caller's to change.
    void setState(StateShape state);
    StateShape state() const { return state_; }
    QSize sizeHint() const override { return {16, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StateShape state_ = StateShape::Off;
};

/// The ink of that state's word.
QColor stateColor(StateShape state);

} // namespace usar::widgets
