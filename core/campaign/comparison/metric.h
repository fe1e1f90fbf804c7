// A figure of a run, described for a comparison.
#pragma once

#include <string>
#include <vector>

#include "core/campaign/statistics/sample.h"

namespace usar::campaign {

/// A difference of at most so much does not matter.
struct Margin {
    double size = 0.0;
    bool is_share = false; ///< The size is a share of the baseline's median and has no unit.
};

/// Says what a run contributes that was flown but not done.
enum class UnfinishedRuns {
    CountTheLimit, ///< the time limit of its mission, however it ended; without one see `valuesOf`
    AsMeasured,    ///< what was measured up to its end; without a figure its pair is left out
    LeftOut,       ///< nothing, because the figure of an unfinished mission says nothing; its pair is left out
};

struct Metric {
    std::string key;   ///< in RunFigures::metrics
    std::string title; ///< for people, as "Mapping error"
    std::string unit;  ///< "s"; empty for counts
    int decimals = 0;  ///< that people want to read
    bool lower_is_better = true;
    Margin margin;
    UnfinishedRuns unfinished = UnfinishedRuns::AsMeasured;
    /// At each end of the sorted differences; interquartile for the interquartile mean, 0 for the mean. Counts have the
    /// mean: what rarely happens, and then often, would be trimmed away.
    double trimmed_share = interquartile;

    /// "IQM" or "mean", for a table.
    const char* estimator() const { return trimmed_share > 0.0 ? "IQM" : "mean"; }
};

/// Duration, way, coverage, reachable coverage, mapping error, charges and collisions, with their usual margins.
std::vector<Metric> usualMetrics();

/// The size of the margin in the metric's unit.
double marginOf(const Metric& metric, double baseline_median);

} // namespace usar::campaign
