// Truth about time: the protocol clock, and for a simulator pause, step, speed and how real it is.
#pragma once

#include <optional>

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"

namespace usar::widgets {

/// Requests out, figures in; it counts no time itself. "As fast as it can" is a speed of infinity. GUI thread.
class TimeBar : public QWidget {
    Q_OBJECT
public:
    explicit TimeBar(QWidget* parent = nullptr);

    /// A real server's time cannot be steered: only the clock is shown.
    void setSteerable(bool steerable);
    /// Shows the state; no signal. A step is possible only while paused.
    void setPaused(bool paused);
    bool paused() const;
    /// The nearest speed on the list is shown; no signal.
    void setSpeed(double speed);
    /// Times real time; infinity for "max".
    double speed() const;
    /// So many entries up or down the list, as the person would: the wish is emitted.
    void changeSpeed(int entries);
    /// Protocol clock; nothing while unknown.
    void setClock(std::optional<Seconds> now);
    /// Protocol seconds per second of wall time.
    void setRealTimeFactor(std::optional<double> factor);

signals:
    /// By the person; the bar already shows it, setPaused corrects it.
    void pauseRequested(bool paused);
    /// One tick, only while paused.
    void stepRequested();
    /// Times real time; infinity for "as fast as it can".
    void speedRequested(double speed);

private:
    QToolButton* pause_;
    QToolButton* step_;
    QComboBox* speed_;
    QLabel* clock_;
    QLabel* factor_;
};

} // namespace usar::widgets
