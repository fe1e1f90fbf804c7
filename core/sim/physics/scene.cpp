#include "core/sim/physics/scene.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/alternatives.h"

namespace usar::sim {

namespace {

Vec3 halfSizeOf(const Shape& shape) {
    return std::visit(
        Overloaded{
            [](const CylinderShape& rod) { return Vec3(rod.radius_m, rod.radius_m, rod.height_m / 2.0); },
            [](const CapsuleShape& rod) { return Vec3(rod.radius_m, rod.radius_m, rod.height_m / 2.0 + rod.radius_m); },
            [](const BoxShape& box) { return Vec3(box.size_m / 2.0); },
            [](const SphereShape& ball) { return Vec3(Vec3::Constant(ball.radius_m)); }},
        shape);
}

/// Bounding box of all parts along the body's axes; it includes the body's origin.
Eigen::AlignedBox3d boundsOf(const BodyDescription& body) {
    Eigen::AlignedBox3d bounds(Vec3::Zero().eval());
    for (const BodyPart& part : body.parts) {
        const Vec3 half_m = halfSizeOf(part.shape);
        const Vec3 reach_m = part.part_in_body.isometry().linear().cwiseAbs() * half_m;
        bounds.extend(part.part_in_body.position_m - reach_m);
        bounds.extend(part.part_in_body.position_m + reach_m);
    }
    return bounds;
}

void turn(SceneObject& object, double dt_s) {
    object.body_in_map.roll_rad = normalizedAngle(object.body_in_map.roll_rad + object.motion.spin_rad_s.x() * dt_s);
    object.body_in_map.pitch_rad = normalizedAngle(object.body_in_map.pitch_rad + object.motion.spin_rad_s.y() * dt_s);
    object.body_in_map.yaw_rad = normalizedAngle(object.body_in_map.yaw_rad + object.motion.spin_rad_s.z() * dt_s);
}

void go(SceneObject& object, double dt_s) {
    ObjectMotion& motion = object.motion;
    double way_m = motion.speed_m_s * dt_s;
    while (way_m > 0.0 && motion.next_waypoint < motion.waypoints_in_map_m.size()) {
        const Vec3 left_m = motion.waypoints_in_map_m[motion.next_waypoint] - object.body_in_map.position_m;
        const double step_m = std::min(way_m, left_m.norm());
        if (left_m.norm() > 0.0)
            object.body_in_map.position_m += step_m * left_m.normalized();
        way_m -= step_m;
        if (step_m < left_m.norm())
            return;
        ++motion.next_waypoint;
        if (motion.loop && motion.waypoints_in_map_m.size() > 1)
            motion.next_waypoint %= motion.waypoints_in_map_m.size();
    }
}

} // namespace

SceneObject& addObject(Scene& scene, Physics& physics, const WorldObject& object) {
    Eigen::AlignedBox3d bounds = boundsOf(object.body);
    if (object.belt)
        bounds.extend(boundsOf(*object.belt));
    SceneObject added{.name = object.name,
                      .class_name = object.class_name,
                      .body = physics.add(object.body, object.body_in_map),
                      .body_in_map = object.body_in_map,
                      .parts = object.body.parts,
                      .size_m = bounds.sizes(),
                      .radius_m = bounds.min().cwiseAbs().cwiseMax(bounds.max().cwiseAbs()).norm()};
    if (object.belt)
        added.belt = physics.add(*object.belt, object.body_in_map);
    physics.letSleep(added.body, true);
    return scene.objects.emplace_back(std::move(added));
}

void removeObject(const SceneObject& object, Physics& physics) {
    physics.remove(object.body);
    if (object.belt)
        physics.remove(*object.belt);
}

void placeObject(SceneObject& object, Physics& physics, const Pose& body_in_map) {
    object.body_in_map = body_in_map;
    physics.place(object.body, body_in_map);
    if (object.belt)
        physics.place(*object.belt, body_in_map);
}

void addMark(Scene& scene, TraceMark mark) {
    constexpr std::size_t kept = 20000;
    auto& marks = scene.trace_marks;
    if (marks.size() >= 2 * kept)
        marks.erase(marks.begin(), marks.begin() + kept);
    marks.push_back(std::move(mark));
}

Scene makeScene(const World& world, Physics& physics) {
    Scene scene{{}, world.rfid_tags};
    for (const WorldObject& object : world.objects)
        addObject(scene, physics, object);
    return scene;
}

void refresh(Scene& scene, const Physics& physics) {
    for (SceneObject& object : scene.objects)
        if (!physics.isAsleep(object.body))
            object.body_in_map = physics.state(object.body).pose();
}

void carryObjects(Scene& scene, Physics& physics, Seconds dt) {
    for (SceneObject& object : scene.objects) {
        if (!object.motion.carries())
            continue;
        turn(object, dt.count());
        if (object.motion.moving)
            go(object, dt.count());
        placeObject(object, physics, object.body_in_map);
    }
}

} // namespace usar::sim
