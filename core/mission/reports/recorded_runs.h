// Counts the runs of POSH plans that recordings and trace files contain, plan by plan.
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/posh/trace/run_statistics.h"

namespace usar::mission {

/// Statistics of all runs of one plan.
struct PlanRuns {
    posh::RunStatistics statistics;
    int runs = 0;
};

/// Traces of plans from one file.
struct RecordedTraces {
    std::vector<std::string> traces; ///< each the bytes of a trace file (core/posh/trace/trace_file.h)
    std::string complaint;           ///< a sentence about what is missing from the file, or empty
};

/// Reads a file: a trace file gives itself, a recording one trace per run. A file that is neither, and a recording in
/// which no plan decided, are errors that name the file.
Result<RecordedTraces> readTraces(const QString& path);

/// Adds the runs of a trace to those of the same plan in `plans`, or appends them. A plan that was replaced on the way
/// counts as a run, and so does its successor. Returns a sentence if the trace is damaged or contains a plan that
/// cannot be read, else an empty text.
std::string addRuns(const std::string& trace, std::vector<PlanRuns>& plans);

} // namespace usar::mission
