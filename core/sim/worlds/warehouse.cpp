#include "core/sim/worlds/made_worlds.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/sim/world/object_kinds.h"
#include "core/sim/worlds/building.h"

namespace usar::sim {

namespace {

constexpr double half_length_m = 20.0;
constexpr double half_width_m = 15.0;
constexpr double height_m = 9.0;
constexpr double partition_x_m = 10.0;
constexpr double partition_m = 0.25;
constexpr double door_m = 3.0;
constexpr double door_height_m = 4.0;

constexpr double mezzanine_edge_x_m = -13.0;
constexpr double floor_m = 0.25; ///< thickness of the mezzanine
constexpr double ramp_rad = radians(10.0);
constexpr double ramp_m = 0.2; ///< thickness
constexpr double ramp_width_m = 2.4;
constexpr double dock_m = 1.0; ///< height of the loading dock
constexpr double dock_x_m = 16.5;
constexpr double dock_y_m = 3.0;

constexpr double post_m = 0.1;
constexpr double shelf_depth_m = 1.0;
constexpr double shelf_m = 0.1; ///< thickness
constexpr double bay_m = 2.7;
constexpr int bays = 5;
constexpr double racks_from_x_m = -10.4;
constexpr double cross_aisle_m = 3.0;
constexpr double pallet_m = 0.144;

/// The wall between the hall and the dock, with two doorways in it.
void buildPartition(World& world, Random& random) {
    const double south_m = between(random, -9.0, -4.0);
    const double north_m = between(random, 4.0, 8.0);
    double from_m = -half_width_m;
    const auto add = [&](double low_y, double high_y, double low_z) {
        world.boxes.push_back(
            block({partition_x_m, low_y, low_z}, {partition_x_m + partition_m, high_y, height_m + 0.1}));
    };
    for (const double door_y : {south_m, north_m}) {
        add(from_m, door_y - door_m / 2.0, 0.0);
        add(door_y - door_m / 2.0, door_y + door_m / 2.0, door_height_m);
        from_m = door_y + door_m / 2.0;
    }
    add(from_m, half_width_m, 0.0);
}

/// A curb that stops wheels, a rail 1 m above it, and posts between them.
void buildRailing(World& world, const Vec3& from_m, const Vec3& to_m) {
    constexpr double bar_m = 0.06;
    const Vec3 curb_m(0.0, 0.0, bar_m);
    const Vec3 rail_m(0.0, 0.0, 1.0);
    world.boxes.push_back(beam(from_m + curb_m, to_m + curb_m, bar_m, 2.0 * bar_m));
    world.boxes.push_back(beam(from_m + rail_m, to_m + rail_m, bar_m, bar_m));
    const int gaps = static_cast<int>(std::ceil((to_m - from_m).norm() / 3.0));
    for (int post = 0; post <= gaps; ++post) {
        const Vec3 foot_m = from_m + post / static_cast<double>(gaps) * (to_m - from_m);
        const Vec3 half_m(bar_m / 2.0, bar_m / 2.0, 0.0);
        world.boxes.push_back(block(foot_m - half_m, foot_m + rail_m + half_m));
    }
}

void buildMezzanine(World& world) {
    constexpr double x = mezzanine_edge_x_m;
    constexpr double z = mezzanine_m;
    world.boxes.push_back(block({-half_length_m, -half_width_m, z - floor_m}, {x, half_width_m, z}));
    for (const double y : {-12.0, -4.0, 4.0, 12.0})
        world.boxes.push_back(block({x - 0.5, y - 0.15, 0.0}, {x - 0.2, y + 0.15, z - floor_m}));
    const double ramp_y_m = -half_width_m + ramp_width_m / 2.0;
    const double run_m = z / std::tan(ramp_rad);
    // The upper end reaches into the floor, so that no gap is left at the edge.
    world.boxes.push_back(slab({x + run_m, ramp_y_m, 0.0}, {x, ramp_y_m, z}, ramp_width_m, ramp_m));
    for (const double share : {0.35, 0.65, 0.9})
        world.boxes.push_back(
            block({x + (1.0 - share) * run_m - 0.1, -half_width_m, 0.0},
                  {x + (1.0 - share) * run_m + 0.1, -half_width_m + ramp_width_m, share * z - 1.1 * ramp_m}));
    const double side_y_m = -half_width_m + ramp_width_m - 0.03;
    buildRailing(world, {x + 0.85 * run_m, side_y_m, 0.15 * z}, {x, side_y_m, z});
    buildRailing(world, {x - 0.03, side_y_m, z}, {x - 0.03, half_width_m, z});
    // An office in the corner.
    world.boxes.push_back(block({-half_length_m, 11.0, z}, {-16.0, half_width_m, z + 2.6}));
}

void buildDock(World& world) {
    world.boxes.push_back(block({dock_x_m, dock_y_m, 0.0}, {half_length_m, half_width_m, dock_m}));
    const double run_m = dock_m / std::tan(ramp_rad);
    const double x = dock_x_m + ramp_width_m / 2.0;
    world.boxes.push_back(slab({x, dock_y_m - run_m, 0.0}, {x, dock_y_m, dock_m}, ramp_width_m, ramp_m));
}

/// Builds racks one bay after the other, with goods on the floor and on three shelves.
class RackBuilder {
public:
    RackBuilder(World& world, Random& random) : world_(world), random_(random) {}

