#include "widgets/bars/progress_strip.h"

#include <algorithm>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr std::chrono::milliseconds moment{300};
constexpr int parts = 1000;
constexpr int bar_width_px = 180;

} // namespace

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
