// A behavior whose every answer is written by the test.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/agent/behavior_host.h"

namespace usar::test {

/// What a ScriptedBehavior is told and has seen; shared with the test, which outlives the behavior.
struct Script {
    std::function<void(const agent::Tick&, agent::CommandPort&)> on_tick;
    std::function<void(const protocol::InfoLine&, agent::CommandPort&)> on_info;
    std::function<void(agent::Order, agent::CommandPort&)> on_order;
    std::function<void(const agent::PlanControl&, agent::CommandPort&)> on_control;
    protocol::Command safe = protocol::AerialDrive{0.0, 0.0, 0.0, 0.0};

    int ticks = 0;
    std::vector<std::string> lines;
    std::vector<agent::Order> orders;
    std::vector<agent::ParameterSet> parameters;
};

class ScriptedBehavior : public agent::Behavior {
public:
    explicit ScriptedBehavior(std::shared_ptr<Script> script) : script_(std::move(script)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort& port) override {
        script_->lines.push_back(line.text);
        if (script_->on_info)
            script_->on_info(line, port);
    }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
        ++script_->ticks;
        if (script_->on_tick)
            script_->on_tick(tick, port);
    }
    void order(agent::Order order, agent::CommandPort& port) override {
        script_->orders.push_back(order);
        if (script_->on_order)
            script_->on_order(order, port);
    }
    void control(const agent::PlanControl& control, agent::CommandPort& port) override {
        if (script_->on_control)
            script_->on_control(control, port);
    }
    void setParameters(const agent::ParameterSet& parameters) override { script_->parameters.push_back(parameters); }
    protocol::Command safeCommand() const override { return script_->safe; }

private:
    std::shared_ptr<Script> script_;
};

inline std::shared_ptr<agent::BehaviorHost> hostOf(const std::shared_ptr<Script>& script) {
    return std::make_shared<agent::BehaviorHost>(std::make_unique<ScriptedBehavior>(script), "test/scripted");
}

} // namespace usar::test
