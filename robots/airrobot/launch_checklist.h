// What must be known before the rotors turn: the thesis's RobotLaunch (4.3).
#pragma once

#include <optional>
#include <string>

#include "core/agent/command_port.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/sensor_layout.h"

namespace usar::airrobot {

enum class LaunchState { Waiting, Ready, Failed };

/// Asks for the robot's configuration, then sonars, then scanner, each once the one before was answered; then waits
/// for a first reading of INS, sonars and scanner. What the server does not answer is taken from the stock robot, with
/// a warning. Owned by one behavior; stepped once a tick.
class LaunchChecklist {
public:
    LaunchState step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port);
    const SensorLayout& layout() const { return layout_; }
    /// The robot's configuration was answered for, one way or the other; then all geometry and limits; then there was
    /// a first reading of every sensor.
    bool configurationKnown() const { return question_ > 0; }
    bool geometryKnown() const;
    bool ready() const { return ready_; }
    /// What is waited for, or what failed: "waiting for sonar geometry".
    const std::string& words() const { return words_; }

private:
    bool answered(modules::RobotModules& robot, agent::CommandPort& port);
    std::string missingSensor(const modules::RobotModules& robot) const;

    SensorLayout layout_ = stockLayout();
    std::size_t question_ = 0;
    std::optional<Seconds> asked_all_;
    bool ready_ = false;
    std::string words_ = "starting";
};

} // namespace usar::airrobot
