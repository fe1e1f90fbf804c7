// The behavior "p2dx/cpp": the thesis's ground robot (3.5.3), controlled by a few conditions in C++.
#pragma once

#include <utility>

#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

/// Sends one DRIVE per tick until the Explorer ends; then stops the wheels.
class ExplorerBehavior : public agent::Behavior {
public:
    explicit ExplorerBehavior(agent::BehaviorContext context) : explorer_(std::move(context)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort&) override { explorer_.hear(line); }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { explorer_.setParameters(parameters); }
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }

private:
    protocol::SkidDrive decide();
    /// Stops the robot and publishes how the behavior ended.
    void end(agent::CommandPort& port);

    Explorer explorer_;
};

} // namespace usar::p2dx
