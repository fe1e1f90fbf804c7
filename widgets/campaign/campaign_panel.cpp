#include "widgets/campaign/campaign_panel.h"

#include "widgets/style/scroll_box.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

StateShape shapeOf(const CampaignProgress& progress) {
    switch (progress.state) {
    case CampaignState::Running:
        return StateShape::Busy;
    case CampaignState::Stopping:
    case CampaignState::Stopped:
        return StateShape::Waiting;
    case CampaignState::Complete:
        return StateShape::Good;
    case CampaignState::Closed:
        break;
    }
    return StateShape::Off;
}

} // namespace

CampaignPanel::CampaignPanel(QWidget* parent) : QWidget(parent) {
    title_->setAccessibleName(tr("Campaign"));
    figures_->setAccessibleName(tr("Progress of the campaign"));
    setRole(figures_, "muted");
    bar_->setTextVisible(false);
    bar_->setFixedHeight(6);
    bar_->setAccessibleName(tr("Part of the runs that have a result"));
    auto* const texts = laidOut(new QVBoxLayout, 2, {title_, figures_, bar_});
    auto* const row = laidOut(new QHBoxLayout(head_), {gap::small, gap::tiny, gap::small, 0}, gap::small, {dot_});
    row->addLayout(texts, 1);
    row->addWidget(stop_);
    row->addWidget(resume_);
    trouble_->setWordWrap(true);
    trouble_->setMargin(gap::small);
    trouble_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    trouble_->setAccessibleName(tr("Trouble with the campaign"));
    setRole(trouble_, "danger");
    pages_->setDocumentMode(true);
    pages_->addTab(form_, tr("Set up"));
    pages_->addTab(runs_, tr("Runs"));
    pages_->addTab(histograms_, tr("Histograms"));
    pages_->addTab(causes_, tr("Why not done"));
    pages_->addTab(verdict_, tr("Verdict"));
    pages_->setUsesScrollButtons(true);
    auto* const column = laidOut(new QVBoxLayout(this), {}, gap::tiny, {head_, trouble_, pages_});
    column->setStretchFactor(pages_, 1);
    setTrouble({});
    setProgress({});
}

void CampaignPanel::setProgress(const CampaignProgress& progress) {
    using enum CampaignState;
    head_->setVisible(progress.state != Closed);
    dot_->setState(shapeOf(progress));
    const QString word = stateWord(progress.state);
    title_->setText(progress.title.isEmpty() ? word : progress.title + QStringLiteral(" · ") + word);
    title_->setToolTip(title_->text());
    figures_->setText(progressText(progress));
    figures_->setToolTip(figures_->text());
    bar_->setRange(0, progress.runs > 0 || progress.state != Running ? std::max(1, progress.runs) : 0);
    bar_->setValue(progress.done);
    const bool runs = progress.state == Running || progress.state == Stopping;
    stop_->setVisible(runs);
    resume_->setVisible(progress.state == Stopped && progress.can_resume);
}

void CampaignPanel::setTrouble(const QString& trouble) {
    trouble_->setText(trouble);
    trouble_->setVisible(!trouble.isEmpty());
}

void CampaignPanel::setActions(QAction* stop, QAction* resume) {
    followAction(stop_, stop);
    followAction(resume_, resume);
}

} // namespace usar::widgets
