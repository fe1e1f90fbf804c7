// The state that the senses and acts of an exploring P2DX share.
#pragma once

#include "core/agent/posh_primitives.h"
#include "robots/p2dx/explorer.h"

namespace usar::p2dx {

/// Connects an Explorer to a plan's engine. Owned by one behavior.
class ExplorerBody final : public agent::PoshBody {
public:
    explicit ExplorerBody(agent::BehaviorContext context) : explorer_(std::move(context)) {}

    const Explorer& explorer() const { return explorer_; }
    Explorer& explorer() { return explorer_; }

    void onInfo(const protocol::InfoLine& line) override { explorer_.hear(line); }
    void begin(const agent::Tick& tick) override { explorer_.perceive(tick); }
    void end(const agent::Tick&) override {
        for (agent::BehaviorEvent& event : explorer_.takeEvents())
            publish(std::move(event));
        publish(explorer_.pose());
    }
    bool order(agent::Order order) override { return explorer_.order(order); }
    void setParameters(const agent::ParameterSet& parameters) override { explorer_.setParameters(parameters); }
    void describe(agent::BehaviorStatus& status) const override { status = explorer_.status(); }
    std::optional<agent::BehaviorFinished> ended() const override { return explorer_.ending(); }
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }

private:
    Explorer explorer_;
};

using ExplorerPrimitives = agent::PoshPrimitives<ExplorerBody>;

// These register all senses and all acts.
void addExplorerSenses(ExplorerPrimitives& primitives);
void addExplorerActs(ExplorerPrimitives& primitives);

} // namespace usar::p2dx
