// The calls that a user has pinned and the drives switched off in one run of a plan.
#pragma once

#include <string_view>

#include "core/agent/plan_control.h"
#include "widgets/models/plan/plan_spots.h"

namespace usar::widgets {

/// A pin belongs to a call: it holds wherever the plan makes this call.
class PlanPins {
public:
    /// All pins and switched-off drives, to be sent to the robot.
    const agent::SetPins& all() const { return pins_; }
    bool empty() const { return pins_.empty(); }

    /// Removes the pin of this sense or act; returns false if it has none.
    bool release(const PlanSpot& spot);
    void pinAct(std::string_view call, posh::ActResult result);
    void pinSense(std::string_view call, const posh::Value& answer);
    /// Switches the drive off, or on again.
    void toggleDrive(const PlanSpot& spot);

private:
    agent::SetPins pins_;
};

} // namespace usar::widgets
