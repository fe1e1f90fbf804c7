#include "widgets/bars/replay_bar.h"

#include <algorithm>
#include <cmath>

#include <QAbstractItemView>
#include <QAction>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/time_slider.h"

namespace usar::widgets {

namespace {

constexpr int time_steps = 10000;

} // namespace

ReplayBar::ReplayBar(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    setAccessibleName(tr("Replay"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap::medium, gap::tiny, gap::small, gap::tiny);
    row->setSpacing(gap::tiny);
    slider_->setRange(0, time_steps);
    slider_->setAccessibleName(tr("Moment of the recording"));
    slider_->setToolTip(tr("Click or drag to another moment"));
    slider_->setMinimumHeight(minimum_target);
    time_->setAccessibleName(tr("Moment and length of the recording"));
    time_->setToolTip(tr("Since the recording began, and how long it is"));
    time_->setFont(themeFont(FontRole::Body, QFont::DemiBold));
    time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance(QStringLiteral("00:00:00 / 00:00:00")));
    speed_->setAccessibleName(tr("Speed of the replay"));
    speed_->setToolTip(tr("Times the pace of the recording; max is as fast as this machine can"));
    for (const double speed : {0.1, 0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
        speed_->addItem(QStringLiteral("%1×").arg(speed), speed);
    speed_->addItem(tr("max"), double(INFINITY));
    name_->setProperty("role", "title");
    row->addWidget(name_);
    row->addSpacing(gap::small);
    for (QToolButton* button : {back_, play_, forward_, step_, close_}) {
        button->setAutoRaise(true);
        button->setMinimumSize(minimum_target, minimum_target);
    }
    for (QWidget* widget : std::initializer_list<QWidget*>{back_, play_, forward_, step_})
        row->addWidget(widget);
    row->addWidget(slider_, 1);
    row->addWidget(time_);
    row->addWidget(speed_);
    row->addWidget(close_);
    connect(slider_, &QSlider::sliderMoved, this, [this](int value) {
        showTime(positionOf(value));
        emit seekRequested(positionOf(value));
    });
    connect(slider_, &QSlider::actionTriggered, this, [this](int action) { // Keys and wheel.
        if (action != QAbstractSlider::SliderMove)
            emit seekRequested(positionOf(slider_->sliderPosition()));
    });
    connect(speed_, &QComboBox::activated, this, [this] { emit speedRequested(speed_->currentData().toDouble()); });
    speed_->setCurrentIndex(speed_->findData(1.0));
    showTime(Seconds{0.0});
}

void ReplayBar::setActions(QAction* play, QAction* back, QAction* forward, QAction* step, QAction* close) {
    const std::initializer_list<std::pair<QToolButton*, QAction*>> pairs{
        {play_, play}, {back_, back}, {forward_, forward}, {step_, step}, {close_, close}};
    for (const auto& [button, action] : pairs) {
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
        button->setAccessibleName(action->text());
    }
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
    int nearest = 0;
    for (int i = 1; i < speed_->count(); ++i) {
        const auto off = [&](int row) { return std::abs(std::log(speed_->itemData(row).toDouble() / state.speed)); };
        if (std::isinf(state.speed) ? i == speed_->count() - 1 : off(i) < off(nearest))
            nearest = i;
    }
    if (!speed_->view()->isVisible())
        speed_->setCurrentIndex(nearest);
}

void ReplayBar::changeSpeed(int entries) {
    speed_->setCurrentIndex(std::clamp(speed_->currentIndex() + entries, 0, speed_->count() - 1));
    emit speedRequested(speed_->currentData().toDouble());
}

void ReplayBar::showTime(Seconds position) {
    time_->setText(clockText(position) + QStringLiteral(" / ") + clockText(state_.span));
}

} // namespace usar::widgets
