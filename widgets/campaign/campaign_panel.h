// The dock for campaigns: many missions in the background, their results, and each run back on the screen.
#pragma once

#include <QLabel>
#include <QProgressBar>
#include <QTabWidget>

#include "widgets/campaign/campaign_form.h"
#include "widgets/campaign/cause_list.h"
#include "widgets/campaign/histogram_view.h"
#include "widgets/campaign/runs_view.h"
#include "widgets/campaign/verdict_view.h"
#include "widgets/models/campaign/campaign_progress.h"

namespace usar::widgets {

/// A line with the progress, and below it pages: set up, runs, histograms, why runs were not done, verdict. State comes
/// in by setters, wishes go out by the actions and signals of the parts. GUI thread.
class CampaignPanel : public QWidget {
    Q_OBJECT
public:
    /// The pages in the order of their tabs.
    enum Page { SetUp, Runs, Histograms, Why, Verdict };

    explicit CampaignPanel(QWidget* parent = nullptr);

    CampaignForm* form() const { return form_; }
    RunTable& table() { return table_; }
    RunsView* runs() const { return runs_; }
    HistogramView* histograms() const { return histograms_; }
    CauseList* causes() const { return causes_; }
    VerdictView* verdict() const { return verdict_; }

    void setProgress(const CampaignProgress& progress);
    /// Shows a sentence above the pages about what went wrong; empty: nothing did.
    void setTrouble(const QString& trouble);
    QString trouble() const { return trouble_->text(); }
    void showPage(Page page) { pages_->setCurrentIndex(page); }
    /// The button beside the progress stops the campaign that runs, and resumes one that is stopped.
    void setActions(QAction* stop, QAction* resume);
    QSize sizeHint() const override { return {420, 300}; }

private:
    RunTable table_;
    CampaignForm* form_ = new CampaignForm(this);
    RunsView* runs_ = new RunsView(table_, this);
    HistogramView* histograms_ = new HistogramView(table_, this);
    CauseList* causes_ = new CauseList(this);
    VerdictView* verdict_ = new VerdictView(this);
    QWidget* head_ = new QWidget(this);
    StateDot* dot_ = new StateDot(this);
    ElidedLabel* title_ = new ElidedLabel(this);
    ElidedLabel* figures_ = new ElidedLabel(this);
    QProgressBar* bar_ = new QProgressBar(this);
    QPushButton* stop_ = new QPushButton(tr("Stop"), this);
    QPushButton* resume_ = new QPushButton(tr("Resume"), this);
    QLabel* trouble_ = new QLabel(this);
    QTabWidget* pages_ = new QTabWidget(this);
};

} // namespace usar::widgets
