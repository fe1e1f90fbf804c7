#include "widgets/panels/status_strip.h"

#include <QGridLayout>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// One sample per column, so that the figures of a column end at the same place.
const QString time_sample = QStringLiteral("00:00:00");
const QString length_sample = QStringLiteral("0000.0");
const QString count_sample = QStringLiteral("00000");

QString orDash(const std::optional<double>& value, int decimals) {
    return figure(value.value_or(qQNaN()), decimals);
}

} // namespace

StatusStrip::StatusStrip(QWidget* parent)
    : QWidget(parent)
    , elapsed_(new Readout(tr("elapsed"), {}, time_sample, this))
    , left_(new Readout(tr("time left"), {}, time_sample, this))
    , goal_(new Readout(tr("to goal"), QStringLiteral("m"), length_sample, this))
    , range_(new Readout(tr("range left"), QStringLiteral("m"), length_sample, this))
    , flown_(new Readout(tr("flown"), QStringLiteral("m"), count_sample, this))
    , charges_(new Readout(tr("charges"), {}, count_sample, this)) {
    setAccessibleName(tr("Status"));
    elapsed_->setToolTip(tr("Protocol time since the behavior started, hours:minutes:seconds"));
    left_->setToolTip(tr("Estimated protocol time to the end"));
    goal_->setToolTip(tr("Distance to the goal that the robot is heading for, in meters"));
    range_->setToolTip(tr("How far the robot can fly before it uses its reserve, in meters"));
    flown_->setToolTip(tr("Distance flown since the behavior started, in meters"));
    charges_->setToolTip(tr("How often the battery was recharged"));
    battery_->setToolTip(tr("Used part of the battery's capacity, in percent"));
    battery_->setLimits(70.0, 85.0);
    progress_->setToolTip(tr("Part of the whole task that is done, in percent"));
    coverage_->setToolTip(tr("Part of the mission area whose height is known, in percent"));
    state_->setAccessibleName(tr("State of the behavior"));
    state_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    state_->setWordWrap(true);
    auto* head = laidOut(new QHBoxLayout, gap::small, {dot_, state_, stale_});
    head->setStretchFactor(state_, 1);
    head->setAlignment(stale_, Qt::AlignTop);
    stale_->setObjectName(QStringLiteral("stale"));
    stale_->setProperty("role", "caution");
    stale_->setToolTip(tr("The robot is silent; these are its last figures"));
    stale_->hide();
    auto* figures = new QGridLayout;
    figures->setHorizontalSpacing(gap::medium);
    figures->setVerticalSpacing(gap::tiny);
    Readout* cells[] = {elapsed_, goal_, flown_, left_, range_, charges_};
    for (int i = 0; i < 6; ++i)
        figures->addWidget(cells[i], i / 3, i % 3);
    auto* column = laidOut(new QVBoxLayout(this), {}, gap::small);
    column->addLayout(head);
    column->addLayout(figures);
    column->addLayout(laidOut(new QVBoxLayout, gap::tiny, {battery_, progress_, coverage_}));
    clear(tr("No behavior runs"));
}

void StatusStrip::setState(const QString& words, StateShape shape) {
    shape_ = shape;
    dot_->setState(stale() ? StateShape::Off : shape_);
    state_->setText(words);
}

void StatusStrip::setStatus(const agent::BehaviorStatus& status) {
    setState(QString::fromStdString(status.state), StateShape::Good);
    elapsed_->setText(clockText(status.elapsed));
    left_->setText(clockText(status.time_left.value_or(Seconds(qQNaN()))));
    goal_->setText(orDash(status.distance_to_goal_m, 1));
    range_->setText(orDash(status.range_left_m, 0));
    flown_->setText(figure(status.distance_flown_m, 0));
    charges_->setText(QString::number(status.charges));
    battery_->setValue(status.battery_used_pct);
    progress_->setValue(status.progress_pct);
}

void StatusStrip::setStale(bool stale) {
    stale_->setVisible(stale);
    dot_->setState(stale ? StateShape::Off : shape_);
    for (Readout* readout : {elapsed_, left_, goal_, range_, flown_, charges_})
        readout->setStale(stale);
    for (Meter* meter : {battery_, progress_, coverage_})
        meter->setStale(stale);
}

void StatusStrip::setIdle(const QString& words, StateShape shape) {
    setState(words, shape);
    left_->setText(figure(qQNaN(), 0));
    goal_->setText(figure(qQNaN(), 0));
}

void StatusStrip::clear(const QString& words) {
    setState(words, StateShape::Off);
    for (Readout* readout : {elapsed_, left_, goal_, range_, flown_, charges_})
        readout->setText(figure(qQNaN(), 0));
    for (Meter* meter : {battery_, progress_, coverage_})
        meter->setValue(std::nullopt);
}

} // namespace usar::widgets
