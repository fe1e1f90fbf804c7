// The figures of one run of a campaign, as the comparison of two variants needs them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QPointF>

#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// True where the variant itself is to answer for the end of the run. What was refused or killed says nothing about how
/// it flies, and is to be flown again.
bool counts(Outcome outcome);

/// How a run went; empty where the results do not tell. Places in meters, map frame.
struct CourseFigures {
    std::vector<QPointF> coverage; ///< x: seconds since the start, y: percent
    std::vector<QPointF> path;
    std::vector<QPointF> given_up; ///< goals
    std::vector<QPointF> collisions;
};

struct RunFigures {
    std::size_t number = 0; ///< in the campaign
    std::size_t pair = 0;   ///< it is the same for the variants of one seed; with the mission it names a pair
    std::uint64_t seed = 0;
    std::string mission;
    std::string variant;
    Outcome outcome = Outcome::Done;
    /// By the keys of a run's summary: duration_s, distance_m, coverage_pct, reachable_coverage_pct, rmse_m, charges,
    /// collisions. Absent and nullopt: not known.
    std::map<std::string, std::optional<double>> metrics;
    std::string reason;                 ///< why it was not fulfilled; a sentence or empty
    std::string command;                ///< flies the run again; empty: not known
    std::optional<double> time_limit_s; ///< of the mission, on the protocol clock; absent: it has none
    CourseFigures course{};
    std::string picture{}; ///< file with the picture of its map; empty: none was kept
};

} // namespace usar::campaign
