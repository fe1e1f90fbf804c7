#include "core/sim/worlds/made_worlds.h"

#include "core/sim/world/object_kinds.h"
#include "core/sim/worlds/building.h"

namespace usar::sim {

namespace {

constexpr double half_length_m = 20.0;
constexpr double half_width_m = 12.5;
constexpr double height_m = 6.0;
constexpr double shelf_length_m = 6.0;
constexpr double shelf_depth_m = 1.0;
constexpr double board_m = 0.04;

void buildPillars(World& world) {
    for (const double x : {-12.0, 0.0, 12.0})
        for (const double y : {-6.0, 6.0})
            world.boxes.push_back(block({x - 0.3, y - 0.3, 0.0}, {x + 0.3, y + 0.3, height_m}));
}

/// Adds four boards between two sides, along x or y, with a carton on some of them.
void buildShelf(World& world, Random& random, const Vec2& center_m, bool along_x) {
    const double top_m = between(random, 2.4, 4.4);
    const auto add = [&](double from, double to, double low_m, double high_m, double depth_m) {
        const Vec2 low = along_x ? Vec2(from, -depth_m / 2.0) : Vec2(-depth_m / 2.0, from);
        const Vec2 high = along_x ? Vec2(to, depth_m / 2.0) : Vec2(depth_m / 2.0, to);
        world.boxes.push_back(block({center_m.x() + low.x(), center_m.y() + low.y(), low_m},
                                    {center_m.x() + high.x(), center_m.y() + high.y(), high_m}));
    };
    constexpr double end_m = shelf_length_m / 2.0;
    add(-end_m, -end_m + board_m, 0.0, top_m, shelf_depth_m);
    add(end_m - board_m, end_m, 0.0, top_m, shelf_depth_m);
    for (int board = 0; board < 4; ++board) {
        const double z_m = wholeMillimetres(0.1 + board * (top_m - 0.1 - board_m) / 3.0);
        add(-end_m, end_m, z_m, z_m + board_m, shelf_depth_m);
        if (board == 3 || uniform(random, 0.0, 1.0) < 0.3)
            continue;
        const double at_m = between(random, -end_m + 0.6, end_m - 0.6);
        const double half_m = between(random, 0.2, 0.5);
        add(at_m - half_m, at_m + half_m, z_m + board_m, z_m + board_m + between(random, 0.2, 0.5), 0.7);
    }
}

void buildShelves(World& world, Random& random) {
    for (const double x : {-15.0, -5.0, 5.0, 15.0})
        buildShelf(world, random, {x, half_width_m - 0.6}, true);
    for (const double x : {-14.0, -6.0, 6.0, 14.0})
        buildShelf(world, random, {x, -9.0}, true);
    buildShelf(world, random, {-half_length_m + 0.6, 0.0}, false);
}

void placeSigns(World& world) {
    world.rfid_tags = {{1001, "entrance", {19.9, 0.0, 1.5}},      {1002, "pillar", {0.0, -5.6, 1.2}},
                       {1003, "north aisle", {-12.0, 5.6, 1.2}},  {1004, "south aisle", {0.0, -12.4, 1.5}},
                       {1005, "behind shelf", {14.0, -9.6, 1.0}}, {1006, "west", {-19.3, 4.0, 1.0}}};
    world.victims = {{"Becky",
                      "Calm",
                      {{VictimPartKind::Head, {6.0, -11.5, 0.2}},
                       {VictimPartKind::Chest, {6.4, -11.5, 0.2}},
                       {VictimPartKind::Pelvis, {6.8, -11.5, 0.15}},
                       {VictimPartKind::Leg, {7.3, -11.4, 0.1}},
                       {VictimPartKind::Foot, {7.7, -11.4, 0.1}}}},
                     {"Sam",
                      "Unconscious",
                      {{VictimPartKind::Hand, {-17.0, 8.8, 0.1}},
                       {VictimPartKind::Arm, {-17.0, 9.2, 0.15}},
                       {VictimPartKind::Head, {-17.0, 9.7, 0.2}}}}};
    world.sounds = {{"alarm", 85.0, {19.5, 12.0, 4.0}}, {"Becky", 60.0, {6.0, -11.5, 0.2}}};
    world.gases = {{"CO2", 0.04, {6.0, -11.5, 0.2}}, {"CO2", 0.02, {-17.0, 9.7, 0.2}}};
}

/// A crate that a robot with a gripper can lift, in a corner where nothing else is.
void placeCrate(World& world) {
    constexpr const char* crate_class = "USARPhysObj.WCBoxLarge";
    const ObjectKind& kind = *findObjectKind(crate_class);
    world.objects = {{.name = "Crate1",
                      .class_name = crate_class,
                      .body = bodyOf(kind, Vec3::Ones()),
                      .body_in_map = {.position_m = {17.0, 4.0, kind.size_m.z() / 2.0}}}};
}

} // namespace

World makeVmacRoom(std::uint64_t seed) {
    Random random = seeded(seed, 7);
    World world;
    world.name = "vmac_room";
    buildHall(world, {2.0 * half_length_m, 2.0 * half_width_m, height_m});
    buildPillars(world);
    buildShelves(world, random);
    placeSigns(world);
    placeCrate(world);
    addStarts(world, {{"PlayerStart", {0.0, 0.0}, 0.0},
                      {"West", {-16.0, 0.0}, 0.0},
                      {"East", {16.0, 0.0}, pi},
                      {"NorthAisle", {-6.0, 6.0}, 0.0},
                      {"BetweenShelves", {0.0, -9.0}, pi / 2.0}});
    return world;
}

} // namespace usar::sim
