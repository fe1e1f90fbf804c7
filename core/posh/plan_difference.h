// What became of a plan between two versions of it: parts added, removed, moved, renamed or changed, whatever the
// layout.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/posh/plan.h"
#include "core/posh/plan_part.h"

namespace usar::posh {

enum class ChangeKind { Added, Removed, Moved, Renamed, Changed };

struct PlanChange {
    ChangeKind kind = ChangeKind::Changed;
    std::optional<PlanPart>
        before;                    ///< of the old plan; nothing for what was added. Of the documentation there is none.
    std::optional<PlanPart> after; ///< of the new plan; nothing for what was removed
    Spot before_at;                ///< in the old text; line 0: nowhere
    Spot after_at;                 ///< in the new one
    std::string line;              ///< "drive "work": trigger was ((a)), is ((b))"
    bool operator==(const PlanChange&) const = default;
};

/// Empty for plans that mean the same. Layout, `;` comments and the order of the forms in the file do not count. A
/// rename or a move is reported as such if the part is otherwise unchanged, or if its parent kept its name.
std::vector<PlanChange> planDifference(const Plan& before, const Plan& after);

/// "1 added, 2 changed"; "no difference".
std::string summaryOf(const std::vector<PlanChange>& changes);

} // namespace usar::posh
