// Who holds a robot's reins, as a session tells it: nobody, a behavior, or a person's hand.
#pragma once

#include <optional>
#include <string>

#include "core/mission/drive_limits.h"

namespace usar::mission {

enum class Reins { Nobody, Behavior, Hand };

/// What a person holds.
enum class HandSource { Keys, Pad, Gamepad };

/// What a hand asks now; said again and again while it asks for anything.
struct HandIntent {
    HandSource source = HandSource::Keys;
    std::string device{}; ///< a gamepad's name
    Stick stick{};
    double speed_share = 1.0; ///< 0..1 of the robot's most
    bool operator==(const HandIntent&) const = default;
};

/// A value, new with every update of a session.
struct ControlState {
    Reins reins = Reins::Nobody;
    std::string behavior_id{};        ///< of the one that runs; under a hand it is paused
    std::optional<HandSource> held{}; ///< what moves the robot now; absent: nothing does
    std::string device{};             ///< of `held`
    DriveStyle style = DriveStyle::Unknown;
    StickAxes axes{};
    bool learning = false;   ///< asked how it is driven; no answer yet
    std::string hindrance{}; ///< why no hand can drive it; a sentence, or empty
    std::optional<double> top_speed_m_s{};
    Stick asked{};           ///< by the hand
    Stick sent{};            ///< what is on its way to the wheels
    std::string last_stop{}; ///< why the last hold ended: "the key was let go"
    bool operator==(const ControlState&) const = default;
};

/// "keys", "pad", "gamepad".
std::string wordOf(HandSource source);

} // namespace usar::mission
