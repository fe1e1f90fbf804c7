// What runs of a plan say against it: what never happened, what never was otherwise, what could not settle.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/posh/run_statistics.h"

namespace usar::posh {

enum class RunRemark {
    NeverSelected, ///< a drive that never started, an element that never was chosen though its competence was entered
    NeverTrue,     ///< a sense that was asked and never held
    AlwaysTrue,    ///< a sense that was asked at least `often_asked` times and always held
    Oscillation,   ///< two drives that took turns more than `most_switches` times in ten seconds
    Starving,      ///< a drive that won and for ten cycles found nothing to do
    Spinning,      ///< a drive that used up the budget of acts
};

/// "never-selected": for lists that machines read.
std::string_view toText(RunRemark remark);

struct RunFinding {
    RunRemark remark = RunRemark::NeverSelected;
    Index place = 0;
    std::string message; ///< one sentence with the path by names, and figures
    bool operator==(const RunFinding&) const = default;
};

/// From here on, "always" says something.
constexpr std::uint64_t often_asked = 50;
constexpr int most_switches = 6;

/// In the order of places. Elements and senses that nothing led to are not spoken of: what stands above them is.
std::vector<RunFinding> reportOn(const RunStatistics& statistics);

} // namespace usar::posh
