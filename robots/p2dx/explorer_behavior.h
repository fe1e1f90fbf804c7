// The behavior "p2dx/cpp": the thesis's ground robot (3.5.3), controlled by a few conditions in C++.
#pragma once

#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

/// Sends one DRIVE per tick until the Explorer ends; then stops the wheels.
class ExplorerBehavior : public agent::TimedBehavior<Explorer> {
public:
    using TimedBehavior::TimedBehavior;
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }

private:
    protocol::SkidDrive decide();
};

} // namespace usar::p2dx
