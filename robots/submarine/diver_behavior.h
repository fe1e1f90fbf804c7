// "submarine/cpp": the thesis's nautical robot (3.5.1). What it is asked and what it sends; the Diver decides.
#pragma once

#include <utility>

#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/diver.h"

namespace usar::submarine {

class DiverBehavior : public agent::Behavior {
public:
    explicit DiverBehavior(agent::BehaviorContext context) : diver_(std::move(context)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort&) override { diver_.hear(line); }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    void order(agent::Order order, agent::CommandPort& port) override;
    void setParameters(const agent::ParameterSet& parameters) override { diver_.setParameters(parameters); }
    protocol::Command safeCommand() const override { return protocol::NauticDrive{0.0, 0.0, 0.0}; }

private:
    void moveCamera(const agent::Tick& tick, agent::CommandPort& port);
    void publish(const agent::Tick& tick, agent::CommandPort& port);
    void end(agent::CommandPort& port);

    Questionnaire questions_;
    Diver diver_;
    CameraSweep camera_;
    bool zoom_refused_ = false;
};

} // namespace usar::submarine
