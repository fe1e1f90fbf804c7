#include "core/campaign/comparison/metric.h"

#include <cmath>

namespace usar::campaign {

std::vector<Metric> usualMetrics() {
    using enum UnfinishedRuns;
    constexpr Margin two_percent{0.02, true};
    return {
        {"duration_s", "Duration", "s", 1, true, two_percent, CountTheLimit, interquartile},
        {"distance_m", "Way", "m", 1, true, two_percent, LeftOut, interquartile},
        {"coverage_pct", "Coverage", "%", 2, false, {0.5, false}, AsMeasured, interquartile},
        {"reachable_coverage_pct", "Reachable coverage", "%", 2, false, {0.5, false}, AsMeasured, interquartile},
        {"rmse_m", "Mapping error", "m", 3, true, {0.05, false}, LeftOut, interquartile},
        {"charges", "Charges", "", 2, true, {0.5, false}, LeftOut, 0.0},
        {"collisions", "Collisions", "", 2, true, {0.5, false}, AsMeasured, 0.0},
    };
}

double marginOf(const Metric& metric, double baseline_median) {
    return metric.margin.is_share ? metric.margin.size * std::abs(baseline_median) : metric.margin.size;
}

} // namespace usar::campaign
