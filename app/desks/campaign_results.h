// Follows the folder of a campaign in the background: its runs as they end, and the verdict.
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include "core/campaign/runs/result_tail.h"
#include "widgets/campaign/verdict_view.h"
#include "widgets/models/campaign/campaign_run.h"

namespace usar::app {

/// The manifest of a campaign says this.
struct CampaignHead {
    QString name;
    int runs = 0;
    QStringList variants;
};

/// Reads files in a pool thread, a few times a second. GUI thread.
class CampaignResults : public QObject {
    Q_OBJECT
public:
    explicit CampaignResults(QObject* parent = nullptr);

    /// Follows this folder from its first result on; what was read of another one is forgotten.
    void follow(const QString& folder);
    const QString& folder() const { return folder_; }
    /// The campaign's runs so far, in the order in which they came.
    const std::vector<campaign::RunResult>& results() const { return results_; }
    /// The result of a run; nullptr if there is none yet.
    const campaign::RunResult* result(int number) const;
    /// The runs of the same seed with the other variants, in the order of their numbers.
    std::vector<const campaign::RunResult*> partnersOf(const campaign::RunResult& run) const;
    const CampaignHead& head() const { return head_; }
    /// Compares the variants in a pool thread; `judged` follows.
    void judge();

signals:
    /// The manifest is there now.
    void begun();
    void came(const std::vector<usar::campaign::RunResult>& results);
    /// Emitted when all results that the last look found in the folder have been delivered.
    void caughtUp();
    void failed(const QString& sentence);
    /// `instead` says why there is no verdict.
    void judged(const std::vector<usar::widgets::CampaignVerdict>& verdicts, const QString& instead);

private:
    struct Look;

    /// Looks for what is new, unless the last look is still under way.
    void look();
    void take(const Look& look);

    QString folder_;
    int visit_ = 0; ///< It counts the folders, so that a late answer about an earlier one is dropped.
    bool looking_ = false;
    std::shared_ptr<campaign::ResultTail> tail_; ///< A look uses it, and there is only one look at a time.
    CampaignHead head_;
    std::vector<campaign::RunResult> results_;
    QTimer beat_;
    QThreadPool pool_; ///< Its destructor waits.
};

/// The figures that the window shows of each run, and a run with them.
std::vector<widgets::CampaignMetric> campaignMetrics();
widgets::CampaignRun rowOf(const campaign::RunResult& result);

} // namespace usar::app
