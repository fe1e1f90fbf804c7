// The difference between two versions of a plan: parts added, removed, moved, renamed or changed, regardless of layout.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/posh/edit/plan_part.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

enum class ChangeKind { Added, Removed, Moved, Renamed, Changed };

/// One difference. For the documentation both parts are nullopt.
struct PlanChange {
    ChangeKind kind = ChangeKind::Changed;
    std::optional<PlanPart> before; ///< the part in the old plan; nullopt if it was added
    std::optional<PlanPart> after;  ///< the part in the new plan; nullopt if it was removed
    Spot after_at;                  ///< place in the new text; line 0 if there is none
    std::string line;               ///< "drive "work": trigger was ((a)), is ((b))"
};

/// Returns all differences; an empty list means that both plans have the same meaning. Layout, `;` comments and the
/// order of forms in the file do not count. A rename or a move is reported as such if the part is otherwise unchanged,
/// or if its parent kept its name.
std::vector<PlanChange> planDifference(const Plan& before, const Plan& after);

/// Summarizes the differences: "1 added, 2 changed", or "no difference".
std::string summaryOf(const std::vector<PlanChange>& changes);

} // namespace usar::posh
