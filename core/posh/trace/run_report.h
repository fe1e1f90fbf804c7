// A report of suspicious behavior in the runs of a plan: parts that never ran, senses that never changed, drives that
// kept alternating.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/posh/trace/run_statistics.h"

namespace usar::posh {

/// The kinds of entries in the report.
enum class RunRemark {
    NeverSelected, ///< a drive that never started, or an element never selected though its competence was entered
    NeverTrue,     ///< a sense that was evaluated and never held
    AlwaysTrue,    ///< a sense that was evaluated at least `often_asked` times and always held
    Oscillation,   ///< two drives that took turns more than `most_switches` times in ten seconds
    Starving,      ///< a drive that won but found nothing to do for ten cycles
    Spinning,      ///< a drive that used up the budget of acts of a cycle
};

/// Returns the identifier for machine-readable output: "never-selected".
std::string_view toText(RunRemark remark);

/// One entry of the report.
struct RunFinding {
    RunRemark remark = RunRemark::NeverSelected;
    Index place = 0;     ///< for Oscillation: that of the first of the two drives
    std::string message; ///< one sentence with the names of the place and figures
};

constexpr std::uint64_t often_asked = 50; ///< with fewer evaluations, "always held" has no significance
constexpr int most_switches = 6;          ///< more switches within ten seconds are an oscillation

/// Returns the report in the order of places; empty if there was no cycle. Elements and senses that were never reached
/// are left out, because the part above them is reported.
std::vector<RunFinding> reportOn(const RunStatistics& statistics);

} // namespace usar::posh
