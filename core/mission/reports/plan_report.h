// Problems of a POSH plan as JSON lines, for scripts and editors: the output of `usar-mission check-plan`.
#pragma once

#include <vector>

#include <QIODevice>
#include <QString>

#include "core/agent/posh/posh_primitive.h"
#include "core/base/result.h"

namespace usar::mission {

/// Reads the plan in `input` and prints one JSON object per problem and line; given the senses and acts of a robot,
/// also for what does not fit that robot. An object has `code` ("E202"), `severity` ("error", "warning"), `line` and
/// `column` from 1 (a column is one code point), `message`, `file`; if a parenthesis was never closed, `opener` with
/// its `line` and `column`. The remark that the window shows for a plan that asks for real time (agent::clockRemark) is
/// reported as a "note", N501. Returns true if the plan has no errors; fails if `output` accepts no more.
Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives = nullptr);

} // namespace usar::mission
