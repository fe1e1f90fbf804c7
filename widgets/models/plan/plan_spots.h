// The places of a running plan that one part of its drawing stands for.
#pragma once

#include <string>
#include <vector>

#include "core/posh/run/program.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// A place of a program, with the names by which breakpoints and pins refer to it.
struct PlanSpot {
    std::string path;  ///< "/P:0/DC:0/DE:1"
    std::string names; ///< the same path as names, separated by " ▸ "
    std::string call;  ///< the call as traces write it; empty unless the place is a sense or an act
    posh::PlaceKind kind = posh::PlaceKind::Collection;
    bool operator==(const PlanSpot&) const = default;
};

/// The places that a node draws, in the order of the program: more than one if the plan uses the part at several places
/// and draws it once; none if `node` is none. `paths` are the paths of all places, by place.
std::vector<PlanSpot> spotsOfNode(const posh::Program& program, const std::vector<std::string>& paths,
                                  const PlanTree& tree, PlanNodeId node);

} // namespace usar::widgets
