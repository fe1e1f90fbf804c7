// The behavior "ers/cpp": the thesis's legged robot (3.5.2).
#pragma once

#include "robots/ers/kicker.h"

namespace usar::ers {

/// Passes messages to the Kicker, which decides, and sends its commands. Rights the robot after a fall and marks its
/// path with TRACE.
class KickerBehavior : public agent::TimedBehavior<Kicker> {
public:
    using TimedBehavior::TimedBehavior;
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    /// Puts all paws down so that the robot stands still.
    protocol::Command safeCommand() const override;

private:
    void trace(agent::CommandPort& port);

    bool traced_ = false;            ///< whether TRACE was last switched on or off
    double traced_interval_s_ = 0.0; ///< interval that was last sent
};

} // namespace usar::ers
