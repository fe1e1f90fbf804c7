// The way on which a robot came, for a place from which it sees no other way.
#pragma once

#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// The scanner sees what is below the robot only when the robot is there. So it may find itself over a shelf or among
/// goods that are nearer than it goes to things, where every direction is closed, the one from which it came included.
/// This one is free all the same: the robot has just been there. Owned by one robot; places are in the map frame of its
/// estimate, so make a new one when the estimate jumps.
class WayBack {
public:
    /// Takes the place of the robot and the distance of the nearest thing that is in its way at its height. Call it
    /// once per tick in the air. Ends the way back where there is room again, or where the robot does not get on.
    void note(Seconds now, const Vec2& here_m, double nearest_m);
    /// True if the robot stands so near to something that every direction is closed.
    bool isPinned() const;
    /// True if the robot has not got on for long.
    bool stands() const;
    /// Starts to go back, to where nothing is nearer than `room_m`, but at least so far. Returns false if it has been
    /// nowhere else.
    bool begin(double room_m = roomy_m, double least_m = 0.0);
    /// The same, all the way to where the flight began, or as far as it remembers.
    bool beginWhole() { return begin(no_room_m); }
    bool active() const { return active_; }
    /// The place to steer at while it is active.
    const Vec2& aim_m() const { return trail_.back(); }

private:
    static constexpr double roomy_m = 1.75;  ///< so much room that ways are open
    static constexpr double no_room_m = 1e9; ///< There is so much nowhere.

    std::vector<Vec2> trail_; ///< where it has been, without loops; the newest last
    Vec2 here_m_ = Vec2::Zero();
    Vec2 moved_to_m_ = Vec2::Zero();
    Seconds moved_at_{0.0}; ///< when the robot came to that place, where it has been since
    Seconds now_{0.0};
    double nearest_m_ = 1e9;
    double room_m_ = roomy_m; ///< where the way back ends
    double least_m_ = 0.0;    ///< but not so near to where it began
    Vec2 began_at_m_ = Vec2::Zero();
    bool active_ = false;
};

} // namespace usar::airrobot
