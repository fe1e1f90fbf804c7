// Marks on the parts of a drawn plan, each with words for the user: breakpoints, pins and disabled drives that the user
// has set, and the halt.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QStringList>

#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// The marks on one part of a plan.
struct PlanMark {
    std::string path;          ///< path of the part, as the engine names it
    int breakpoints = 0;       ///< number of enabled breakpoints
    int breakpoints_off = 0;   ///< number of disabled breakpoints
    bool conditional = false;  ///< one of them has a condition or ignores its first hits
    bool pinned = false;       ///< pinned to an answer that the user chose
    bool switched_off = false; ///< a drive that the user has disabled
    bool halted = false;       ///< the plan is halted here
    QStringList words{};       ///< all of this in words for the user
    bool operator==(const PlanMark&) const = default;
};

/// The marks by node of a drawn plan. A node that is drawn once for several places has the marks of all of them.
class PlanMarks {
public:
    PlanMarks() = default;
    PlanMarks(const PlanTree& tree, const std::vector<PlanMark>& marks);

    /// Returns nullptr for a node without marks.
    const PlanMark* at(PlanNodeId node) const;
    bool empty() const { return by_node_.empty(); }

private:
    std::map<PlanNodeId, PlanMark> by_node_;
};

/// Adds the breakpoints of this plan. Breakpoints on keys of the blackboard, and those whose place the plan
/// no longer has, leave no mark.
void markBreakpoints(const BreakpointList& list, const std::string& plan_name, std::vector<PlanMark>& marks);
/// Adds the places whose calls are pinned, and the drives that are switched off. `paths` are the paths of all places of
/// the program, by place.
void markPins(const agent::SetPins& pins, const posh::Program& program, const std::vector<std::string>& paths,
              std::vector<PlanMark>& marks);
/// Adds the place at which the plan is halted.
void markHalt(const std::string& path, std::vector<PlanMark>& marks);

} // namespace usar::widgets
