#include "widgets/plan/plan_time_bar.h"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QSignalBlocker>

#include "widgets/models/figures.h"
#include "widgets/plan/plan_parts.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/time_controls.h"
#include "widgets/style/tips.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {

namespace {

constexpr int broad_bar_px = 620;
constexpr int narrow_px = 560;
constexpr int halt_icon_px = 18;

} // namespace

QString planTimeText(const PlanTime& time) {
    if (time.cycle == 0)
        return {};
    const QString end = figure((time.end - time.begin).count(), 1);
    if (time.live && !time.replay)
        return QObject::tr("live, %1 s").arg(end);
    const QString at = QObject::tr("at %1 s of %2 s").arg(figure((time.shown - time.begin).count(), 1), end);
    return time.epoch == 0 ? at : QObject::tr("%1, decision %2 of %3").arg(at).arg(time.epoch).arg(time.epochs);
}

PlanTimeBar::PlanTimeBar(QWidget* parent)
    : QWidget(parent)
    , halt_(makeToolButton(tr("Halt or continue"), this))
    , back_(makeToolButton(tr("One cycle back"), this))
    , forward_(makeToolButton(tr("One cycle forward"), this))
    , look_back_(makeToolButton(tr("Replay from here"), this))
    , live_(makeToolButton(tr("Back to now"), this))
    , slider_(new TimeSlider(this))
    , words_(new QLabel(this)) {
    setAccessibleName(tr("Moment of the run"));
    slider_->setRange(0, run_steps);
    slider_->setPageStep(run_steps / 20);
    slider_->setAccessibleName(tr("Moment of the plan's run"));
    slider_->setMinimumHeight(minimum_target);
    named(words_, tr("Shown moment of the run"), tr("Time since the start of the plan, by the robot's clock"));
    words_->setMinimumWidth(words_->fontMetrics().horizontalAdvance(QStringLiteral("at 0000.0 s of 0000.0 s")));
    laidOut(new QHBoxLayout(this), {}, gap::tiny, {halt_, back_, forward_, slider_, words_, look_back_, live_})
        ->setStretchFactor(slider_, 1);
    connect(slider_, &QSlider::sliderMoved, this, [this](int value) { emit timeWanted(timeOf(value)); });
    connect(slider_, &QSlider::actionTriggered, this, [this](int action) { // Keys and wheel.
        if (action == QAbstractSlider::SliderMove || time_.cycle == 0)
            return;
        const QToolButton* const button = action == QAbstractSlider::SliderSingleStepAdd   ? forward_
                                          : action == QAbstractSlider::SliderSingleStepSub ? back_
                                                                                           : nullptr;
        if (!button)
            emit timeWanted(timeOf(slider_->sliderPosition()));
        // In a short run a step of the slider is less than a cycle, so it triggers the button instead.
        else if (button->defaultAction())
            button->defaultAction()->trigger();
    });
    setTime({});
}

void PlanTimeBar::setActions(QAction* halt, QAction* back, QAction* forward, QAction* look_back, QAction* live) {
    const std::initializer_list<std::pair<QToolButton*, QAction*>> pairs{
        {halt_, halt}, {back_, back}, {forward_, forward}, {look_back_, look_back}, {live_, live}};
    for (const auto& [button, action] : pairs) {
        showAction(button, action);
        button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    }
    arrange();
}

/// The buttons that apply now (in the past, or in a replay that can be left) are labeled if there is room for text.
void PlanTimeBar::arrange() {
    const bool is_past = !time_.live && !time_.replay && time_.cycle != 0;
    const bool is_broad = width() >= broad_bar_px;
    const auto styleOf = [is_broad](bool is_offered) {
        return is_offered && is_broad ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
    };
    look_back_->setToolButtonStyle(styleOf(is_past));
    live_->setToolButtonStyle(styleOf(time_.replay && live_->isEnabled()));
}

void PlanTimeBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void PlanTimeBar::setTime(const PlanTime& time) {
    time_ = time;
    // A focused slider stays enabled; otherwise its keys would go to a neighbor in the meantime.
    slider_->setEnabled(time.cycle != 0 || slider_->hasFocus());
    arrange();
    setRole(words_, time.live ? "ok" : "caution");
    words_->setText(planTimeText(time));
    tellRange(slider_, tr("Click or drag to see what the plan did at another moment"), durationText(time.begin),
              durationText(time.end));
    if (slider_->isSliderDown())
        return;
    const double span_s = (time.end - time.begin).count();
    const double part = span_s > 0.0 ? (time.shown - time.begin).count() / span_s : 1.0;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(std::clamp(part, 0.0, 1.0) * run_steps)));
}

PlanHaltBar::PlanHaltBar(QWidget* parent)
    : QFrame(parent)
    , column_(new QBoxLayout(QBoxLayout::LeftToRight, this))
    , text_(makeLabel(this, "title"))
    , buttons_(new QBoxLayout(QBoxLayout::LeftToRight)) {
    setProperty("role", "card");
    setAccessibleName(tr("The plan is halted"));
    auto* const symbol = new QLabel(this);
    auto* const words = laidOut(new QHBoxLayout, gap::small, {symbol, text_});
    words->setAlignment(symbol, Qt::AlignTop);
    words->setStretchFactor(text_, 1);
    laidOut(column_, {gap::small, gap::tiny, gap::small, gap::tiny}, gap::small)->addLayout(words, 1);
    column_->addLayout(laidOut(buttons_, gap::tiny));
    const auto showSymbol = [symbol] {
        symbol->setPixmap(icon(QStringLiteral("pause"), tokens().caution).pixmap(halt_icon_px, halt_icon_px));
    };
    showSymbol();
    onThemeChange(this, showSymbol);
    hide();
}

void PlanHaltBar::setActions(const QList<QAction*>& actions) {
    for (QAction* action : actions) {
        QToolButton* const button = makeToolButton(action->text(), this);
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setAutoRaise(false);
        buttons_->addWidget(button);
    }
}

void PlanHaltBar::setText(const QString& text) {
    text_->setText(text);
    setAccessibleDescription(text);
    setVisible(!text.isEmpty());
}

void PlanHaltBar::resizeEvent(QResizeEvent* event) {
    column_->setDirection(width() < narrow_px ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    QFrame::resizeEvent(event);
}

} // namespace usar::widgets
