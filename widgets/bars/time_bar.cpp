#include "widgets/bars/time_bar.h"

#include <algorithm>

#include <QFontMetrics>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr const char* unknown_clock = "--:--:--";

} // namespace

TimeBar::TimeBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time"));
    makeFlat(pause_);
    makeFlat(step_);
    pause_->setCheckable(true);
    pause_->setObjectName(QStringLiteral("pause"));
    step_->setIcon(icon(QStringLiteral("step")));
    named(step_, tr("One tick"), tr("Advances the paused simulator by one tick"));
    named(speed_, tr("Speed of the simulator"),
          tr("Speed as a multiple of real time; max is as fast as this machine can go"));
    named(clock_, tr("Protocol clock"), tr("Protocol clock, hours:minutes:seconds since the server's own zero"));
    clock_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    clock_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QFontMetrics metrics(clock_->font());
    clock_->setMinimumWidth(std::max(metrics.horizontalAdvance(QStringLiteral("00:00:00")),
                                     metrics.horizontalAdvance(QString::fromUtf8(unknown_clock))) +
                            gap::tiny);
    factor_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    factor_->setMinimumWidth(factor_->fontMetrics().horizontalAdvance(QStringLiteral("RTF 000.00")));
    laidOut(new QHBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::tiny}, gap::tiny,
            {pause_, step_, speed_, clock_, factor_});
    connect(pause_, &QToolButton::clicked, this, [this](bool paused) {
        setPaused(paused);
        emit pauseRequested(paused);
    });
    connect(step_, &QToolButton::clicked, this, &TimeBar::stepRequested);
    connect(speed_, &QComboBox::activated, this, [this] {
        showFactor();
        emit speedRequested(speed());
    });
    setPaused(false);
    setClock(std::nullopt);
    setRealTimeFactor(std::nullopt);
}

void TimeBar::setSteerable(bool steerable) {
    for (QWidget* widget : std::initializer_list<QWidget*>{pause_, step_, speed_, factor_})
        widget->setVisible(steerable);
}

void TimeBar::setPaused(bool paused) {
    pause_->setChecked(paused);
    pause_->setIcon(icon(paused ? QStringLiteral("play") : QStringLiteral("pause")));
    named(pause_, paused ? tr("Let time run") : tr("Pause time"),
          paused ? tr("Lets simulated time run on") : tr("Stops simulated time for all robots"));
    step_->setEnabled(paused);
}

void TimeBar::setSpeed(double speed) {
    speed_->setSpeed(speed);
    showFactor();
}

void TimeBar::changeSpeed(int entries) {
    speed_->step(entries);
    showFactor();
    emit speedRequested(speed());
}

void TimeBar::setClock(std::optional<Seconds> now) {
    clock_->setText(now ? clockText(*now) : QString::fromUtf8(unknown_clock));
}

void TimeBar::setRealTimeFactor(std::optional<double> factor) {
    real_time_factor_ = factor;
    showFactor();
}

void TimeBar::setLimited(bool limited) {
    limited_ = limited;
    showFactor();
}

void TimeBar::showFactor() {
    if (limited_ && speed() > 1.0) {
        named(factor_, tr("Real-time factor"),
              tr("No robot is there, so time runs at 1×. The chosen speed holds as soon as there is one."));
        return factor_->setText(tr("1×: no robot"));
    }
    named(factor_, tr("Real-time factor"), tr("Real-time factor: protocol seconds per second of wall time"));
    factor_->setText(QStringLiteral("RTF ") + figure(real_time_factor_.value_or(qQNaN()), 2, 6));
}

} // namespace usar::widgets
