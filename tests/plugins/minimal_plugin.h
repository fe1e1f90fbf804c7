// The least a robot plugin can be; the bad ones in this folder each differ from it by one fault.
#pragma once

#include <QObject>

#include "core/agent/robot_plugin.h"

namespace usar::test {

class IdleBehavior : public agent::Behavior {
public:
    void tick(const agent::Tick&, agent::CommandPort&) override {}
    void order(agent::Order, agent::CommandPort&) override {}
    void setParameters(const agent::ParameterSet&) override {}
    protocol::Command safeCommand() const override { return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}; }
};

inline agent::RobotDescription minimalDescription() {
    agent::BehaviorDescription behavior;
    behavior.id = "test/idle";
    behavior.name = "Idle";
    behavior.parameters = {{"speed_m_s", "Speed", "Flight", "m/s", 1.0, 0.0, 2.0, "How fast.", {}}};
    return {"USARBot.Test", "Test robot", {"INS"}, {behavior}};
}

class MinimalPlugin : public agent::RobotPlugin {
public:
    agent::RobotDescription description() const override { return minimalDescription(); }
    Result<std::unique_ptr<agent::Behavior>> createBehavior(const std::string& id,
                                                            agent::BehaviorContext) const override {
        if (id != "test/idle")
            return failure("no such behavior", id);
        return std::make_unique<IdleBehavior>();
    }
};

} // namespace usar::test
