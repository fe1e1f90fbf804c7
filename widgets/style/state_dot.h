// Symbol that shows a state by shape and color, always beside a word.
#pragma once

#include <QWidget>

namespace usar::widgets {

/// Each state has a shape of its own, so that color is never the only distinction.
enum class StateShape {
    Off,     ///< hollow circle, muted
    Busy,    ///< half circle, accent
    Good,    ///< full circle, ok
    Waiting, ///< hollow triangle, caution
    Bad      ///< cross in a circle, danger
};

/// 16 x 16 pixels; takes no focus, because assistive tools read the word beside it.
class StateDot : public QWidget {
    Q_OBJECT
public:
    explicit StateDot(QWidget* parent = nullptr);
    /// The caller must change the word beside it as well.
    void setState(StateShape state);
    StateShape state() const { return state_; }
    QSize sizeHint() const override { return {16, 16}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    StateShape state_ = StateShape::Off;
};

/// Text color for the word of that state.
QColor stateColor(StateShape state);

} // namespace usar::widgets
