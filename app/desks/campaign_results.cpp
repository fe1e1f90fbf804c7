#include "app/desks/campaign_results.h"

#include <algorithm>
#include <chrono>

#include "core/base/hand_over.h"
#include "core/campaign/comparison/campaign_figures.h"
#include "core/campaign/comparison/comparison.h"
#include "core/campaign/comparison/report.h"
#include "core/campaign/comparison/verdict_words.h"
#include "core/campaign/plan/manifest_head.h"
#include "core/link/across_threads.h"

namespace usar::app {

namespace {

constexpr std::size_t most_at_once = 2000; ///< The GUI thread takes so many rows in a few milliseconds.

/// These of the compared metrics tell the most about one run.
constexpr const char* shown_metrics[] = {"duration_s", "coverage_pct", "rmse_m", "distance_m", "collisions"};

struct Judgement {
    std::vector<widgets::CampaignVerdict> verdicts;
    QString instead;
};

Judgement without(const Error& error) {
    return {{}, QString::fromStdString(error.text())};
}

/// A headline gets its period where it is shown.
QString withoutPeriod(const QString& sentence) {
    return sentence.endsWith('.') ? sentence.chopped(1) : sentence;
}

widgets::CampaignVerdict verdictOf(const campaign::Comparison& comparison) {
    widgets::CampaignVerdict verdict{campaign::headline(comparison), {}, {}};
    for (const campaign::VerdictLine& line : campaign::verdictLines(comparison))
        verdict.words.push_back({line.title, line.word, line.detail});
    for (const QString& sentence : campaign::omissions(comparison))
        verdict.notes << sentence;
    return verdict;
}

Judgement judgeFolder(const QString& folder) {
    const auto figures = campaign::readCampaigns({folder});
    if (!figures)
        return without(figures.error());
    if (figures->variants.size() < 2)
        return {{},
                CampaignResults::tr("The campaign has only one variant; there is nothing to compare it with. The "
                                    "report shows its figures.")};
    const std::string& baseline = figures->variants.front();
    const std::vector<campaign::Candidate> candidates = campaign::candidatesFor(baseline, *figures);
    std::vector<std::string> comparable; // All are compared together, as in the report.
    for (const campaign::Candidate& one : candidates)
        if (!one.trouble)
            comparable.push_back(one.variant);
    const auto comparisons = campaign::compareAll(figures->runs, baseline, comparable);
    if (!comparisons)
        return without(comparisons.error());
    Judgement judgement;
    auto next = comparisons->begin();
    for (const campaign::Candidate& one : candidates) {
        if (!one.trouble) {
            judgement.verdicts.push_back(verdictOf(*next++));
            continue;
        }
        judgement.instead = QString::fromStdString(one.trouble->text());
        if (candidates.size() > 1) // The other candidates' verdicts would hide it.
            judgement.verdicts.push_back({withoutPeriod(judgement.instead), {}, {}});
    }
    return judgement;
}

} // namespace

/// One look into the folder has found this.
struct CampaignResults::Look {
    int visit = 0;
    std::optional<CampaignHead> head;
    Result<std::vector<campaign::RunResult>> results;
};

CampaignResults::CampaignResults(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
    beat_.setInterval(std::chrono::milliseconds(200));
    connect(&beat_, &QTimer::timeout, this, &CampaignResults::look);
}

void CampaignResults::follow(const QString& folder) {
    folder_ = folder;
    ++visit_;
    looking_ = false;
    tail_ = std::make_shared<campaign::ResultTail>(folder);
    head_ = {};
    results_.clear();
    beat_.start();
    look();
}

const campaign::RunResult* CampaignResults::result(int number) const {
    const auto found = std::ranges::find(results_, number, &campaign::RunResult::number);
    return found == results_.end() ? nullptr : &*found;
}

std::vector<const campaign::RunResult*> CampaignResults::partnersOf(const campaign::RunResult& run) const {
    std::vector<const campaign::RunResult*> partners;
    for (const campaign::RunResult& other : results_)
        if (other.pair == run.pair && other.number != run.number)
            partners.push_back(&other);
    std::ranges::sort(partners, {}, &campaign::RunResult::number);
    return partners;
}

void CampaignResults::look() {
    if (std::exchange(looking_, true))
        return;
    pool_.start(HandedOver([this, visit = visit_, folder = folder_, tail = tail_, knows_head = head_.runs > 0] {
        Look look{visit, std::nullopt, tail->take(most_at_once)};
        if (const auto head = knows_head ? Result<QJsonObject>() : campaign::readManifestHead(folder);
            head && !head->isEmpty())
            look.head = CampaignHead{(*head)["campaign"].toString(), (*head)["runs"].toInt(),
                                     (*head)["variants"].toVariant().toStringList()};
        link::post(this, [this, look] { take(look); });
    }));
}

void CampaignResults::take(const Look& look) {
    if (look.visit != visit_)
        return;
    looking_ = false;
    if (look.head) {
        head_ = *look.head;
        emit begun();
    }
    if (!look.results) {
        beat_.stop();
        emit failed(QString::fromStdString(look.results.error().text()));
        return;
    }
    results_.insert(results_.end(), look.results->begin(), look.results->end());
    if (!look.results->empty())
        emit came(*look.results);
    if (look.results->size() < most_at_once)
        emit caughtUp();
}

void CampaignResults::judge() {
    pool_.start(HandedOver([this, visit = visit_, folder = folder_] {
        link::post(this, [this, visit, judgement = judgeFolder(folder)] {
            if (visit == visit_)
                emit judged(judgement.verdicts, judgement.instead);
        });
    }));
}

std::vector<widgets::CampaignMetric> campaignMetrics() {
    const std::vector<campaign::Metric> known = campaign::usualMetrics();
    std::vector<widgets::CampaignMetric> metrics;
    for (const char* const key : shown_metrics) {
        const auto metric = std::ranges::find(known, key, &campaign::Metric::key);
        const bool is_count = metric->unit.empty();
        metrics.push_back({QString::fromStdString(metric->title), QString::fromStdString(metric->unit),
                           is_count ? 0 : metric->decimals});
    }
    return metrics;
}

widgets::CampaignRun rowOf(const campaign::RunResult& result) {
    widgets::CampaignRun run{.number = result.number,
                             .pair = result.pair,
                             .mission = QString::fromStdString(result.mission),
                             .variant = QString::fromStdString(result.variant),
                             .seed = result.seed,
                             .outcome = campaign::wordOf(result.outcome),
                             .done = result.outcome == campaign::Outcome::Done,
                             .reason = QString::fromStdString(result.reason)};
    const campaign::RunFigures figures = campaign::figuresOf(result);
    for (const char* const key : shown_metrics) {
        const auto found = figures.metrics.find(key);
        run.figures.push_back(found == figures.metrics.end() ? std::nullopt : found->second);
    }
    run.differs = result.differences && !result.differences->isEmpty();
    return run;
}

} // namespace usar::app
