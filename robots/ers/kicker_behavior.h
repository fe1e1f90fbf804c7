// The behavior "ers/cpp": the thesis's legged robot (3.5.2).
#pragma once

#include <utility>

#include "robots/ers/kicker.h"

namespace usar::ers {

/// Passes messages to the Kicker, which decides, and sends its commands. Rights the robot after a fall and marks its
/// path with TRACE.
class KickerBehavior : public agent::Behavior {
public:
    explicit KickerBehavior(agent::BehaviorContext context) : kicker_(std::move(context)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort&) override { kicker_.hear(line); }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { kicker_.setParameters(parameters); }
    /// Puts all paws down so that the robot stands still.
    protocol::Command safeCommand() const override;

private:
    void trace(agent::CommandPort& port);
    /// Stops the robot and publishes how the behavior ended.
    void end(agent::CommandPort& port);

    Kicker kicker_;
    bool traced_ = false;            ///< whether TRACE was last switched on or off
    double traced_interval_s_ = 0.0; ///< interval that was last sent
};

} // namespace usar::ers
