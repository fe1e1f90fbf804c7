// The behavior "submarine/cpp": the thesis's nautical robot (3.5.1).
#pragma once

#include <utility>

#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/diver.h"

namespace usar::submarine {

/// Asks for the robot's limits, passes messages to the Diver, which decides, sends its commands and moves the camera.
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
    /// Stops the robot and publishes how the behavior ended.
    void end(agent::CommandPort& port);

    Questionnaire questions_; ///< finds out the limits
    Diver diver_;
    CameraSweep camera_;
    bool zoom_refused_ = false; ///< the user has been told that the camera refuses to zoom
};

} // namespace usar::submarine
