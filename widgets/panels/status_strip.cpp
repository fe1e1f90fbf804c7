#include "widgets/panels/status_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QGridLayout>
#include <QPainter>

#include "core/base/time_range.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

/// All captions get this width, so that the bars of meters below each other are aligned.
const QString widest_caption = QStringLiteral("Coverage");

/// One sample per column, so that the figures of a column end at the same place.
const QString time_sample = QStringLiteral("00:00:00");
const QString length_sample = QStringLiteral("0000.0");
const QString count_sample = QStringLiteral("00000");

QString orDash(const std::optional<double>& value, int decimals) {
    return figure(value.value_or(qQNaN()), decimals);
}

} // namespace

Readout::Readout(const QString& caption, const QString& unit, const QString& sample, QWidget* parent)
    : Instrument(parent)
    , caption_(caption)
    , unit_(unit)
    , sample_(sample) {
    setAccessibleName(caption);
    setSizePolicy(QSizePolicy::MinimumExpanding, QSizePolicy::Fixed);
    setText(QStringLiteral("–"));
}

void Readout::setText(const QString& text) {
    if (text == text_)
        return;
    text_ = text;
    describe(text + QStringLiteral(" ") + unit_);
    update();
}

void Readout::setCaption(const QString& caption) {
    if (std::exchange(caption_, caption) == caption)
        return;
    setAccessibleName(caption);
    updateGeometry();
    update();
}

int Readout::fieldWidth_px() const {
    return std::max(QFontMetrics(themeFont(FontRole::Big)).horizontalAdvance(sample_),
                    QFontMetrics(themeFont(FontRole::Small)).horizontalAdvance(caption_));
}

QSize Readout::sizeHint() const {
    const QFontMetrics big(themeFont(FontRole::Big));
    const QFontMetrics small(themeFont(FontRole::Small));
    return {fieldWidth_px() + gap::tiny + small.horizontalAdvance(unit_) + 2, big.height() + small.height()};
}

void Readout::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens();
    QPainter painter(this);
    QFont big = themeFont(FontRole::Big);
    const QFont small = themeFont(FontRole::Small);
    const QFontMetrics big_metrics(big);
    const QFontMetrics small_metrics(small);
    const int field = fieldWidth_px();
    big.setStrikeOut(stale());
    painter.setFont(big);
    painter.setPen(ink(t.text));
    painter.drawText(QRect(0, 0, field, big_metrics.height()), Qt::AlignRight | Qt::AlignVCenter, text_);
    painter.setFont(small);
    painter.setPen(t.text_muted);
    painter.drawText(QPoint(field + gap::tiny, big_metrics.ascent()), unit_);
    painter.drawText(QRect(0, big_metrics.height(), field, small_metrics.height()), Qt::AlignRight, caption_);
}

Meter::Meter(const QString& caption, QWidget* parent, double caution_pct, double danger_pct)
    : Instrument(parent)
    , caption_(caption)
    , caution_pct_(caution_pct)
    , danger_pct_(danger_pct) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(caption);
    setValue(std::nullopt);
}

void Meter::setValue(std::optional<double> value_pct) {
    constexpr double seen_pct = 0.2; // Smaller changes are not worth a repaint, five times a second.
    if (std::exchange(value_pct_, value_pct).has_value() == value_pct.has_value() &&
        std::abs(value_pct.value_or(0.0) - painted_pct_) < seen_pct)
        return;
    painted_pct_ = value_pct.value_or(0.0);
    describe(value_pct ? figure(*value_pct, 0) + QStringLiteral(" %") : tr("unknown"));
    update();
}

