// The state of control over a robot, as reported by its session: nobody, a behavior, or the user by hand.
#pragma once

#include <optional>
#include <string>

#include "core/mission/hand/drive_limits.h"

namespace usar::mission {

/// The holder of control over a robot.
enum class Reins { Nobody, Behavior, Hand };

/// Input device for driving by hand. The pad is the one on the screen.
enum class HandSource { Keys, Pad, Gamepad };

/// The current request of one input device; repeated for as long as it requests anything.
struct HandIntent {
    HandSource source = HandSource::Keys;
    std::string device{}; ///< name of the gamepad; empty for other sources
    Stick stick{};
    double speed_share = 1.0; ///< 0..1 of the robot's top speed
    bool operator==(const HandIntent&) const = default;
};

/// State of control over a robot. A value, new with every update of a session.
struct ControlState {
    Reins reins = Reins::Nobody;
    std::string behavior_id{};        ///< id of the running behavior; it is paused while the user drives by hand
    std::optional<HandSource> held{}; ///< the source that moves the robot now; absent: none does
    std::string device{};             ///< gamepad name, if `held` is a gamepad
    DriveStyle style = DriveStyle::Unknown;
    StickAxes axes{};                      ///< the axes that the robot can follow
    bool learning = false;                 ///< the robot was asked how it is driven and has not answered yet
    std::string hindrance{};               ///< why it cannot be driven by hand; a sentence, or empty
    std::optional<double> top_speed_m_s{}; ///< over ground, at full stick; absent: unknown
    Stick asked{};                         ///< stick position of the input device
    Stick sent{};                          ///< shaped stick position, as last sent to the robot
    std::string last_stop{};               ///< why the last hold ended, such as "the key was let go"
    bool operator==(const ControlState&) const = default;
};

/// Returns "keys", "pad" or "gamepad".
std::string wordOf(HandSource source);

} // namespace usar::mission
