#include "widgets/bars/strips.h"

#include <algorithm>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {
namespace {

constexpr std::chrono::milliseconds moment{300};
constexpr std::chrono::seconds reading_time{30};
constexpr int parts = 1000;
constexpr int bar_width_px = 180;

} // namespace

HintStrip::HintStrip(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    setAccessibleName(tr("First steps"));
    auto* close = named(new QToolButton(this), tr("Dismiss the first steps"),
                        tr("Hide this strip; First steps in the View menu shows it again"));
    close->setObjectName(QStringLiteral("dismiss"));
    close->setIcon(icon(QStringLiteral("clear")));
    makeFlat(close);
    text_->setTextFormat(Qt::RichText);
    text_->setWordWrap(true);
    laidOut(new QHBoxLayout(this), {gap::medium, gap::tiny, gap::small, gap::tiny}, gap::small, {text_, tour_, close})
        ->setStretchFactor(text_, 1);
    tour_->setToolTip(tr("Shows the first flight in five steps; you can leave at any moment"));
    tour_->setMinimumHeight(minimum_target);
    tour_->hide();
    connect(tour_, &QPushButton::clicked, this, &HintStrip::tourRequested);
    read_->setSingleShot(true);
    read_->setInterval(reading_time);
    connect(read_, &QTimer::timeout, this, [this] { setDismissed(true); });
    connect(close, &QToolButton::clicked, this, [this] { setDismissed(true); });
    refresh();
    onThemeChange(this, [this] { refresh(); });
}

QString HintStrip::textOf(FirstStep step) {
    switch (step) {
    case FirstStep::Spawn:
        return tr("Double-click a start pose to spawn a robot");
    case FirstStep::Area:
        return tr("Draw the mission area");
    case FirstStep::Start:
        return tr("Press Start");
    }
    return {};
}

void HintStrip::setDone(FirstStep step) {
    const bool was_complete = steps_.complete();
    steps_.setDone(step);
    if (steps_.complete() && !was_complete)
        read_->start();
    refresh();
}

void HintStrip::setAreaNeeded(bool needed) {
    steps_.setAreaNeeded(needed);
    refresh();
}

void HintStrip::setWhatNext(const QString& text) {
    what_next_ = text;
    refresh();
}

void HintStrip::setInReplay(bool in_replay) {
    in_replay_ = in_replay;
    setVisible(!dismissed_ && !in_replay_);
}

void HintStrip::setDismissed(bool dismissed) {
    dismissed_ = dismissed;
    if (!dismissed && steps_.complete())
        read_->start(); // It is read once more.
    setVisible(!dismissed_ && !in_replay_);
}

void HintStrip::setTourOffered(bool offered) {
    tour_offered_ = offered;
    fitTour();
}

QSize HintStrip::minimumSizeHint() const {
    const int tour_px = tour_->isHidden() ? 0 : tour_->sizeHint().width() + gap::small;
    return QFrame::minimumSizeHint() - QSize(tour_px, 0);
}

void HintStrip::fitTour() {
    tour_->setVisible(tour_offered_ && width() >= minimumSizeHint().width() + tour_->sizeHint().width() + gap::small);
}

void HintStrip::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitTour();
}

void HintStrip::refresh() {
    const auto next = steps_.next();
    text_->setText(next ? stepsText() : what_next_.toHtmlEscaped());
    setAccessibleDescription(next ? tr("Next: %1").arg(textOf(*next)) : what_next_);
}

