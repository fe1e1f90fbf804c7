// How the coverage of many runs grew: the middle of them, and the tenths that were slowest and fastest.
#pragma once

#include <vector>

#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

/// The coverage of some runs at one time, in percent.
struct CoverageSpread {
    double elapsed_s = 0.0;
    double tenth_pct = 0.0; ///< one run in ten has less
    double median_pct = 0.0;
    double ninetieth_pct = 0.0; ///< one run in ten has more
};

/// The spread at `steps` + 1 times from 0 to `last_s`. Between two known points a run grows evenly; after its last one
/// it keeps what it has, so that a run that has ended counts on. Runs that do not tell their coverage are left out;
/// empty if all are.
std::vector<CoverageSpread> coverageBand(const std::vector<const RunFigures*>& runs, double last_s, int steps = 60);

/// The time of the last point of all the runs, in seconds; 0 if there is none.
double lastCoverage_s(const std::vector<const RunFigures*>& runs);

} // namespace usar::campaign