    /// `y_m` is the middle of the row. The cross aisle comes after `bays_before` of its bays.
    void row(double y_m, int bays_before) {
        y_m_ = y_m;
        step_m_ = between(random_, 1.4, 1.75);
        const double split_m = racks_from_x_m + bays_before * (bay_m + post_m) + post_m;
        rack(racks_from_x_m, bays_before);
        rack(split_m + cross_aisle_m, bays - bays_before);
    }

private:
    void rack(double from_x_m, int count) {
        const double end_x_m = from_x_m + count * (bay_m + post_m) + post_m;
        for (int level = 1; level <= 3; ++level)
            add(from_x_m, end_x_m, {-shelf_depth_m / 2.0, shelf_depth_m / 2.0}, shelfTop_m(level) - shelf_m, shelf_m);
        for (int frame = 0; frame <= count; ++frame) {
            const double x_m = from_x_m + frame * (bay_m + post_m);
            for (const double face_m : {-shelf_depth_m / 2.0 - post_m, shelf_depth_m / 2.0})
                add(x_m, x_m + post_m, {face_m, face_m + post_m}, 0.0, shelfTop_m(3) + 0.1);
        }
        for (int bay = 0; bay < count; ++bay)
            for (int level = 0; level <= 3; ++level)
                for (const double place_m : {0.25, 0.75})
                    goods(from_x_m + post_m + bay * (bay_m + post_m) + place_m * bay_m, shelfTop_m(level));
    }

    /// Something on a pallet, or nothing.
    void goods(double x_m, double z_m) {
        if (uniform(random_, 0.0, 1.0) < 0.4)
            return;
        const double half_m = between(random_, 0.4, 0.6);
        const double depth_m = between(random_, 0.35, 0.48);
        const double high_m = between(random_, 0.4, step_m_ - shelf_m - 0.25);
        add(x_m - half_m, x_m + half_m, {-depth_m, depth_m}, z_m, high_m);
    }

    double shelfTop_m(int level) const { return wholeMillimetres(level * step_m_); }

    void add(double from_x_m, double to_x_m, const Vec2& across_m, double z_m, double high_m) {
        world_.boxes.push_back(
            block({from_x_m, y_m_ + across_m.x(), z_m}, {to_x_m, y_m_ + across_m.y(), z_m + high_m}));
    }

