// The seam between Mission Control and anything that decides: message-shaped, so that a behavior can run in this
// process, in a thread or in a process of its own without being changed.
#pragma once

#include <optional>
#include <string>

#include "core/agent/command_port.h"
#include "core/agent/parameters.h"
#include "core/agent/plan_control.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/modules/robot_modules.h"

namespace usar::agent {

/// What the behavior is asked to do.
struct Task {
    std::string robot_name;
    Pose start_in_map;     ///< where the robot was spawned
    Rectangle area_in_map; ///< mission area; empty for behaviors that need none
    bool operator==(const Task&) const = default;
};

/// What a person may ask of a running behavior.
enum class Order { Pause, Resume, LandNow };

/// One tick, on every STA: the protocol clock and the modules' newest values. Modules belong to the host; asking them
/// (geometry.query) is allowed, keeping a reference is not.
struct Tick {
    Seconds now{0.0};
    LineNumber line;
    modules::RobotModules& robot;
};

/// Decides. Sees info lines, module snapshots, parameters, orders and the tick's time; answers with commands and
/// published values; nothing else crosses. No GUI, no socket, no clock, no thread, no state shared with anyone.
class Behavior {
public:
    virtual ~Behavior();
    /// Every info line, before the tick that it may cause.
    virtual void onInfo(const protocol::InfoLine& line, CommandPort& port);
    virtual void tick(const Tick& tick, CommandPort& port) = 0;
    virtual void order(Order order, CommandPort& port) = 0;
    /// New values while running; already checked against the specs.
    virtual void setParameters(const ParameterSet& parameters) = 0;
    /// Of a behavior that a plan decides; others refuse a plan and have nothing to halt.
    virtual void control(const PlanControl& control, CommandPort& port);
    /// The commands that make the robot safe at once (zero DRIVE); asked for at stop, at close and after a fault.
    virtual protocol::Command safeCommand() const = 0;
};

} // namespace usar::agent
