// Bar that shows the position of a replay, with controls to move through the recording; and the badge that shows
// whether a recording is being written, for how long, and how large it is.
#pragma once

#include <cstdint>
#include <optional>

#include <QFrame>
#include <QLabel>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/time_controls.h"

namespace usar::widgets {

/// State of a replay. Times count from the beginning of the recording.
struct ReplayState {
    Seconds position{0.0};
    Seconds span{0.0};  ///< length of the recording
    double speed = 1.0; ///< times the pace of the recording; infinity: as fast as possible
    bool playing = false;
};

/// Shows the state it is given and reports wishes by signals; it plays nothing itself. While the user drags the slider
/// it follows the mouse, not the state. The buttons belong to commands. GUI thread.
class ReplayBar : public QFrame {
    Q_OBJECT
public:
    explicit ReplayBar(QWidget* parent = nullptr);

    /// Sets the actions of the buttons, which must outlive the bar; the icon of `play` shows what it would do.
    void setActions(QAction* play, QAction* back, QAction* forward, QAction* step, QAction* close);
    /// Shows this state; emits nothing.
    void setState(const ReplayState& state);
    /// The state as last set, even while the slider follows the mouse.
    const ReplayState& state() const { return state_; }
    /// Path of the recording, for the tooltip at the left.
    void setFile(const QString& path) { name_->setToolTip(path); }
    /// Moves so many entries up or down the list of speeds and emits speedRequested, as if the user had done it.
    void changeSpeed(int entries);
    /// Its range is the whole recording in equal steps, whatever its length.
    QSlider* slider() const { return slider_; }

signals:
    /// The user wants to go to this position, measured from the beginning of the recording.
    void seekRequested(usar::Seconds position);
    /// 0.1 to 100 times the pace of the recording, or infinity.
    void speedRequested(double speed);

private:
    /// Shows this position and the length of the recording as hours, minutes and seconds.
    void showTime(Seconds position);
    /// The position in the recording for a value of the slider.
    Seconds positionOf(int value) const;

    ReplayState state_;
    QLabel* name_ = new QLabel(tr("Replay"), this);
    QToolButton* back_ = new QToolButton(this);
    QToolButton* play_ = new QToolButton(this);
    QToolButton* forward_ = new QToolButton(this);
    QToolButton* step_ = new QToolButton(this);
    QToolButton* close_ = new QToolButton(this);
    QSlider* slider_ = new TimeSlider(this);
    QLabel* time_ = new QLabel(this);
    SpeedBox* speed_ = new SpeedBox(this);
};

/// State of the recording that is being written.
struct RecordState {
    Seconds elapsed{0.0};                       ///< since the beginning of the recording
    std::uint64_t bytes = 0;                    ///< size so far
    QString path;                               ///< part of the tooltip, as the next one
    std::optional<std::uint64_t> limit_bytes{}; ///< the most bytes that are kept
};

/// The button belongs to a command; its dot is red while a recording is being written. GUI thread.
class RecordBadge : public QWidget {
    Q_OBJECT
public:
    explicit RecordBadge(QWidget* parent = nullptr);

    /// The action of the button; it must outlive the badge.
    void setAction(QAction* action);
    /// `nullopt`: no recording is being written.
    void setState(const std::optional<RecordState>& state);
    /// Set to false if there is no room for the figures; the tooltip still has them.
    void setFiguresShown(bool shown) { figures_->setVisible(shown); }
    /// The shown figures; without a recording the words "not recorded" or "REC ready".
    QString text() const { return figures_->text(); }

private:
    /// Updates the icon, and the words that are shown without a recording.
    void refresh();

    QToolButton* button_ = new QToolButton(this);
    QLabel* figures_ = mutedLabel({}, this);
    bool writing_ = false;
};

} // namespace usar::widgets
