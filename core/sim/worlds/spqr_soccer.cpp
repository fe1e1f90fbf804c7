#include "core/sim/worlds/made_worlds.h"

#include <algorithm>

#include "core/sim/worlds/building.h"

namespace usar::sim {

namespace {

constexpr double half_length_m = 3.0;
constexpr double half_width_m = 2.0;
constexpr double board_m = 0.05;
constexpr double board_height_m = 0.1;
constexpr double goal_half_width_m = 0.4;
constexpr double goal_depth_m = 0.3;
constexpr double goal_height_m = 0.3;
constexpr double beacon_m = 0.2;
constexpr double beacon_height_m = 0.4;

void buildBoards(World& world) {
    constexpr double x = half_length_m;
    constexpr double y = half_width_m;
    for (const double side : {-y - board_m, y})
        world.boxes.push_back(block({-x - board_m, side, 0.0}, {x + board_m, side + board_m, board_height_m}));
    for (const double end : {-x - board_m, x})
        for (const double from : {-y, goal_half_width_m})
            world.boxes.push_back(
                block({end, from, 0.0}, {end + board_m, from + y - goal_half_width_m, board_height_m}));
}

/// Adds back, two sides and a roof at the gap in the boards; `end` is -1 or 1.
void buildGoal(World& world, double end) {
    constexpr double y = goal_half_width_m;
    const auto add = [&](double from_m, double to_m, double low_y, double high_y, double low_z) {
        const double a = end * (half_length_m + from_m);
        const double b = end * (half_length_m + to_m);
        world.boxes.push_back(block({std::min(a, b), low_y, low_z}, {std::max(a, b), high_y, goal_height_m + board_m}));
    };
    add(goal_depth_m, goal_depth_m + board_m, -y - board_m, y + board_m, 0.0);
    add(board_m, goal_depth_m, y, y + board_m, 0.0);
    add(board_m, goal_depth_m, -y - board_m, -y, 0.0);
    add(0.0, goal_depth_m, -y, y, goal_height_m);
}

void buildBeacons(World& world) {
    for (const double x : {-1.5, 1.5})
        for (const double y : {-half_width_m - 0.3, half_width_m + 0.3})
            world.boxes.push_back(block({x - beacon_m / 2.0, y - beacon_m / 2.0, 0.0},
                                        {x + beacon_m / 2.0, y + beacon_m / 2.0, beacon_height_m}));
}

/// A hollow plastic ball on carpet.
WorldObject ball() {
    constexpr double mass_kg = 0.06;
    return {.name = "Ball",
            .class_name = "USARModels.SoccerBall",
            .body = {.mass_kg = mass_kg,
                     .inertia_kg_m2 = Vec3::Constant(2.0 / 3.0 * mass_kg * ball_radius_m * ball_radius_m),
                     .friction = 0.6,
                     .parts = {{SphereShape{ball_radius_m}, {}}},
                     .restitution = 0.6,
                     .rolling_friction_m = 0.03 * ball_radius_m},
            .body_in_map = {.position_m = {0.0, 0.0, ball_radius_m}}};
}

} // namespace

World makeSpqrSoccer(std::uint64_t) {
    World world;
    world.name = "spqr_soccer";
    world.terrain = Terrain::level({{-6.0, -5.0}, {6.0, 5.0}}, 0.0).value();
    buildBoards(world);
    buildGoal(world, 1.0);
    buildGoal(world, -1.0);
    buildBeacons(world);
    world.objects = {ball()};
    addStarts(world, {{"PlayerStart", {-1.5, 0.0}, 0.0},
                      {"Opponent", {1.5, 0.0}, pi},
                      {"LeftWing", {-0.5, 1.2}, 0.0},
                      {"RightWing", {-0.5, -1.2}, 0.0},
                      {"BesideTheField", {0.0, -3.5}, pi / 2.0}});
    return world;
}

} // namespace usar::sim
