// Sets the INS from ground truth while the robot is on the ground. No other code of the robot uses ground truth.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

/// The state of a reset. Resting: the robot must not move for some seconds. Waiting: for the server's answer.
enum class ResetState { Idle, Resting, Waiting, Done, Failed };

/// Follows the thesis (4.1): after several seconds at rest it sends SET INS POSE with the pose from ground truth, and
/// the server answers with RES OK. Without an OK it repeats the command after 2 s. For a server that sends no RES
/// (UDK), the reset has succeeded if the INS then agrees with ground truth. A robot that slides gets no rest, so it
/// fails after a minute. Owned by one robot; call `step` once per tick.
class InsReset {
public:
    void start(Seconds now);
    /// Returns Failed if there is no ground truth, if the robot finds no rest, or after `reset_attempts` commands
    /// without success.
    ResetState step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port, const Settings& settings);
    ResetState state() const { return state_; }

private:
    bool confirmed(modules::RobotModules& robot) const;

    ResetState state_ = ResetState::Idle;
    Seconds begun_{0.0};
    Seconds since_{0.0};            ///< start of the rest
    Seconds sent_{0.0};             ///< time of the last command
    std::optional<Pose> rest_pose_; ///< pose in which the robot rests, from ground truth
    long long attempts_ = 0;
};

} // namespace usar::airrobot
