// The interface between Mission Control and the code that makes decisions for a robot. It exchanges messages only, so
// that a behavior can run in the caller's thread, in a thread or in a process of its own without being changed.
#pragma once

#include <string>

#include "core/agent/command_port.h"
#include "core/agent/parameters.h"
#include "core/agent/plan_control.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/modules/robot_modules.h"

namespace usar::agent {

/// The task that a behavior is given.
struct Task {
    std::string robot_name;
    Pose start_in_map;     ///< pose at which the robot was spawned
    Rectangle area_in_map; ///< mission area; empty for behaviors that need none
    /// Map z above which all ground is dry, which sensors cannot tell; nullopt if nobody who knows the world has said.
    std::optional<double> dry_above_m{};
    bool operator==(const Task&) const = default;
};

/// An order by the operator to a running behavior.
enum class Order { Pause, Resume, LandNow };

/// The input of one tick, which occurs on every STA. The modules belong to the host; a behavior may query them
/// (geometry.query), but must not keep a reference.
struct Tick {
    Seconds now{0.0};             ///< on the protocol's clock
    LineNumber line;              ///< line number of the STA
    modules::RobotModules& robot; ///< newest values
};

/// Makes the decisions for one robot. Its only inputs are info lines, the modules' values, parameters, orders and the
/// time of the tick; its only outputs are commands and published values. A behavior has no GUI, socket, clock or thread
/// and shares no state. All calls come from one thread at a time. An exception stops the behavior.
class Behavior {
public:
    virtual ~Behavior() = default;
    /// Takes every info line, before the tick that the line may cause.
    virtual void onInfo(const protocol::InfoLine&, CommandPort&) {}
    /// Decides, on every STA.
    virtual void tick(const Tick& tick, CommandPort& port) = 0;
    /// Obeys an order of the operator, between ticks.
    virtual void order(Order order, CommandPort& port) = 0;
    /// Takes new values while running; they have been checked against the specs.
    virtual void setParameters(const ParameterSet& parameters) = 0;
    /// Controls the plan, if a plan makes the decisions. The default refuses a new plan and ignores everything else.
    virtual void control(const PlanControl& control, CommandPort& port) {
        if (const auto* const asked = std::get_if<ReplacePlan>(&control))
            port.publish(PlanReplaced{.fate = PlanFate::Refused,
                                      .plan_name = asked->plan.name,
                                      .reason = "No plan decides what this behavior does."});
    }
    /// The command that makes the robot safe at once (a DRIVE of zeros); used at stop, at close and after a fault.
    virtual protocol::Command safeCommand() const = 0;
};

} // namespace usar::agent
