// The marks that breakpoints, pins and a halt leave on a drawn plan, each with words for the user.
#pragma once

#include <string>
#include <vector>

#include "widgets/models/plan/breakpoint_list.h"
#include "widgets/models/plan/plan_marks.h"

namespace usar::widgets {

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
