// The runs of POSH plans that recordings and trace files hold, counted plan by plan.
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/posh/run_statistics.h"

namespace usar::mission {

/// All runs of one plan.
struct PlanRuns {
    posh::RunStatistics statistics;
    int runs = 0;
};

struct RecordedTraces {
    std::vector<std::string> traces; ///< each the bytes of a trace file (core/posh/trace_file.h)
    std::string complaint;           ///< a sentence about what the file has lost, or empty
};

/// The file itself where it is a trace, else one trace for each run of a recording. A file that is neither, and a
/// recording in which no plan decided, are errors that name it.
Result<RecordedTraces> readTraces(const QString& path);

/// Adds the runs of a trace to those of the same plan, or behind the others. A plan that was replaced on the way is a
/// run of each. A sentence where the trace is damaged, else nothing; a plan that cannot be read is damage, too.
std::string addRuns(const std::string& trace, std::vector<PlanRuns>& plans);

} // namespace usar::mission
