#include "core/campaign/comparison/coverage_band.h"

#include <algorithm>

#include "core/campaign/statistics/sample.h"

namespace usar::campaign {

namespace {

/// `points` is not empty; their times ascend.
double coverageAt_pct(const std::vector<QPointF>& points, double elapsed_s) {
    const auto after = std::ranges::upper_bound(points, elapsed_s, {}, &QPointF::x);
    if (after == points.begin())
        return 0.0;
    const QPointF before = *(after - 1);
    if (after == points.end())
        return before.y();
    return before.y() + (after->y() - before.y()) * (elapsed_s - before.x()) / (after->x() - before.x());
}

} // namespace

std::vector<CoverageSpread> coverageBand(const std::vector<const RunFigures*>& runs, double last_s, int steps) {
    std::vector<const RunFigures*> telling;
    std::ranges::copy_if(runs, std::back_inserter(telling),
                         [](const RunFigures* run) { return !run->course.coverage.empty(); });
    std::vector<CoverageSpread> band;
    if (telling.empty())
        return band;
    std::vector<double> covered_pct(telling.size());
    for (int step = 0; step <= steps; ++step) {
        const double elapsed_s = last_s * step / steps;
        std::ranges::transform(telling, covered_pct.begin(),
                               [&](const RunFigures* run) { return coverageAt_pct(run->course.coverage, elapsed_s); });
        std::ranges::sort(covered_pct);
        band.push_back({elapsed_s, quantileOfSorted(covered_pct, 0.1), quantileOfSorted(covered_pct, 0.5),
                        quantileOfSorted(covered_pct, 0.9)});
    }
    return band;
}

double lastCoverage_s(const std::vector<const RunFigures*>& runs) {
    double last_s = 0.0;
    for (const RunFigures* run : runs)
        if (!run->course.coverage.empty())
            last_s = std::max(last_s, run->course.coverage.back().x());
    return last_s;
}

} // namespace usar::campaign
