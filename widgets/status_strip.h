// The figures of the running behavior, as in the left stripe of the thesis's preview (4.2).
#pragma once

#include <QLabel>
#include <QWidget>

#include "core/agent/published.h"
#include "widgets/meter.h"
#include "widgets/readout.h"
#include "widgets/state_dot.h"

namespace usar::widgets {

/// Figures that the behavior does not know are a dash, never a zero. GUI thread.
class StatusStrip : public QWidget {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// A behavior runs; called on every tick, repaints only what changed.
    void setStatus(const agent::BehaviorStatus& status);
    /// Nothing runs: `words` says why or what to do ("Idle. Press Start."); the last figures stay, so that a finished
    /// mission can be read.
    void setIdle(const QString& words, StateShape shape = StateShape::Off);
    /// Of the mission area, 0..100; nothing without an area.
    void setCoverage(std::optional<double> coverage_pct);
    /// The link is silent: figures grey and struck, and the word "stale"; new figures do not lift it.
    void setStale(bool stale);
    bool stale() const { return !stale_->isHidden(); }
    /// All figures unknown.
    void clear(const QString& words);
    /// The words at the top, as they were set.
    QString stateText() const { return state_->text(); }

private:
    /// Word and shape together, so that neither can lag behind.
    void setState(const QString& words, StateShape shape);

    StateShape shape_ = StateShape::Off; ///< hollow on the screen while stale
    StateDot* dot_;
    QLabel* state_;
    QLabel* stale_;
    Readout* elapsed_;
    Readout* left_;
    Readout* goal_;
    Readout* range_;
    Readout* flown_;
    Readout* charges_;
    Meter* battery_;
    Meter* progress_;
    Meter* coverage_;
};

} // namespace usar::widgets
