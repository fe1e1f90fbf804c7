// Small worlds and a robot in them, for tests of physics, robots and sensors.
#pragma once

#include <functional>
#include <memory>

#include "core/sim/drives/rotor_drive.h"
#include "core/sim/physics/physics.h"
#include "core/sim/world/world.h"

namespace usar::sim {

inline constexpr Seconds physics_dt{0.004};

/// 64 m square around the origin, posts each 0.5 m.
World groundOf(const std::function<double(const Vec2&)>& height_m);
World flatWorld();
/// Flat ground under 30 m of water.
World lake();
/// Rises along x with this angle; height 0 on the y axis.
World slopeWorld(double slope_rad);

/// Where a flight begins; near the ground the robot lands by itself.
struct FlightStart {
    Pose base_in_map;
    bool near_ground = false;
};

/// The AirRobot's ring, belly pod and four legs, which keep its rotor discs 0.2 m above the ground.
BodyDescription airRobotBody();

/// A world, its physics and one AirRobot.
struct Flight {
    explicit Flight(World world_, const FlightStart& start);

    /// Runs the robot; `each` is called after every physics step with the time since the call.
    void run(Seconds duration, const std::function<void(Seconds)>& each = {});
    void drive(double forward_m_s, double left_m_s, double climb_m_s, double yaw_rate_rad_s = 0.0);
    /// True if it stands or lies still with its motors off.
    bool atRest() const;
    Pose pose() const { return robot.state().pose(); }
    Vec3 velocity_m_s() const { return robot.state().velocity_m_s; }

    World world;
    std::unique_ptr<Physics> physics;
    RotorDrive robot;
};

/// In the air at this point, level.
FlightStart inTheAir(const Vec3& position_m);
/// Just above the ground there, going to settle.
FlightStart onTheGround(const Vec3& ground_m);

} // namespace usar::sim
