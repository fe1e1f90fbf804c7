#include "core/campaign/comparison/comparison.h"

#include <algorithm>
#include <iterator>

#include "core/campaign/runs/parallel.h"
#include "core/campaign/statistics/holm.h"
#include "core/campaign/statistics/more_pairs.h"
#include "core/campaign/statistics/paired.h"
#include "core/campaign/statistics/wilcoxon.h"

namespace usar::campaign {

namespace {

/// The same interval seen as gains: turned around where less is better.
Interval gainOf(const Interval& difference, bool lower_is_better) {
    return lower_is_better ? Interval{-difference.high, -difference.low} : difference;
}

std::size_t unfinishedOf(const Pairing& pairing, const RunFigures* RunPair::*side) {
    return static_cast<std::size_t>(std::count_if(pairing.pairs.begin(), pairing.pairs.end(), [side](const RunPair& p) {
        return (p.*side)->outcome != Outcome::Done;
    }));
}

SuccessComparison compareSuccess(const Pairing& pairing, double confidence) {
    SuccessComparison result;
    for (const RunPair& pair : pairing.pairs) {
        const bool before = pair.baseline->outcome == Outcome::Done;
        const bool after = pair.candidate->outcome == Outcome::Done;
        ++(before  ? after ? result.count.both : result.count.baseline_only
           : after ? result.count.candidate_only
                   : result.count.neither);
        if (before != after)
            result.differing.push_back(pair);
    }
    result.baseline = wilsonInterval(result.count.baseline(), confidence);
    result.candidate = wilsonInterval(result.count.candidate(), confidence);
    result.difference = rateDifference(result.count, confidence);
    result.p = mcNemar(result.count);
    return result;
}

MetricComparison compareMetric(const Metric& metric, const Pairing& pairing, const ComparisonOptions& options) {
    MetricComparison result;
    result.metric = metric;
    result.values = valuesOf(pairing, metric);
    const std::vector<double>&baseline = result.values.baseline, &candidate = result.values.candidate;
    result.baseline_unfinished = unfinishedOf(pairing, &RunPair::baseline);
    result.candidate_unfinished = unfinishedOf(pairing, &RunPair::candidate);
    if (const auto& limits = result.values.limits) {
        result.baseline_restricted = restrictedMean(baseline, limits->high);
        result.candidate_restricted = restrictedMean(candidate, limits->high);
    }
    result.baseline_median = median(baseline);
    result.candidate_median = median(candidate);
    result.margin = marginOf(metric, result.baseline_median);
    const std::vector<double> change = differences(baseline, candidate);
    result.sorted_differences = sortedCopy(change);
    result.median_difference = quantileOfSorted(result.sorted_differences, 0.5);
    result.difference = trimmedMean(change, metric.trimmed_share);
    result.interval = bcaInterval(change, result.values.missions, metric.trimmed_share,
                                  {1.0 - options.alpha, options.resamples, options.seed});
    result.p = wilcoxon(change).p;
    result.correlation = correlation(baseline, candidate);
    result.variance_ratio = varianceRatio(baseline, candidate);
    result.ratio = geometricMeanOfRatios(baseline, candidate);
    result.improved = probabilityOfImprovement(baseline, candidate, metric.lower_is_better);
    return result;
}

/// Adjusts the p-values of all questions together, and returns how many there are.
std::size_t adjust(std::vector<Comparison>& comparisons) {
    std::vector<double> p_values;
    for (const Comparison& comparison : comparisons) {
        p_values.push_back(comparison.success.p);
        for (const MetricComparison& metric : comparison.metrics)
            p_values.push_back(metric.p);
    }
    const std::vector<double> adjusted = holm(p_values);
    auto next = adjusted.begin();
    for (Comparison& comparison : comparisons) {
        comparison.success.holm_p = *next++;
        for (MetricComparison& metric : comparison.metrics)
            metric.holm_p = *next++;
    }
    return p_values.size();
}

/// A p below this would still be below alpha when it is adjusted as that of the question was. An adjusted p is cut at 1
/// and no longer tells the factor; then it is the largest there is.
template <class Question>
double neededP(const Question& question, double alpha, std::size_t questions) {
    return question.holm_p < 1.0 && question.p > 0.0 ? alpha * question.p / question.holm_p
                                                     : alpha / static_cast<double>(questions);
}

/// Not each pair has each figure, and a seed has a pair in each mission and world.
std::optional<std::size_t> seedsFor(const std::optional<std::size_t>& more_pairs, std::size_t measured_pairs,
                                    std::size_t seeds) {
    if (!more_pairs || measured_pairs == 0)
        return std::nullopt;
    return (*more_pairs * seeds + measured_pairs - 1) / measured_pairs;
}

/// The word on a figure depends on these, besides the figure's own pairs.
struct Frame {
    const ComparisonOptions& options;
    std::size_t seeds = 0;     ///< that have a pair
    std::size_t questions = 0; ///< whose p-values were adjusted together
};

/// Gives the verdict on one question; `Question` is a success or a metric comparison, with its p-values adjusted.
/// `more` tells how many more pairs would decide, given the p that is needed.
template <class Question, class More>
void judge(Question& question, const MeasuredDifference& measured, bool lower_is_better, double margin,
           const Frame& frame, More more) {
    const ComparisonOptions& options = frame.options;
    const Evidence evidence{gainOf(measured.interval, lower_is_better), margin, measured.pairs >= options.least_pairs,
                            question.holm_p < options.alpha};
    question.verdict = verdictOn(evidence);
    question.not_worse = isNotWorse(evidence);
    if (question.verdict != Verdict::Undecided) {
        question.more_seeds = 0;
        return;
    }
    std::optional<std::size_t> more_pairs = more(neededP(question, options.alpha, frame.questions));
    if (more_pairs && measured.pairs + *more_pairs < options.least_pairs)
        more_pairs = options.least_pairs - measured.pairs;
    question.more_seeds = seedsFor(more_pairs, measured.pairs, frame.seeds);
}

void judgeAll(Comparison& comparison, std::size_t questions) {
    const ComparisonOptions& options = comparison.options;
    const Frame frame{options, seedsOf(comparison.pairing), questions};
    SuccessComparison& success = comparison.success;
    const double rate_difference = success.count.candidate().rate() - success.count.baseline().rate();
    judge(success, {.pairs = success.count.pairs(), .estimate = rate_difference, .interval = success.difference}, false,
          options.success_margin, frame, [&](double needed_p) {
              return morePairsToDecide(success.count, options.success_margin, 1.0 - options.alpha, needed_p);
          });
    for (MetricComparison& metric : comparison.metrics) {
        MeasuredDifference measured{
            .pairs = metric.pairs(), .estimate = metric.difference, .interval = metric.interval};
        judge(metric, measured, metric.metric.lower_is_better, metric.margin, frame, [&](double needed_p) {
            measured.p = metric.p;
            measured.confidence = 1.0 - options.alpha;
            measured.needed_p = needed_p;
            return morePairsToDecide(measured, metric.margin);
        });
    }
}

/// Measures the differences; the verdicts follow when all p-values are adjusted.
Result<Comparison> measure(const std::vector<RunFigures>& runs, const std::string& baseline,
                           const std::string& candidate, const ComparisonOptions& options) {
    auto pairing = pairUp(runs, baseline, candidate);
    if (!pairing)
        return tl::unexpected(pairing.error());
    Comparison comparison{baseline, candidate, options, std::move(*pairing), {}, {}, {}};
    comparison.success = compareSuccess(comparison.pairing, 1.0 - options.alpha);
    std::vector<MetricComparison> compared(options.metrics.size());
    inParallel(compared.size(), [&](std::size_t i) { // Each has a generator of its own.
        compared[i] = compareMetric(options.metrics[i], comparison.pairing, options);
    });
    std::ranges::copy_if(compared, std::back_inserter(comparison.metrics),
                         [](const MetricComparison& one) { return one.pairs() > 0; });
    return comparison;
}

Verdict overallOf(const Comparison& comparison) {
    std::vector<std::pair<Verdict, bool>> all{{comparison.success.verdict, comparison.success.not_worse}};
    for (const MetricComparison& metric : comparison.metrics)
        all.emplace_back(metric.verdict, metric.not_worse);
    const auto any = [&](Verdict verdict) {
        return std::any_of(all.begin(), all.end(), [=](const auto& one) { return one.first == verdict; });
    };
    if (any(Verdict::Worse))
        return Verdict::Worse;
    if (!std::all_of(all.begin(), all.end(), [](const auto& one) { return one.second; }))
        return Verdict::Undecided;
    return any(Verdict::Better) ? Verdict::Better : any(Verdict::Undecided) ? Verdict::NotWorse : Verdict::Equal;
}

} // namespace

int Comparison::exitCode() const {
    return overall == Verdict::Worse ? 1 : overall == Verdict::Undecided ? 3 : 0;
}

std::optional<std::size_t> Comparison::moreSeeds() const {
    std::optional<std::size_t> most = success.more_seeds;
    for (const MetricComparison& metric : metrics)
        most = most && metric.more_seeds ? std::max(most, metric.more_seeds) : std::nullopt;
    return most;
}

Result<Comparison> compare(const std::vector<RunFigures>& runs, const std::string& baseline,
                           const std::string& candidate, const ComparisonOptions& options) {
    return compareAll(runs, baseline, {candidate}, options).map([](std::vector<Comparison>&& all) {
        return std::move(all.front());
    });
}

Result<std::vector<Comparison>> compareAll(const std::vector<RunFigures>& runs, const std::string& baseline,
                                           const std::vector<std::string>& candidates,
                                           const ComparisonOptions& options) {
    std::vector<Comparison> all;
    for (const std::string& candidate : candidates) {
        auto measured = measure(runs, baseline, candidate, options);
        if (!measured)
            return tl::unexpected(measured.error());
        all.push_back(*std::move(measured));
    }
    const std::size_t questions = adjust(all);
    for (Comparison& comparison : all) {
        judgeAll(comparison, questions);
        comparison.overall = overallOf(comparison);
    }
    return all;
}

int exitCodeOf(const std::vector<Comparison>& comparisons) {
    const auto any = [&](int code) {
        return std::ranges::any_of(comparisons, [=](const Comparison& one) { return one.exitCode() == code; });
    };
    return any(1) ? 1 : any(3) ? 3 : 0;
}

} // namespace usar::campaign
