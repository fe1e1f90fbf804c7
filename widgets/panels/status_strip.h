// Figures of the running behavior, like the left stripe of the thesis's preview (4.2).
#pragma once

#include <QLabel>
#include <QWidget>

#include "core/agent/published.h"
#include "widgets/panels/readout.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// Unknown figures are shown as a dash, never as zero. GUI thread.
class StatusStrip : public QWidget {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// Shows the status of a running behavior; call it on every tick, only changes are repainted.
    void setStatus(const agent::BehaviorStatus& status);
    /// Nothing is running: `words` says why or what to do ("Idle. Press Start."). Time left and distance to the goal
    /// become unknown; the other figures stay, so that a finished mission can be read.
    void setIdle(const QString& words, StateShape shape = StateShape::Off);
    /// Covered part of the mission area in percent, 0..100; nullopt without an area.
    void setCoverage(std::optional<double> coverage_pct) { coverage_->setValue(coverage_pct); }
    /// The link is silent: figures are gray and struck through, and the word "stale" is shown, until this is reset; new
    /// figures do not reset it.
    void setStale(bool stale);
    bool stale() const { return !stale_->isHidden(); }
    /// Makes all figures unknown and shows `words`.
    void clear(const QString& words);
    /// The words at the top, as last set.
    QString stateText() const { return state_->text(); }

private:
    /// Sets word and shape together, so that they always match.
    void setState(const QString& words, StateShape shape);

    StateShape shape_ = StateShape::Off; ///< the screen shows a hollow circle while stale
    StateDot* dot_ = new StateDot(this);
    QLabel* state_ = new QLabel(this);
    QLabel* stale_ = new QLabel(tr("stale"), this);
    Readout* elapsed_;
    Readout* left_;
    Readout* goal_;
    Readout* range_;
    Readout* flown_;
    Readout* charges_;
    Meter* battery_ = new Meter(tr("Battery used"), this);
    Meter* progress_ = new Meter(tr("Progress"), this);
    Meter* coverage_ = new Meter(tr("Coverage"), this);
};

} // namespace usar::widgets
