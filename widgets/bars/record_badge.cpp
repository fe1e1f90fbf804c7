#include "widgets/bars/record_badge.h"

#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

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
    if (state)
        figures_->setText(
            tr("%1 %2 MB").arg(clockText(state->elapsed), figure(static_cast<double>(state->bytes) / 1e6, 1)));
    setToolTip(state ? tr("%1, written to %2").arg(figures_->text(), state->path) : QString());
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
