// Bar for time: the protocol clock and, for a simulator, pause, step, speed and real-time factor.
#pragma once

#include <optional>

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/time_controls.h"

namespace usar::widgets {

/// Shows figures and reports requests; it does not measure time. A speed of infinity means "as fast as possible". GUI
/// thread.
class TimeBar : public QWidget {
    Q_OBJECT
public:
    explicit TimeBar(QWidget* parent = nullptr);

    /// Set to false for a real server, whose time cannot be controlled: only the clock is shown.
    void setSteerable(bool steerable);
    /// Shows the state without a signal. Stepping is possible only while paused.
    void setPaused(bool paused);
    bool paused() const { return pause_->isChecked(); }
    /// Shows the nearest speed of the list without a signal; infinity is "max".
    void setSpeed(double speed);
    /// Multiple of real time; infinity for "max".
    double speed() const { return speed_->speed(); }
    /// Moves so many entries up or down the list and emits speedRequested, as if the user had done it.
    void changeSpeed(int entries);
    /// `limited`: no robot is there, so time runs at most at real time whatever speed is chosen; the bar says so.
    void setLimited(bool limited);
    bool limited() const { return limited_; }
    /// Protocol clock; nullopt while unknown.
    void setClock(std::optional<Seconds> now);
    /// Protocol seconds per second of wall time; nullopt while unknown.
    void setRealTimeFactor(std::optional<double> factor);

signals:
    /// By the user; the bar already shows the new state, and setPaused corrects it.
    void pauseRequested(bool paused);
    /// One simulator tick; only while paused.
    void stepRequested();
    /// Multiple of real time; infinity for "as fast as possible".
    void speedRequested(double speed);

private:
    /// Shows the real-time factor, or why it is not the chosen speed.
    void showFactor();

    QToolButton* pause_ = new QToolButton(this);
    QToolButton* step_ = new QToolButton(this);
    SpeedBox* speed_ = new SpeedBox(this);
    QLabel* clock_ = new QLabel(this);
    QLabel* factor_ = mutedLabel({}, this);
    std::optional<double> real_time_factor_;
    bool limited_ = false;
};

} // namespace usar::widgets
