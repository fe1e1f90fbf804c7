// What one run of a campaign came to, as the comparison of two variants needs it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace usar::campaign {

/// How a run ended.
enum class RunOutcome {
    Done,        ///< the mission was fulfilled
    Failed,      ///< it was flown, and not fulfilled
    Refused,     ///< it could not begin
    Crashed,     ///< the program died by itself
    Killed,      ///< somebody or the machine ended the program
    TimedOut,    ///< the program did not end in time
    OutOfMemory, ///< the program used more memory than it may
};

/// The word for people and files: "done", "timed out".
const char* wordOf(RunOutcome outcome);

/// True where the variant itself is to answer for the end of the run. What was refused or killed says nothing about how
/// it flies, and is to be flown again.
bool counts(RunOutcome outcome);

struct RunFigures {
    std::size_t number = 0; ///< in the campaign
    std::size_t pair = 0;   ///< index of the seed, which the variants share; with the mission it names a pair
    std::string mission;
    std::string variant;
    RunOutcome outcome = RunOutcome::Done;
    /// By the keys of a run's summary: duration_s, distance_m, coverage_pct, reachable_coverage_pct, rmse_m, charges,
    /// collisions. Absent and nullopt: not known.
    std::map<std::string, std::optional<double>> metrics;
    std::string reason;                 ///< why it was not fulfilled; a sentence or empty
    std::string command;                ///< flies the run again; empty: not known
    std::optional<double> time_limit_s; ///< of the mission, on the protocol clock; absent: it has none
};

} // namespace usar::campaign
