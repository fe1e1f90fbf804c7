// Where a replay stands, and how to get elsewhere in it.
#pragma once

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include "core/base/clock.h"

namespace usar::widgets {

/// Times count from the recording's beginning.
struct ReplayState {
    Seconds position{0.0};
    Seconds span{0.0};
    double speed = 1.0; ///< infinity: as fast as it can
    bool playing = false;
    bool seeking = false;
    bool operator==(const ReplayState&) const = default;
};

/// Wishes out, state in: it plays nothing itself. While the person drags the slider it follows the hand and not the
/// state. Buttons are those of commands. GUI thread.
class ReplayBar : public QFrame {
    Q_OBJECT
public:
    explicit ReplayBar(QWidget* parent = nullptr);

    /// The commands behind the buttons; `play` gets the icon of what it would do.
    void setActions(QAction* play, QAction* back, QAction* forward, QAction* step, QAction* close);
    void setState(const ReplayState& state);
    const ReplayState& state() const { return state_; }
    /// Which recording, for the tooltip at the left.
    void setFile(const QString& path) { name_->setToolTip(path); }
    /// So many entries up or down the list of speeds, as the person would.
    void changeSpeed(int entries);
    QSlider* slider() const { return slider_; }

signals:
    void seekRequested(usar::Seconds position);
    /// 0.1 to 100, or infinity.
    void speedRequested(double speed);

private:
    void showTime(Seconds position);
    Seconds positionOf(int value) const;

    ReplayState state_;
    QLabel* name_;
    QToolButton* back_;
    QToolButton* play_;
    QToolButton* forward_;
    QToolButton* step_;
    QToolButton* close_;
    QSlider* slider_;
    QLabel* time_;
    QComboBox* speed_;
};

} // namespace usar::widgets
