// "ers/cpp": the thesis's legged robot (3.5.2). What it hears and sends; the Kicker decides.
#pragma once

#include <utility>

#include "robots/ers/kicker.h"

namespace usar::ers {

class KickerBehavior : public agent::Behavior {
public:
    explicit KickerBehavior(agent::BehaviorContext context) : kicker_(std::move(context)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort&) override { kicker_.hear(line); }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { kicker_.setParameters(parameters); }
    /// Legs on which it stands.
    protocol::Command safeCommand() const override;

private:
    void trace(agent::CommandPort& port);
    void end(agent::CommandPort& port);

    Kicker kicker_;
    bool traced_ = false;
    double traced_interval_s_ = 0.0;
};

} // namespace usar::ers