void Meter::paintEvent(QPaintEvent*) {
    const Tokens& t = tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF words(0, 0, width(), height());
    const double value = value_pct_.value_or(qQNaN());
    const bool low = value < caution_pct_; // Not for an unknown value, which is no number.
    const QColor ink = stale() ? t.stale : value < danger_pct_ ? t.danger : low ? t.caution : t.ok;
    painter.setPen(t.text_muted);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter, caption_);
    QFont figures = font();
    figures.setStrikeOut(stale());
    painter.setFont(figures);
    painter.setPen(stale() || low ? ink : t.text);
    // The strike-out also covers spaces, so a stale figure is not padded.
    const QString mark = low && !stale() ? QStringLiteral("! ") : QString();
    painter.drawText(words, Qt::AlignRight | Qt::AlignVCenter,
                     mark + figure(value, 0, stale() ? 0 : 3) + QStringLiteral(" %"));
    const double left = fontMetrics().horizontalAdvance(widest_caption) + gap::small;
    const double right = fontMetrics().horizontalAdvance(QStringLiteral("! 100 %")) + gap::small;
    const QRectF groove(left + 0.5, std::round(height() / 2.0) - 3.5, std::max(width() - left - right, 0.0), 7.0);
    painter.setPen(QPen(t.line, 1.0));
    painter.setBrush(value_pct_ ? QBrush(t.raised) : QBrush(t.line, Qt::BDiagPattern));
    painter.drawRoundedRect(groove, 3.0, 3.0);
    if (!value_pct_)
        return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    painter.drawRoundedRect(QRectF(groove.topLeft(), QSizeF(groove.width() * std::clamp(value / 100.0, 0.0, 1.0), 7.0)),
                            3.0, 3.0);
}

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
    charges_->setToolTip(tr("How often the battery was recharged"));
    battery_->setToolTip(tr("What is left of the battery, in percent"));
    progress_->setToolTip(tr("Part of the whole task that is done, in percent"));
    coverage_->setToolTip(tr("Part of the mission area whose height is known, in percent"));
    end_->setAccessibleName(tr("Spread of the time left"));
    end_->setToolTip(tr("About four of five missions end within this range. It is made from how much lanes, ways and "
                        "charges have differed so far."));
    robot_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    robot_->hide();
    state_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    state_->setWordWrap(true);
    state_->setAccessibleName(tr("State of the behavior"));
    auto* head = laidOut(new QHBoxLayout, gap::small, {dot_, robot_, state_, stale_});
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
    column->addWidget(end_);
    column->addLayout(laidOut(new QVBoxLayout, gap::tiny, {battery_, progress_, coverage_}));
    setAbilities(protocol::VehicleKind::Unknown, true);
    clear(tr("No behavior runs"));
}

void StatusStrip::setRobot(const QString& name) {
    robot_->setText(name);
    robot_->setHidden(name.isEmpty());
    setAccessibleName(name.isEmpty() ? tr("Status") : tr("Status of %1").arg(name));
}

void StatusStrip::setAbilities(protocol::VehicleKind kind, bool recharges) {
    using enum protocol::VehicleKind;
    const QString way = kind == Aerial || kind == Unknown ? tr("flown")
                        : kind == Ground                  ? tr("driven")
                        : kind == Legged                  ? tr("walked")
                                                          : tr("traveled");
    range_->setVisible(recharges);
    charges_->setVisible(recharges);
    flown_->setCaption(way);
    flown_->setToolTip(tr("Distance %1 since the behavior started, in meters").arg(way));
}

void StatusStrip::setState(const QString& words, StateShape shape) {
    shape_ = shape;
    dot_->setState(stale() ? StateShape::Off : shape_);
    state_->setText(words);
    setAccessibleDescription(words);
}

void StatusStrip::setStatus(const agent::BehaviorStatus& status) {
    setState(QString::fromStdString(status.state), StateShape::Good);
    elapsed_->setText(clockText(status.elapsed));
    left_->setText(clockText(status.time_left.value_or(Seconds(qQNaN()))));
    showRange(status.time_left_range);
    goal_->setText(orDash(status.distance_to_goal_m, 1));
    range_->setText(orDash(status.range_left_m, 0));
    flown_->setText(figure(status.distance_flown_m, 0));
    charges_->setText(QString::number(status.charges));
    progress_->setValue(status.progress_pct);
}

void StatusStrip::showRange(const std::optional<TimeRange>& left) {
    const auto text = [](Seconds span) { return QString::fromStdString(countdownText(span)); };
    // A blank keeps the height of the line, so that nothing moves when a behavior begins.
    end_->setText(left ? tr("Ends in %1 to %2").arg(text(left->least), text(left->most)) : QStringLiteral(" "));
}

void StatusStrip::setStale(bool stale) {
    stale_->setVisible(stale);
    dot_->setState(stale ? StateShape::Off : shape_);
    for (Readout* readout : {elapsed_, left_, goal_, range_, flown_, charges_})
        readout->setStale(stale);
    QFont font = end_->font();
    font.setStrikeOut(stale);
    end_->setFont(font);
    for (Meter* meter : {battery_, progress_, coverage_})
        meter->setStale(stale);
}

void StatusStrip::setIdle(const QString& words, StateShape shape) {
    setState(words, shape);
    left_->setText(figure(qQNaN(), 0));
    showRange({});
    goal_->setText(figure(qQNaN(), 0));
}

void StatusStrip::clear(const QString& words) {
    setState(words, StateShape::Off);
    showRange({});
    for (Readout* readout : {elapsed_, left_, goal_, range_, flown_, charges_})
        readout->setText(figure(qQNaN(), 0));
    for (Meter* meter : {battery_, progress_, coverage_})
        meter->setValue(std::nullopt);
}

} // namespace usar::widgets
