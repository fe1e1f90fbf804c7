// The runs of two variants, joined by mission and seed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/campaign/comparison/metric.h"
#include "core/campaign/comparison/run_figures.h"
#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

/// Both runs belong to the caller, who keeps them for as long as the pair.
struct RunPair {
    const RunFigures* baseline = nullptr;
    const RunFigures* candidate = nullptr;
    int mission = 0; ///< index among the names of the missions
};

/// What could not be compared is counted here, so that nothing is missing without a word.
struct Pairing {
    std::vector<std::string> missions; ///< in alphabetical order
    std::vector<RunPair> pairs;        ///< sorted by mission, then seed; both runs count
    std::size_t single = 0;            ///< runs without a partner
    std::size_t not_counted = 0;       ///< pairs of which a run was refused or killed
    std::size_t repeated = 0;          ///< runs of a seed that its variant had flown already; the first stands
};

/// So many seeds have a pair; each mission and each of its worlds may have a pair of the same seed.
std::size_t seedsOf(const Pairing& pairing);

/// An error says that a variant has no runs, and names those that have.
Result<Pairing> pairUp(const std::vector<RunFigures>& runs, const std::string& baseline, const std::string& candidate);

/// The names of all variants, each once, in the order of their first runs.
std::vector<std::string> variantsOf(const std::vector<RunFigures>& runs);

/// The pairs in which both runs have a figure.
struct PairedValues {
    std::vector<double> baseline;
    std::vector<double> candidate;
    std::vector<int> missions; ///< index of the mission of each pair
    std::size_t left_out = 0;  ///< pairs without one of the figures
    std::size_t assumed = 0;   ///< runs that were not done, have no time limit, and count the longest time in its place
    std::optional<Interval> limits{}; ///< the least and the greatest time that a run counts that was not done
};

/// Where a run counts the limit of its mission and there is none, it counts the longest time of any run of the mission,
/// of either variant. So both are restricted to the same time, which was reached in one of them, and a failure costs no
/// less than any success. A mission that nobody has done has no such time.
PairedValues valuesOf(const Pairing& pairing, const Metric& metric);

/// Returns what a run contributes to a metric, or nothing. Figures that are not finite are nothing.
std::optional<double> valueOf(const RunFigures& run, const Metric& metric);

} // namespace usar::campaign
