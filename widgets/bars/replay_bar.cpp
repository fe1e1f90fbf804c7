#include "widgets/bars/replay_bar.h"

#include <cmath>

#include <QAbstractItemView>
#include <QAction>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {
namespace {

constexpr int time_steps = 10000;

} // namespace

ReplayBar::ReplayBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    setAccessibleName(tr("Replay"));
    slider_->setRange(0, time_steps);
    slider_->setAccessibleName(tr("Moment of the recording"));
    slider_->setMinimumHeight(minimum_target);
    named(time_, tr("Moment and length of the recording"),
          tr("Time since the recording began, and the length of the recording"));
    time_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(QStringLiteral("00:00:00 / 00:00:00")));
    named(speed_, tr("Speed of the replay"),
          tr("Speed as a multiple of the recording's pace; max is as fast as this machine can go"));
    name_->setProperty("role", "title");
    for (QToolButton* button : {back_, play_, forward_, step_, close_})
        makeFlat(button);
    auto* row = laidOut(new QHBoxLayout(this), {gap::medium, gap::tiny, gap::small, gap::tiny}, gap::tiny,
                        {name_, back_, play_, forward_, step_, slider_, time_, speed_, close_});
    row->insertSpacing(1, gap::small);
    row->setStretchFactor(slider_, 1);
    connect(slider_, &QSlider::sliderMoved, this, [this](int value) {
        showTime(positionOf(value));
        emit seekRequested(positionOf(value));
    });
    connect(slider_, &QSlider::actionTriggered, this, [this](int action) { // Keys and wheel.
        if (action != QAbstractSlider::SliderMove)
            emit seekRequested(positionOf(slider_->sliderPosition()));
    });
    connect(speed_, &QComboBox::activated, this, [this] { emit speedRequested(speed_->speed()); });
    showTime(Seconds{0.0});
}

void ReplayBar::setActions(QAction* play, QAction* back, QAction* forward, QAction* step, QAction* close) {
    const std::initializer_list<std::pair<QToolButton*, QAction*>> pairs{
        {play_, play}, {back_, back}, {forward_, forward}, {step_, step}, {close_, close}};
    for (const auto& [button, action] : pairs)
        showAction(button, action);
}

Seconds ReplayBar::positionOf(int value) const {
    return state_.span * (static_cast<double>(value) / time_steps);
}

void ReplayBar::setState(const ReplayState& state) {
    if (QAction* play = play_->defaultAction(); play && (state.playing != state_.playing || play->icon().isNull()))
        play->setIcon(icon(state.playing ? QStringLiteral("pause") : QStringLiteral("play")));
    state_ = state;
    if (!slider_->isSliderDown()) {
        const double part = state.span.count() > 0.0 ? state.position / state.span : 0.0;
        const QSignalBlocker quiet(slider_);
        slider_->setValue(static_cast<int>(std::lround(part * time_steps)));
        showTime(state.position);
    }
    if (!speed_->view()->isVisible())
        speed_->setSpeed(state.speed);
}

void ReplayBar::changeSpeed(int entries) {
    speed_->step(entries);
    emit speedRequested(speed_->speed());
}

void ReplayBar::showTime(Seconds position) {
    time_->setText(clockText(position) + QStringLiteral(" / ") + clockText(state_.span));
    tellRange(slider_, tr("Click or drag to go to another moment, in hours, minutes and seconds"),
              clockText(Seconds{0.0}), clockText(state_.span));
}

RecordBadge::RecordBadge(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Recording"));
    makeFlat(button_);
    figures_->setMinimumWidth(figures_->fontMetrics().horizontalAdvance(QStringLiteral("00:00:00 0000.0 MB")));
    laidOut(new QHBoxLayout(this), {gap::tiny, gap::tiny, gap::tiny, gap::tiny}, gap::tiny, {button_, figures_});
    setState(std::nullopt);
    onThemeChange(this, [this] { refresh(); });
}

void RecordBadge::setAction(QAction* action) {
    showAction(button_, action);
    connect(action, &QAction::toggled, this, [this] { refresh(); });
    refresh();
}

void RecordBadge::setState(const std::optional<RecordState>& state) {
    const auto megabytes = [](std::uint64_t bytes, int digits) {
        return figure(static_cast<double>(bytes) / 1e6, digits);
    };
    if (state)
        figures_->setText(tr("%1 %2 MB").arg(clockText(state->elapsed), megabytes(state->bytes, 1)));
    QString tip = state ? tr("%1, written to %2").arg(figures_->text(), state->path) : QString();
    if (state && state->limit_bytes)
        tip +=
            tr("\nIt has at most %1 MB; its oldest parts are deleted for that.").arg(megabytes(*state->limit_bytes, 0));
    setToolTip(tip);
    if (writing_ == state.has_value() && !(figures_->text().isEmpty()))
        return;
    writing_ = state.has_value();
    refresh();
}

void RecordBadge::refresh() {
    QAction* action = button_->defaultAction();
    if (!writing_)
        figures_->setText(action && action->isChecked() ? tr("REC ready") : tr("not recorded"));
    if (action)
        action->setIcon(writing_ ? icon(QStringLiteral("record"), tokens().danger) : icon(QStringLiteral("record")));
}

} // namespace usar::widgets
