// What runs of a plan came to, for people and for machines: what `usar-mission plan-report` prints.
#pragma once

#include <string>

#include <QByteArray>

#include "core/posh/run_statistics.h"

namespace usar::mission {

/// Lines for a person: what speaks against the plan, and how much of the time went where. `runs` of them are counted.
std::string runReportText(const posh::RunStatistics& statistics, int runs);

/// JSON objects, one a line. First `kind` "plan" with `plan` (its title), `runs`, `cycles` and `time_s`; then each
/// "finding" with `remark` ("never-selected" …), `path`, `name`, `line`, `column`, `message`; then each "element" with
/// `type`, `path`, `name`, `line`, `column`, `time_s`, `time_pct`, `cycles`, `started`, `succeeded`, `failed`,
/// `interrupted`, `skipped`, `asked`, `held`; and, where somebody measured, `spent_ms` and `longest_ms`.
QByteArray runReportJson(const posh::RunStatistics& statistics, int runs);

} // namespace usar::mission
