// The places of a running plan that one part of its drawing stands for, and what the user has pinned or switched off.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/agent/plan_control.h"
#include "core/posh/run/program.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// A place of a program, with the names by which breakpoints and pins refer to it.
struct PlanSpot {
    std::string path;  ///< "/P:0/DC:0/DE:1"
    std::string names; ///< the same path as names, separated by " ▸ "
    std::string call;  ///< the call as traces write it; empty unless the place is a sense or an act
    posh::PlaceKind kind = posh::PlaceKind::Collection;
};

/// The places that a node draws, in the order of the program: more than one if the plan uses the part at several places
/// and draws it once; none if `node` is none. `paths` are the paths of all places, by place.
std::vector<PlanSpot> spotsOfNode(const posh::Program& program, const std::vector<std::string>& paths,
                                  const PlanTree& tree, PlanNodeId node);

/// A pin belongs to a call: it holds wherever the plan makes this call.
class PlanPins {
public:
    /// All pins and switched-off drives, to be sent to the robot.
    const agent::SetPins& all() const { return pins_; }
    bool empty() const { return pins_.empty(); }

    /// Removes the pin of this sense or act; returns false if it has none.
    bool release(const PlanSpot& spot);
    void pinAct(std::string_view call, posh::ActResult result) { pins_.acts.push_back({std::string(call), result}); }
    void pinSense(std::string_view call, const posh::Value& answer) {
        pins_.senses.push_back({std::string(call), answer});
    }
    /// Switches the drive off, or on again.
    void toggleDrive(const PlanSpot& spot);

private:
    agent::SetPins pins_;
};

} // namespace usar::widgets
