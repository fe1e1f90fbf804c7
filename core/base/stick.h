// The operator's manual control input, from the keyboard, an on-screen pad or a gamepad alike.
#pragma once

#include <algorithm>
#include <cmath>

namespace usar {

/// Requested speeds as fractions of the robot's maximum, -1..1, in the robot's frame: forward, left, counterclockwise
/// and up are positive. All zero means that the operator has let go. Plain data, so that every layer between a key and
/// a DRIVE can carry it.
struct Stick {
    double forward = 0.0;
    double left = 0.0; ///< sideways, for robots that can move so
    double turn = 0.0; ///< about the vertical axis
    double up = 0.0;   ///< climb, for robots that can

    bool centered() const { return *this == Stick{}; }
    bool operator==(const Stick&) const = default;
};

/// The same input with each fraction limited to -1..1; NaN becomes 0.
inline Stick clamped(const Stick& stick) {
    const auto cut = [](double share) { return share == share ? std::clamp(share, -1.0, 1.0) : 0.0; };
    return {cut(stick.forward), cut(stick.left), cut(stick.turn), cut(stick.up)};
}

/// Within `zone` (0..1) both axes become 0; outside it they grow from 0 to the full share, so that nothing jumps. Both
/// axes of one stick are judged together, so a stick that is pushed straight ahead keeps its slight turn.
inline void applyDeadZone(double& x, double& y, double zone) {
    const double reach = std::hypot(x, y);
    if (!(reach > zone)) {
        x = y = 0.0;
        return;
    }
    const double grown = std::min(1.0, (reach - zone) / (1.0 - zone)) / reach;
    x *= grown;
    y *= grown;
}

/// The axes of a Stick that a robot can follow.
struct StickAxes {
    bool forward = false;
    bool left = false;
    bool turn = false;
    bool up = false;

    bool any() const { return forward || left || turn || up; }
    bool operator==(const StickAxes&) const = default;
};

/// The same input with 0 on every axis that the robot cannot follow.
inline Stick masked(const Stick& stick, const StickAxes& axes) {
    return {axes.forward ? stick.forward : 0.0, axes.left ? stick.left : 0.0, axes.turn ? stick.turn : 0.0,
            axes.up ? stick.up : 0.0};
}

} // namespace usar
