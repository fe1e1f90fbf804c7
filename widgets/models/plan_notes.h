// What there is to say of a plan's text that is no fault.
#pragma once

#include <vector>

#include <QString>

#include "core/posh/plan.h"

namespace usar::widgets {

/// Marked as findings are, below warnings in weight: nothing need be mended.
struct PlanNote {
    posh::Spot at;
    QString words; ///< as findings read: "4:3: note N501: …"
};

/// N501, at the collection's keyword: it asks for real time, and the plan runs by the robot's clock all the same.
std::vector<PlanNote> notesOf(const posh::Plan& plan);

} // namespace usar::widgets
