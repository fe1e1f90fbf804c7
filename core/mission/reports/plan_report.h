// Problems of a POSH plan as JSON lines, for scripts and editors: the output of `usar-mission check-plan`.
#pragma once

#include <vector>

#include <QIODevice>
#include <QJsonObject>
#include <QString>

#include "core/agent/posh/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/model/finding.h"

namespace usar::mission {

/// One problem as a JSON object: `code` ("E202"), `severity` ("error", "warning"), `line` and `column` from 1 (a column
/// is one code point), `message`, `file`; if a parenthesis was never closed, `opener` with its `line` and `column`.
QJsonObject toJson(const posh::Finding& finding, const QString& file);

/// Prints one object per line, in the order of the findings, which may come from the reader or from a check against a
/// robot. Fails if `output` accepts no more.
Result<void> reportFindings(const posh::Findings& findings, const QString& file, QIODevice& output);

/// Reads the plan in `input` and reports on it; given the senses and acts of a robot, also on what does not fit that
/// robot. The remark that the window shows for a plan that asks for real time (agent::clockRemark) is reported as a
/// "note", N501. Returns true if the plan has no errors; fails if `output` accepts no more.
Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives = nullptr);

} // namespace usar::mission