    World& world_;
    Random& random_;
    double y_m_ = 0.0;
    double step_m_ = 1.5; ///< from shelf to shelf
};

/// A pallet with goods on it.
void placePallet(World& world, Random& random, const Vec2& at_m, double z_m) {
    const Vec3 center_m(at_m.x(), at_m.y(), z_m);
    world.boxes.push_back(block(center_m - Vec3(0.6, 0.4, 0.0), center_m + Vec3(0.6, 0.4, pallet_m)));
    if (uniform(random, 0.0, 1.0) < 0.3)
        return;
    const Vec3 half_m{between(random, 0.4, 0.58), between(random, 0.3, 0.39), 0.0};
    const Vec3 top_m(0.0, 0.0, pallet_m + between(random, 0.3, 1.4));
    world.boxes.push_back(block(center_m - half_m + Vec3(0.0, 0.0, pallet_m), center_m + half_m + top_m));
}

void placePallets(World& world, Random& random) {
    for (const double x : {12.5, 15.0, 17.5})
        for (const double y : {-13.5, -11.5, -9.5, -7.5})
            if (uniform(random, 0.0, 1.0) < 0.75)
                placePallet(world, random, {x + between(random, -0.3, 0.3), y + between(random, -0.3, 0.3)}, 0.0);
    for (const double y : {6.0, 9.0, 12.0})
        placePallet(world, random, {18.8, y + between(random, -0.4, 0.4)}, dock_m);
    for (const double y : {-9.0, -1.0, 7.0}) {
        placePallet(world, random, {-17.0 + between(random, -1.5, 1.5), y}, 0.0);
        placePallet(world, random, {-18.8, y + between(random, -1.0, 1.0)}, mezzanine_m);
    }
}

/// Things that a robot can push, in the room of the dock and under the mezzanine.
void placeLooseThings(World& world, Random& random) {
    int number = 0;
    const auto place = [&](const char* class_name, const Vec3& foot_m) {
        const ObjectKind& kind = *findObjectKind(class_name);
        world.objects.push_back({.name = std::string(kind.name) + std::to_string(++number),
                                 .class_name = class_name,
                                 .body = bodyOf(kind, Vec3::Ones()),
                                 .body_in_map = {.position_m = foot_m + Vec3(0.0, 0.0, kind.size_m.z() / 2.0),
                                                 .yaw_rad = between(random, -pi, pi)}});
    };
    for (const double y : {10.0, 12.0, 13.8})
        place("USARPhysObj.Barrel", {11.2 + between(random, 0.0, 0.4), y, 0.0});
    place("USARPhysObj.Crate", {14.6, 12.5, 0.0});
    place("USARPhysObj.Crate", {14.6, 10.4, 0.0});
    place("USARPhysObj.Box", {14.6, 10.4, 1.0});
    for (const double y : {-5.0, 2.5, 10.0})
        place("USARPhysObj.Box", {-15.2 + between(random, -0.5, 0.5), y, 0.0});
}

} // namespace

World makeWarehouse(std::uint64_t seed) {
    Random random = seeded(seed, 8);
    World world;
    world.name = "warehouse";
    buildHall(world, {2.0 * half_length_m, 2.0 * half_width_m, height_m});
    buildPartition(world, random);
    buildMezzanine(world);
    buildDock(world);
    const int bays_before = uniform(random, 0.0, 1.0) < 0.5 ? 2 : 3;
    RackBuilder racks(world, random);
    for (const double y : {-9.0, -4.5, 0.0, 4.5, 9.0, 13.9})
        racks.row(y, bays_before);
    placePallets(world, random);
    placeLooseThings(world, random);
    addStarts(world, {{"PlayerStart", {13.2, 0.5}, pi / 2.0},
                      {"MainLane", {8.4, 0.0}, pi / 2.0},
                      {"Aisle", {-5.0, 2.25}, 0.0},
                      {"RampFoot", {8.4, -13.5}, pi}});
    world.start_poses.push_back(startOver({"Mezzanine", {-16.0, 3.0}, -pi / 2.0}, mezzanine_m));
    return world;
}

} // namespace usar::sim
