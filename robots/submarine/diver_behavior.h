// The behavior "submarine/cpp": the thesis's nautical robot (3.5.1).
#pragma once

#include "robots/submarine/camera_sweep.h"
#include "robots/submarine/diver.h"

namespace usar::submarine {

/// Asks for the robot's limits, passes messages to the Diver, which decides, sends its commands and moves the camera.
class DiverBehavior : public agent::TimedBehavior<Diver> {
public:
    using TimedBehavior::TimedBehavior;
    void tick(const agent::Tick& tick, agent::CommandPort& port) override;
    protocol::Command safeCommand() const override { return protocol::NauticDrive{0.0, 0.0, 0.0}; }

private:
    void moveCamera(const agent::Tick& tick, agent::CommandPort& port);

    Questionnaire questions_; ///< finds out the limits
    CameraSweep camera_;
    bool zoom_refused_ = false; ///< the user has been told that the camera refuses to zoom
};

} // namespace usar::submarine
