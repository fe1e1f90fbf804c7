// Figures of the running behavior, like the left stripe of the thesis's preview (4.2), and the instruments for one
// figure that it consists of.
#pragma once

#include <limits>
#include <optional>

#include <QLabel>
#include <QWidget>

#include "core/agent/published.h"
#include "core/protocol/info/robot_state.h"
#include "widgets/models/robot_list_model.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/sheet.h"

namespace usar::widgets {

/// The figure is right-aligned before its unit. `sample` is the widest text that will be shown; its width is reserved.
class Readout : public Instrument {
    Q_OBJECT
public:
    Readout(const QString& caption, const QString& unit, const QString& sample, QWidget* parent = nullptr);

    /// Sets the formatted figure without its unit; the same text again costs nothing.
    void setText(const QString& text);
    void setCaption(const QString& caption);
    /// The figure as last set; a dash at the beginning.
    const QString& text() const { return text_; }
    /// Width of the figure alone, in pixels; readouts in a column line up if their widths are equal.
    int fieldWidth_px() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString caption_;
    QString unit_;
    QString sample_;
    QString text_;
};

/// Caption on the left, figure on the right, the bar between them. An unknown value is drawn as an empty, hatched bar
/// with a dash. Below the limits the color is that of a caution or of a danger, and a "!" precedes the figure.
/// GUI thread.
class Meter : public Instrument {
    Q_OBJECT
public:
    /// Values below these limits are bad; 0 means never.
    explicit Meter(const QString& caption, QWidget* parent = nullptr, double caution_pct = 0.0,
                   double danger_pct = 0.0);

    /// In percent, 0..100; nullopt: unknown.
    void setValue(std::optional<double> value_pct);
    /// The percentage as last set, not clamped; nullopt: unknown.
    std::optional<double> value() const { return value_pct_; }
    QSize sizeHint() const override { return {240, fontMetrics().height() + 2}; }
    QSize minimumSizeHint() const override { return {160, fontMetrics().height() + 2}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString caption_;
    std::optional<double> value_pct_;
    double painted_pct_ = std::numeric_limits<double>::quiet_NaN(); ///< 0 for an unknown value
    double caution_pct_;
    double danger_pct_;
};

/// Unknown figures are shown as a dash, never as zero. GUI thread.
class StatusStrip : public QWidget {
    Q_OBJECT
public:
    explicit StatusStrip(QWidget* parent = nullptr);

    /// Names the robot whose figures these are; empty: none.
    void setRobot(const QString& name);
    /// Shows what this robot can have: range and charges only if it recharges. Robots fly, drive or walk their way, by
    /// their kind; an unknown kind flies, because a UDK server does not tell of those that do.
    void setAbilities(protocol::VehicleKind kind, bool recharges);
    /// Shows the status of a running behavior; call it on every tick, only changes are repainted.
    void setStatus(const agent::BehaviorStatus& status);
    /// Nothing is running: `words` says why or what to do ("Idle. Press Start."). Time left and distance to the goal
    /// become unknown; the other figures stay, so that a finished mission can be read.
    void setIdle(const QString& words, StateShape shape = StateShape::Off);
    /// What is left of the battery in percent, 0..100; nullopt: unknown.
    void setBattery(std::optional<double> left_pct) { battery_->setValue(left_pct); }
    /// Covered part of the mission area in percent, 0..100; nullopt without an area.
    void setCoverage(std::optional<double> coverage_pct) { coverage_->setValue(coverage_pct); }
    /// The link is silent: figures are gray and struck through, and the word "stale" is shown, until this is reset; new
    /// figures do not reset it.
    void setStale(bool stale);
    /// True while the word "stale" is shown.
    bool stale() const { return !stale_->isHidden(); }
    /// Makes all figures unknown and shows `words`.
    void clear(const QString& words);

private:
    /// Absent: nothing is known about the end.
    void showRange(const std::optional<TimeRange>& left);
    /// Sets word and shape together, so that they always match.
    void setState(const QString& words, StateShape shape);

    StateShape shape_ = StateShape::Off; ///< the screen shows a hollow circle while stale
    StateDot* dot_ = new StateDot(this);
    QLabel* robot_ = new QLabel(this);
    QLabel* state_ = new QLabel(this);
    QLabel* stale_ = new QLabel(tr("stale"), this);
    QLabel* end_ = mutedLabel({}, this); ///< the spread of the time that is left
    Readout* elapsed_;
    Readout* left_;
    Readout* goal_;
    Readout* range_;
    Readout* flown_;
    Readout* charges_;
    Meter* battery_ = new Meter(tr("Battery"), this, battery_caution_pct, battery_danger_pct);
    Meter* progress_ = new Meter(tr("Progress"), this);
    Meter* coverage_ = new Meter(tr("Coverage"), this);
};

} // namespace usar::widgets
