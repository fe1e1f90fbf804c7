// Sentences for the user about a plan that is halted or was replaced while it ran.
#pragma once

#include <QString>

#include "core/agent/published.h"
#include "core/base/diagnostics.h"

namespace usar::widgets {

/// "R1 stands still: before robot ▸ work · cycle 12, 3.4 s". `lockstep`: the server's time stands still, too; otherwise
/// a second sentence says that it does not.
QString haltText(const QString& robot, const agent::PlanHalted& halted, bool lockstep);

/// A sentence, and how much it matters.
struct PlanNewsText {
    Severity severity = Severity::Note;
    QString text;
};
/// Says whether the robot continues, begins at the root, or refuses the new plan, and why.
PlanNewsText replacedText(const QString& robot, const agent::PlanReplaced& replaced);

} // namespace usar::widgets
