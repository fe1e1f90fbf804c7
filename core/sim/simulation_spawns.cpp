// Spawning in a simulation: names, places that are refused, and what the log says of it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/sim/simulation_state.h"

namespace usar::sim {

namespace {

/// As a client writes the point.
std::string onWire(const Vec2& point_m) {
    return fixed(point_m.x(), 2) + "," + fixed(-point_m.y(), 2);
}

} // namespace

std::pair<std::string, std::string> Simulation::State::nameOf(ClientId client, const protocol::Init& init) const {
    const auto taken = [&](std::string_view name) {
        return std::ranges::any_of(sessions, [&](const auto& one) {
            const bool is_named = one.second.robot() || one.second.stationInMap();
            return one.first != client && is_named && sameWord(one.second.robotName(), name);
        });
    };
    std::string name = init.robot_name;
    if (!name.empty() && !taken(name))
        return {name, {}};
    const std::string stem = name.empty() ? std::string(withoutPackage(init.class_name.text())) : name;
    int number = name.empty() ? 0 : 1;
    do {
        name = stem + "_" + std::to_string(++number);
    } while (taken(name));
    return {name, init.robot_name.empty() ? "INIT has no Name" : "there is a '" + stem + "' already"};
}

std::string Simulation::State::nearestThing(ClientId client, const Vec3& point_in_map_m) const {
    std::string nearest = "something";
    double nearest_m = std::numeric_limits<double>::infinity();
    const auto consider = [&](const std::string& what, const Vec3& at_m) {
        const double away_m = (at_m - point_in_map_m).norm();
        if (away_m < nearest_m)
            nearest = what;
        nearest_m = std::min(nearest_m, away_m);
    };
    for (const auto& [id, session] : sessions)
        if (session.robot() && id != client)
            consider("robot '" + session.robotName() + "'", session.robot()->figures().base_in_map.position_m);
    for (const SceneObject& object : scene.objects)
        consider("'" + object.name + "'", object.body_in_map.position_m);
    return nearest;
}

std::optional<std::string> Simulation::State::refusalOf(const Pose& start_in_map) const {
    const Vec3& at_m = start_in_map.position_m;
    if (!at_m.allFinite() || !std::isfinite(start_in_map.yaw_rad))
        return "its pose is not made of numbers";
    const Rectangle extent = extentOf(world);
    if (!extent.contains(at_m.head<2>()))
        return "it is beside the world, which reaches from " + onWire({extent.min_m.x(), extent.max_m.y()}) + " to " +
               onWire({extent.max_m.x(), extent.min_m.y()}) + " m";
    if (caster.onRoof(at_m))
        return "it is above the ceiling";
    if (!isNear(world, at_m))
        return "it is more than 1 km above or below the world";
    return std::nullopt;
}

std::optional<Pose> Simulation::State::stationAt(ClientId client, const protocol::Init& init, const std::string& why) {
    const Pose station_in_map = startOf(client, init);
    if (!isNear(world, station_in_map.position_m)) {
        log(client, "refused the place of '" + init.robot_name.text() + "': it is more than 1 km outside the world");
        return std::nullopt;
    }
    if (!why.empty())
        log(client, "this station is called '" + init.robot_name.text() + "': " + why);
    return station_in_map;
}

std::unique_ptr<Robot> Simulation::State::spawn(ClientId client, const protocol::Init& init, const std::string& why) {
    const RobotOptions robot{.base_in_map = startOf(client, init),
                             .seed = options.seed,
                             .number = spawned,
                             .battery_life = options.battery_life,
                             .scan_interval = options.tick,
                             .noise = options.noise,
                             .profile = options.profile};
    const RobotModel* const model = options.robots ? findRobot(*options.robots, init.class_name.text()) : nullptr;
    if (!model) {
        log(client, "unknown robot class '" + init.class_name.text() + "'; known here are " + knownClasses());
        return nullptr;
    }
    if (const auto refusal = refusalOf(robot.base_in_map)) {
        log(client, "refused the start of '" + init.robot_name.text() + "': " + *refusal);
        return nullptr;
    }
    auto spawned_robot = Robot::spawn(*model, {world, caster, *physics, scene}, robot);
    if (!spawned_robot) {
        log(client, spawned_robot.error().text());
        return nullptr;
    }
    ++spawned;
    const Vec3 at_m = (*spawned_robot)->figures().base_in_map.position_m;
    const Vec3& wanted_m = robot.base_in_map.position_m;
    const bool beside = (at_m - wanted_m).head<2>().norm() > 0.5;
    const bool stands_in = !sameWord(withoutPackage(init.class_name.text()), model->class_name);
    log(client, "spawned " + init.class_name.text() + " '" + init.robot_name.text() +
                    (beside ? "' beside the wanted place, where " + nearestThing(client, wanted_m) + " is" : "'") +
                    (stands_in ? "; it has the body of a " + model->class_name : "") +
                    (why.empty() ? "" : "; it is called so because " + why));
    return std::move(*spawned_robot);
}

std::string Simulation::State::knownClasses() const {
    const bool some = options.robots && !options.robots->empty();
    return some ? listOf(*options.robots, &RobotModel::class_name) : "none";
}

Pose Simulation::State::startOf(ClientId client, const protocol::Init& init) {
    const auto* const name = std::get_if<protocol::Token>(&init.start);
    if (!name)
        return std::get<Pose>(init.start);
    if (const Pose* const start = findStart(world, *name))
        return *start;
    log(client, "there is no start pose '" + name->text() + "'");
    return init.fallback_in_map.value_or(Pose{});
}

} // namespace usar::sim
