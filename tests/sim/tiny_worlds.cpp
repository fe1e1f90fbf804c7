#include "tests/sim/tiny_worlds.h"

#include <cmath>

namespace usar::sim {

World groundOf(const std::function<double(const Vec2&)>& height_m) {
    constexpr std::size_t posts = 129;
    constexpr double step_m = 0.5;
    const Vec2 origin_m(-32.0, -32.0);
    std::vector<float> heights_m;
    for (std::size_t row = 0; row < posts; ++row)
        for (std::size_t column = 0; column < posts; ++column)
            heights_m.push_back(static_cast<float>(
                height_m(origin_m + step_m * Vec2(static_cast<double>(column), static_cast<double>(row)))));
    World world;
    world.name = "tiny";
    world.terrain = Terrain(posts, posts, step_m, origin_m, std::move(heights_m));
    return world;
}

World flatWorld() {
    return groundOf([](const Vec2&) { return 0.0; });
}

World lake() {
    World world = flatWorld();
    world.water = Water{30.0, 1000.0};
    return world;
}

World slopeWorld(double slope_rad) {
    return groundOf([=](const Vec2& point_m) { return std::tan(slope_rad) * point_m.x(); });
}

BodyDescription airRobotBody() {
    constexpr double leg_radius_m = 0.02;
    constexpr double leg_top_m = -0.03;
    constexpr double leg_low_m = -0.21 + leg_radius_m;
    const AirRobotParameters parameters;
    BodyDescription body{.mass_kg = parameters.mass_kg, .inertia_kg_m2 = parameters.inertia_kg_m2};
    body.parts = {{CylinderShape{0.4995, parameters.ring_height_m}, {}},
                  {BoxShape{{parameters.pod_width_m, 0.20, 0.09}}, {.position_m = {0.0, 0.0, -0.10 + 0.09 / 2.0}}}};
    for (const Vec3& rotor_m : rotorCenters(parameters)) {
        const Vec2 foot_m = rotor_m.head<2>() / parameters.rotor_span_m * 0.25;
        body.parts.push_back({CapsuleShape{leg_radius_m, leg_top_m - leg_low_m},
                              {.position_m = {foot_m.x(), foot_m.y(), (leg_top_m + leg_low_m) / 2.0}}});
    }
    return body;
}

Flight::Flight(World world_, const FlightStart& start)
    : world(std::move(world_))
    , physics(makePhysics(world))
    , robot(*physics, physics->add(airRobotBody(), start.base_in_map), start.near_ground) {}

void Flight::run(Seconds duration, const std::function<void(Seconds)>& each) {
    const long steps = std::lround(duration / physics_dt);
    for (long i = 1; i <= steps; ++i) {
        robot.beforeStep(physics_dt);
        physics->step(physics_dt);
        robot.afterStep(physics_dt);
        if (each)
            each(static_cast<double>(i) * physics_dt);
    }
}

void Flight::drive(double forward_m_s, double left_m_s, double climb_m_s, double yaw_rate_rad_s) {
    robot.obey(protocol::Command(protocol::AerialDrive{climb_m_s, forward_m_s, left_m_s, yaw_rate_rad_s, false}));
}

bool Flight::atRest() const {
    return robot.idle() && velocity_m_s().norm() < 0.01 && robot.state().rate_rad_s.norm() < 0.01;
}

FlightStart inTheAir(const Vec3& position_m) {
    return {{.position_m = position_m}};
}

FlightStart onTheGround(const Vec3& ground_m) {
    return {{.position_m = ground_m + Vec3(0.0, 0.0, 0.35)}, true};
}

} // namespace usar::sim
