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

Flight::Flight(World world_, const DriveBirth& spawn)
    : world(std::move(world_))
    , physics(makePhysics(world))
    , robot(*physics, spawn) {}

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
    robot.drive({climb_m_s, forward_m_s, left_m_s, yaw_rate_rad_s, false});
}

DriveBirth inTheAir(const Vec3& position_m) {
    DriveBirth spawn;
    spawn.base_in_map.position_m = position_m;
    return spawn;
}

DriveBirth onTheGround(const Vec3& ground_m) {
    DriveBirth spawn = inTheAir(ground_m + Vec3(0.0, 0.0, 0.35));
    spawn.near_ground = true;
    return spawn;
}

} // namespace usar::sim
