// What is counted and measured about a robot for viewers other than the wire.
#pragma once

#include <optional>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::sim {

/// Height of the base's origin above the ground straight below it, in meters.
struct HeightFigures {
    double least_m = 0.0;
    double mean_m = 0.0;
    double spread_m = 0.0; ///< standard deviation
};

/// Ground truth about a robot. Behaviors never see it.
struct RobotFigures {
    Pose base_in_map;
    Vec3 velocity_in_map_m_s = Vec3::Zero();
    /// The robot was damaged so badly that it can no longer move.
    bool broken = false;
    Seconds powered_for{0.0}; ///< since its battery was empty or a rotor weak; since the spawn if none ever was
    int collisions = 0;
    double distance_m = 0.0;               ///< length of the path it actually traveled
    Seconds longest_stay{0.0};             ///< see StayWatch in robot_watches.h
    int falls = 0;                         ///< see FallWatch
    int touches = 0;                       ///< how often it touched an object or another robot; see CollisionCounter
    std::optional<Seconds> first_touch{};  ///< since the spawn; nullopt before it
    std::optional<HeightFigures> height{}; ///< submarines only, since they first went under water
    std::vector<Vec3> collision_places_in_map_m{}; ///< see CollisionPlaces
};

} // namespace usar::sim
