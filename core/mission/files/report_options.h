// The command lines of `usar-mission lines`, `check-plan` and `plan-report`.
#pragma once

#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/usage/program.h"

namespace usar::mission {

/// Options of `usar-mission check-plan`.
struct CheckPlanOptions {
    std::optional<QString> robot; ///< whose senses and acts the plans are checked against; absent: none
    QStringList files;            ///< at least one; "-" is standard input
    bool operator==(const CheckPlanOptions&) const = default;
};

/// Options of `usar-mission plan-report`.
struct PlanReportOptions {
    bool json = false; ///< JSON lines instead of text
    QStringList files; ///< at least one
    bool operator==(const PlanReportOptions&) const = default;
};

/// The command lines begin with the verb and do not include the program's name. Errors say how to call the verb.
Result<CheckPlanOptions> readCheckPlanOptions(const QStringList& arguments);
Result<PlanReportOptions> readPlanReportOptions(const QStringList& arguments);
/// The file of `usar-mission lines`; "-" is standard input.
Result<QString> readLinesFile(const QStringList& arguments);

/// The three in words.
QList<usage::Verb> reportVerbs();

} // namespace usar::mission
