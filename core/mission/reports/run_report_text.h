// Report on the runs of a plan, for people and for programs: the output of `usar-mission plan-report`.
#pragma once

#include <string>

#include <QByteArray>
#include <QString>

#include "core/base/result.h"
#include "core/posh/trace/run_statistics.h"

namespace usar::mission {

/// Report for people: what speaks against the plan, and how the time was spent. `runs` is the number of runs in
/// `statistics`.
std::string runReportText(const posh::RunStatistics& statistics, int runs);

/// Report for programs, one JSON object per line. First `kind` "plan" with `plan` (its title), `runs`, `cycles` and
/// `time_s`; then each "finding" with `remark` ("never-selected" …), `path`, `name`, `line`, `column`, `message`; then
/// each "element" with `type`, `path`, `name`, `line`, `column`, and for a sense `asked` and `held`, for all others
/// `time_s`, `time_pct`, `cycles`, `started`, `succeeded`, `failed`, `interrupted`, `skipped` and, if it was measured,
/// `spent_ms` and `longest_ms`.
QByteArray runReportJson(const posh::RunStatistics& statistics, int runs);

/// Writes the report of one run to a file, which is replaced atomically: as JSON lines if the name ends in .jsonl or
/// .json, else as text.
Result<void> saveRunReport(const posh::RunStatistics& statistics, const QString& path);

} // namespace usar::mission
