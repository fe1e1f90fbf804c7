// Sets the INS from ground truth while the robot lies on the ground: the only place that looks at ground truth.
#pragma once

#include <optional>

#include "core/agent/command_port.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/settings.h"

namespace usar::airrobot {

enum class ResetState { Idle, Resting, Waiting, Done, Failed };

/// Thesis 4.1: after several seconds at rest, SET INS POSE with the values of ground truth; RES says OK. Asked again
/// after 2 s without OK. A server that sends no RES (UDK) counts as obedient when the INS then agrees with the truth.
/// Owned by one robot; stepped once a tick.
class InsReset {
public:
    void start(Seconds now);
    void cancel() { state_ = ResetState::Idle; }
    ResetState step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port, const Settings& settings);
    ResetState state() const { return state_; }

private:
    bool confirmed(modules::RobotModules& robot) const;

    ResetState state_ = ResetState::Idle;
    Seconds since_{0.0};
    Seconds sent_{0.0};
    std::optional<Pose> rest_pose_;
    long long attempts_ = 0;
};

} // namespace usar::airrobot
