// What a person's hand asks of a robot, whatever it holds: keys, a pad on the screen, a gamepad.
#pragma once

#include <algorithm>

namespace usar {

/// Shares of the robot's most, -1..1, in the robot's frame: forward, left, counter-clockwise and up are positive. All
/// zero: the hand is off. A value; plain numbers, so that everything between a key and a DRIVE can carry it.
struct Stick {
    double forward = 0.0;
    double left = 0.0; ///< sideways, for what can move so
    double turn = 0.0;
    double up = 0.0;

    bool centered() const { return *this == Stick{}; }
    bool operator==(const Stick&) const = default;
};

/// The same hand, with each share cut to -1..1; what is no number is 0.
inline Stick clamped(const Stick& stick) {
    const auto cut = [](double share) { return share == share ? std::clamp(share, -1.0, 1.0) : 0.0; };
    return {cut(stick.forward), cut(stick.left), cut(stick.turn), cut(stick.up)};
}

/// Which of its shares a robot can follow.
struct StickAxes {
    bool forward = false;
    bool left = false;
    bool turn = false;
    bool up = false;

    bool any() const { return forward || left || turn || up; }
    bool operator==(const StickAxes&) const = default;
};

/// What the robot cannot follow is 0.
inline Stick masked(const Stick& stick, const StickAxes& axes) {
    return {axes.forward ? stick.forward : 0.0, axes.left ? stick.left : 0.0, axes.turn ? stick.turn : 0.0,
            axes.up ? stick.up : 0.0};
}

} // namespace usar
