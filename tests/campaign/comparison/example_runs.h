// Runs of two variants, "old" and "new", for the tests of comparisons.
#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/campaign/comparison/run_figures.h"

namespace usar::test {

inline campaign::RunFigures run(const std::string& variant, std::size_t pair,
                                campaign::Outcome outcome = campaign::Outcome::Done) {
    campaign::RunFigures figures;
    figures.number = 2 * pair + (variant == "new" ? 1 : 0);
    figures.pair = pair;
    figures.seed = pair;
    figures.mission = "quick_scan";
    figures.variant = variant;
    figures.outcome = outcome;
    figures.time_limit_s = 300.0;
    figures.command = "usar-mission run quick_scan.json --seed " + std::to_string(pair);
    if (outcome != campaign::Outcome::Done)
        figures.reason = "The area was not covered after " + std::to_string(pair) + ".5 s.";
    return figures;
}

/// How "new" differs from "old" in the runs of a campaign.
struct Change {
    double duration_s = 0.0;
    double rmse_m = 0.0;
    double collisions_in_tenth = 0.0; ///< more collisions, in every tenth run
    double noise_s = 4.0;             ///< spread of the difference of durations
};

/// Runs that are all done, of as many seeds. Durations are 120 s with a spread of 15 s that the seed explains.
inline std::vector<campaign::RunFigures> doneRuns(std::size_t pairs, const Change& change) {
    Random random = seeded(22, 0);
    std::vector<campaign::RunFigures> runs;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const double duration_s = 120.0 + gaussian(random, 15.0), rmse_m = 0.5 + 0.1 * uniform(random, 0.0, 1.0);
        for (const std::string variant : {"old", "new"}) {
            campaign::RunFigures one = run(variant, pair);
            const bool is_new = variant == "new";
            one.metrics["duration_s"] =
                duration_s + (is_new ? change.duration_s + gaussian(random, change.noise_s) : 0.0);
            one.metrics["distance_m"] = 5.0 * duration_s;
            one.metrics["coverage_pct"] = 99.0;
            one.metrics["rmse_m"] = rmse_m + (is_new ? change.rmse_m + gaussian(random, 0.01) : 0.0);
            one.metrics["charges"] = 1.0;
            one.metrics["collisions"] = is_new && pair % 10 == 0 ? change.collisions_in_tenth : 0.0;
            runs.push_back(one);
        }
    }
    return runs;
}

} // namespace usar::test
