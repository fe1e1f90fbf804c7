// Collects what must be known before the rotors start: the thesis's RobotLaunch (4.3).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/agent/command_port.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/flight/sensor_layout.h"

namespace usar::airrobot {

enum class LaunchState { Waiting, Ready, Failed };

/// Asks for the configuration of the robot, then for geometry and limits of the sonars and of the scanner, one after
/// the other. Then it waits for a first reading of INS, sonars and scanner. If the server does not answer a question,
/// the value of the stock robot is used, with a warning. Owned by one behavior; call `step` once per tick.
class LaunchChecklist {
public:
    /// Failed means that a sensor has sent nothing for 10 s after all questions were settled.
    LaunchState step(Seconds now, modules::RobotModules& robot, agent::CommandPort& port);
    /// The values known so far, with those of the stock robot for the rest.
    const SensorLayout& layout() const { return layout_; }
    /// Whether the question for the robot's configuration is settled, with or without an answer.
    bool configurationKnown() const { return question_ > 0; }
    /// Whether all questions are settled.
    bool geometryKnown() const { return asked_all_.has_value(); }
    /// Whether every sensor has also sent a first reading.
    bool ready() const { return ready_; }
    /// Says what it is waiting for or what failed: "waiting for Sonar geometry".
    const std::string& words() const { return words_; }
    /// The sensors that had sent nothing when it failed: "RangeScanner", "Sonar L4".
    const std::vector<std::string>& missing() const { return missing_; }

private:
    /// Continues with the questions; returns whether all are settled.
    bool answered(modules::RobotModules& robot, agent::CommandPort& port);
    /// Returns the sensors without a reading.
    std::vector<std::string> missingSensors(const modules::RobotModules& robot) const;

    SensorLayout layout_ = stockLayout();
    std::size_t question_ = 0;         ///< number of settled questions
    std::optional<Seconds> asked_all_; ///< time at which the last question was settled
    bool ready_ = false;
    std::string words_ = "starting";
    std::vector<std::string> missing_;
};

} // namespace usar::airrobot
