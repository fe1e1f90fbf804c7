// "p2dx/cpp": the thesis's ground robot (3.5.3), decided by a few ifs.
#pragma once

#include <utility>

#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

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
    void end(agent::CommandPort& port);

    Explorer explorer_;
};

} // namespace usar::p2dx
