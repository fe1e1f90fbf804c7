#include "widgets/bars/time_bar.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

TimeBar::TimeBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Time"));
    for (QToolButton* button : {pause_, step_}) {
        button->setAutoRaise(true);
        button->setMinimumSize(minimum_target, minimum_target);
    }
    pause_->setCheckable(true);
    pause_->setObjectName(QStringLiteral("pause"));
    step_->setIcon(icon(QStringLiteral("step")));
    step_->setAccessibleName(tr("One tick"));
    step_->setToolTip(tr("One tick of the simulator, while it is paused"));
    speed_->setAccessibleName(tr("Speed of the simulator"));
    speed_->setToolTip(tr("Times real time; max is as fast as this machine can"));
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        speed_->addItem(QStringLiteral("%1×").arg(speed), speed);
    speed_->addItem(tr("max"), double(INFINITY));
    setSpeed(1.0);
    clock_->setAccessibleName(tr("Protocol clock"));
    clock_->setToolTip(tr("Protocol clock, hours:minutes:seconds since the server's own zero"));
    clock_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    clock_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    clock_->setMinimumWidth(QFontMetrics(clock_->font()).horizontalAdvance(QStringLiteral("00:00:00")) + gap::tiny);
    factor_->setAccessibleName(tr("Real-time factor"));
    factor_->setToolTip(tr("Real-time factor: protocol seconds per second of wall time"));
    factor_->setProperty("role", "muted");
    factor_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    factor_->setMinimumWidth(factor_->fontMetrics().horizontalAdvance(QStringLiteral("RTF 000.00")));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    row->setSpacing(gap::tiny);
    for (QWidget* widget : std::initializer_list<QWidget*>{pause_, step_, speed_, clock_, factor_})
        row->addWidget(widget);
    connect(pause_, &QToolButton::clicked, this, [this](bool paused) {
        setPaused(paused);
        emit pauseRequested(paused);
    });
    connect(step_, &QToolButton::clicked, this, &TimeBar::stepRequested);
    connect(speed_, &QComboBox::activated, this, [this] { emit speedRequested(speed()); });
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
    pause_->setAccessibleName(paused ? tr("Let time run") : tr("Pause time"));
    pause_->setToolTip(paused ? tr("Lets simulated time run on") : tr("Stops simulated time for all robots"));
    step_->setEnabled(paused);
}

bool TimeBar::paused() const {
    return pause_->isChecked();
}

void TimeBar::setSpeed(double speed) {
    int nearest = 0;
    for (int i = 1; i < speed_->count(); ++i) {
        const auto off = [&](int row) { return std::abs(std::log(speed_->itemData(row).toDouble() / speed)); };
        if (std::isinf(speed) ? std::isinf(speed_->itemData(i).toDouble()) : off(i) < off(nearest))
            nearest = i;
    }
    speed_->setCurrentIndex(nearest);
}

void TimeBar::changeSpeed(int entries) {
    speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + entries, 0, speed_->count() - 1));
    emit speedRequested(speed());
}

double TimeBar::speed() const {
    return speed_->currentData().toDouble();
}

void TimeBar::setClock(std::optional<Seconds> now) {
    clock_->setText(now ? clockText(*now) : QStringLiteral("--:--:--"));
}

void TimeBar::setRealTimeFactor(std::optional<double> factor) {
    factor_->setText(QStringLiteral("RTF ") + figure(factor.value_or(qQNaN()), 2, 6));
}

} // namespace usar::widgets
