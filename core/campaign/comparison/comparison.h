// Two variants of a campaign compared on equal seeds: what is better, and how sure that is.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/campaign/comparison/metric.h"
#include "core/campaign/comparison/pairing.h"
#include "core/campaign/comparison/verdict.h"
#include "core/campaign/statistics/bootstrap.h"
#include "core/campaign/statistics/proportion.h"

namespace usar::campaign {

struct ComparisonOptions {
    std::vector<Metric> metrics = usualMetrics();
    double success_margin = 0.05; ///< a difference of the success rates that does not matter
    double alpha = 0.05;          ///< all verdicts together; the intervals are those of 1 - alpha
    std::size_t least_pairs = 10; ///< for any verdict
    int resamples = 10'000;
    std::uint64_t seed = 1; ///< Equal seeds resample alike.
};

/// Success is that a run was done; what failed, crashed, timed out or ran out of memory had none.
struct SuccessComparison {
    PairedCount count;
    Interval baseline; ///< Wilson's
    Interval candidate;
    Interval difference;            ///< candidate minus baseline
    double p = 1.0;                 ///< McNemar's
    double holm_p = 1.0;            ///< adjusted together with those of the metrics and of the other candidates
    std::vector<RunPair> differing; ///< the runs to look at
    Verdict verdict = Verdict::Undecided;
    bool not_worse = false;
    std::optional<std::size_t> more_seeds; ///< that would decide; absent: nobody knows
};

/// One metric. All differences are candidate minus baseline, in the metric's unit.
struct MetricComparison {
    Metric metric;
    PairedValues values;                 ///< also how many pairs were left out
    std::size_t baseline_unfinished = 0; ///< runs of all pairs that were not done, whether left out or not
    std::size_t candidate_unfinished = 0;
    /// Means up to the limit, which whatever was not done counts; absent where the figure counts no limit or all is
    /// done.
    std::optional<double> baseline_restricted;
    std::optional<double> candidate_restricted;
    double baseline_median = 0.0;
    double candidate_median = 0.0;
    std::vector<double> sorted_differences;
    double median_difference = 0.0;
    double difference = 0.0; ///< trimmed mean, by the metric's share
    Interval interval;       ///< It belongs to `difference`, and is BCa's, stratified by mission.
    double p = 1.0;          ///< Wilcoxon's
    double holm_p = 1.0;
    double correlation = 0.0;    ///< It is that of the pairs, and not a number without spread.
    double variance_ratio = 0.0; ///< paired over unpaired; not a number without spread
    double ratio = 0.0;          ///< geometric mean of candidate over baseline; not a number if a value is not positive
    double improved = 0.0;       ///< share of pairs in which the candidate is better
    double margin = 0.0;
    Verdict verdict = Verdict::Undecided;
    bool not_worse = false;
    std::optional<std::size_t> more_seeds;

    std::size_t pairs() const { return values.baseline.size(); }
};

struct Comparison {
    std::string baseline;
    std::string candidate;
    ComparisonOptions options;
    Pairing pairing;
    SuccessComparison success;
    std::vector<MetricComparison> metrics; ///< in the order of the options, without those that no pair has
    Verdict overall = Verdict::Undecided;

    /// 0 not worse, 1 worse, 3 undecided.
    int exitCode() const;
    /// How many more seeds would decide everything; absent: nobody knows.
    std::optional<std::size_t> moreSeeds() const;
};

/// Compares the runs of two variants. `runs` must outlive the result, which points into it. For each metric the word is
/// that of verdictOn: the interval of the paired difference against the margin, and Wilcoxon's p after Holm beside it;
/// for success the interval of Bonett and Price, and McNemar's p after Holm. Overall: worse if success or any metric is
/// worse, else undecided if one of them could still be, else better if one is better, else equal if all are, else not
/// worse. An error says which variant has no runs.
Result<Comparison> compare(const std::vector<RunFigures>& runs, const std::string& baseline,
                           const std::string& candidate, const ComparisonOptions& options = {});

/// Compares each candidate with the baseline, in the order given. The p-values of all of them are adjusted together,
/// because who asks more questions is misled more easily.
Result<std::vector<Comparison>> compareAll(const std::vector<RunFigures>& runs, const std::string& baseline,
                                           const std::vector<std::string>& candidates,
                                           const ComparisonOptions& options = {});

/// The exit code of all of them: 1 if one candidate is worse, else 3 if one is undecided, else 0.
int exitCodeOf(const std::vector<Comparison>& comparisons);

} // namespace usar::campaign
