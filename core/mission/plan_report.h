// What is wrong with a POSH plan as JSON lines, for scripts and editors: what `usar-mission check-plan` prints.
#pragma once

#include <vector>

#include <QIODevice>
#include <QJsonObject>
#include <QString>

#include "core/agent/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/finding.h"

namespace usar::mission {

/// `code` ("E202"), `severity` ("error", "warning"), `line` and `column` from 1 (a column is one code point),
/// `message`, `file`; where a parenthesis was never closed, `opener` with its `line` and `column`.
QJsonObject toJson(const posh::Finding& finding, const QString& file);

/// One object a line, in the order of the findings, whoever found them: the reader, or a check against a robot. Refused
/// when `output` takes no more.
Result<void> reportFindings(const posh::Findings& findings, const QString& file, QIODevice& output);

/// Reads the plan that `input` holds and reports on it; with the senses and acts of a robot also on what does not fit
/// that robot. What the window says besides of a plan that asks for real time (agent::clockRemark) is a "note", N501.
/// True where it has no errors.
Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives = nullptr);

} // namespace usar::mission
