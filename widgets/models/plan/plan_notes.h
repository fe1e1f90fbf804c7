// Remarks about a plan's text that are not errors.
#pragma once

#include <vector>

#include <QString>

#include "core/posh/model/plan.h"

namespace usar::widgets {

/// Shown like a finding, but ranked below warnings; nothing needs to be fixed.
struct PlanNote {
    posh::Spot at;
    QString words; ///< worded like a finding: "4:3: note N501: …"
};

/// N501, at the keyword of the drive collection: the plan asks for real time, but runs on the robot's clock.
std::vector<PlanNote> notesOf(const posh::Plan& plan);

} // namespace usar::widgets