QString HintStrip::stepsText() const {
    const Tokens& t = tokens();
    const QString nbsp = QStringLiteral("&nbsp;"); // Keeps each step on one line.
    const auto next = steps_.next();
    QStringList parts;
    for (const FirstStep step : steps_.steps()) {
        const bool done = steps_.isDone(step);
        const QString mark = done ? QStringLiteral("✓") : QString::number(parts.size() + 1);
        const QColor ink = done ? t.ok : step == next ? t.text : t.text_muted;
        const QString text = QStringLiteral("<span style='color:%1'><b>%2</b>&nbsp;%3</span>")
                                 .arg(ink.name(), mark, textOf(step).toHtmlEscaped().replace(u' ', nbsp));
        parts << (step == next ? QStringLiteral("<b>%1</b>").arg(text) : text);
    }
    return parts.join(QStringLiteral("&nbsp; <span style='color:%1'>›</span>&nbsp; ").arg(t.text_muted.name()));
}

QuestionStrip::QuestionStrip(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    text_->setWordWrap(true);
    laidOut(new QHBoxLayout(this), {gap::medium, gap::tiny, gap::small, gap::tiny}, gap::small, {text_})
        ->setStretchFactor(text_, 1);
    second_.setInterval(std::chrono::seconds(1));
    connect(&second_, &QTimer::timeout, this, &QuestionStrip::countDown);
    hide();
}

void QuestionStrip::ask(const QString& id, const QString& question, std::vector<Answer> answers,
                        std::chrono::seconds patience) {
    id_ = id;
    answers_ = std::move(answers);
    text_->setText(question);
    setAccessibleName(question);
    for (QPushButton* const button : std::exchange(buttons_, {}))
        button->deleteLater();
    for (std::size_t i = 0; i < answers_.size(); ++i) {
        auto* const button = new QPushButton(answers_[i].text, this);
        button->setFocusPolicy(Qt::TabFocus); // A click leaves the keys to the map.
        connect(button, &QPushButton::clicked, this, [this, i] { give(i); });
        layout()->addWidget(button);
        buttons_.push_back(button);
    }
    seconds_left_ = static_cast<int>(patience.count()) + 1;
    countDown();
    second_.start();
    show();
}

void QuestionStrip::give(std::size_t answer) {
    if (answer >= answers_.size())
        return;
    const Answer given = std::move(answers_[answer]);
    answers_.clear();
    id_.clear();
    second_.stop();
    hide();
    if (given.run)
        given.run();
    if (id_.isEmpty())
        emit freed();
}

void QuestionStrip::countDown() {
    if (--seconds_left_ <= 0)
        return give(answers_.size() - 1);
    buttons_.back()->setText(tr("%1 (%2)").arg(answers_.back().text).arg(seconds_left_));
}

ProgressStrip::ProgressStrip(QWidget* parent) : QFrame(parent) {
    setProperty("role", "strip");
    setAccessibleName(tr("Progress"));
    bar_->setTextVisible(false);
    bar_->setMaximumWidth(bar_width_px);
    cancel_->setToolTip(tr("Cancels the operation; everything stays as it is"));
    auto* row =
        laidOut(new QHBoxLayout(this), {gap::medium, gap::tiny, gap::small, gap::tiny}, -1, {text_, bar_, cancel_});
    row->setStretchFactor(text_, 1);
    row->setStretchFactor(bar_, 1);
    soon_.setSingleShot(true);
    soon_.setInterval(moment);
    connect(&soon_, &QTimer::timeout, this, &QWidget::show);
    connect(cancel_, &QPushButton::clicked, this, &ProgressStrip::cancelRequested);
    hide();
}

void ProgressStrip::begin(const QString& what) {
    what_ = what;
    text_->setText(tr("%1…").arg(what));
    bar_->setRange(0, 0);
    if (!isVisible())
        soon_.start();
}

void ProgressStrip::setProgress(Seconds done, Seconds whole) {
    if (!(whole.count() > 0.0))
        return;
    const double part = std::clamp(done / whole, 0.0, 1.0);
    bar_->setRange(0, parts);
    bar_->setValue(static_cast<int>(part * parts));
    text_->setText(tr("%1: %2 of %3").arg(what_, durationText(done), durationText(whole)));
}

void ProgressStrip::end() {
    soon_.stop();
    hide();
}

} // namespace usar::widgets
