#include "core/sim/robots/spawn_place.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double most_raise_m = 1.0;
constexpr double raise_step_m = 0.05;
/// Centers closer than this count as one place: two robots that settle there would land on each other.
constexpr double same_place_m = 1.2;
/// Distance between the centers of a robot that is put beside others and those others.
constexpr double beside_m = 1.8;
constexpr std::array rings_m{2.0, 3.0, 4.0};
constexpr int bearings = 12;
constexpr double most_step_m = 1.0; ///< change of ground height, from the wanted place to the one beside it
constexpr double sky_m = 30.0;
constexpr double body_half_width_m = 1.0;

/// A body for trying out places; removed when it goes out of scope.
class Probe {
public:
    Probe(Physics& physics, const BodyDescription& body, const Pose& pose)
        : physics_(physics)
        , id_(physics.add(body, pose)) {}
    ~Probe() { physics_.remove(id_); }
    Probe(const Probe&) = delete;
    Probe& operator=(const Probe&) = delete;

    bool stuckAt(const Pose& pose) const {
        physics_.place(id_, pose);
        return physics_.isStuck(id_);
    }
    double roomAt_m(const Vec3& position_m) const { return physics_.distanceToBodies_m(position_m, id_); }

private:
    Physics& physics_;
    BodyId id_;
};

std::optional<Pose> raised(const Probe& probe, Pose pose, double room_m) {
    const double highest_m = pose.position_m.z() + most_raise_m;
    bool stuck = probe.stuckAt(pose);
    while (stuck && pose.position_m.z() < highest_m) {
        pose.position_m.z() += raise_step_m;
        stuck = probe.stuckAt(pose);
    }
    return stuck || probe.roomAt_m(pose.position_m) < room_m ? std::nullopt : std::optional(pose);
}

/// True if nothing is above the robot's middle and its four sides, so that it can rise.
bool underOpenSky(const RayCaster& caster, const Vec3& position_m) {
    for (const Vec2& side_m : {Vec2(0.0, 0.0), Vec2(1.0, 0.0), Vec2(0.0, 1.0), Vec2(-1.0, 0.0), Vec2(0.0, -1.0)}) {
        const Vec3 from_m =
            position_m + Vec3(0.0, 0.0, most_raise_m) + body_half_width_m * Vec3(side_m.x(), side_m.y(), 0.0);
        if (caster.cast(from_m, Vec3::UnitZ(), sky_m) < sky_m)
            return false;
    }
    return true;
}

/// The pose moved aside by `step_m`, and kept at its height above the ground if it was near it; nullopt if there is no
/// suitable ground.
std::optional<Pose> movedAside(const RobotSurroundings& surroundings, Pose pose, const Vec2& step_m) {
    const double height_m = heightOverGround_m(surroundings, pose.position_m);
    pose.position_m.head<2>() += step_m;
    if (height_m >= near_ground_m)
        return pose;
    const Vec3 over_m = pose.position_m + Vec3(0.0, 0.0, most_step_m);
    const double reach_m = height_m + 2.0 * most_step_m;
    const double down_m = surroundings.caster.cast(over_m, -Vec3::UnitZ(), reach_m);
    if (down_m <= 0.0 || down_m >= reach_m)
        return std::nullopt; // There is a cliff, a wall, or the end of the world.
    pose.position_m.z() = over_m.z() - down_m + height_m;
    return pose;
}

std::optional<Pose> beside(const RobotSurroundings& surroundings, const Probe& probe, const Pose& wanted) {
    const bool open = underOpenSky(surroundings.caster, wanted.position_m);
    for (const double ring_m : rings_m) {
        for (int i = 0; i < bearings; ++i) {
            // The left side comes first.
            const double bearing_rad = wanted.yaw_rad + pi / 2.0 + 2.0 * pi * i / bearings;
            const auto pose =
                movedAside(surroundings, wanted, ring_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad)));
            if (!pose || (open && !underOpenSky(surroundings.caster, pose->position_m)))
                continue;
            if (const auto free = raised(probe, *pose, beside_m))
                return free;
        }
    }
    return std::nullopt;
}

} // namespace

double heightOverGround_m(const RobotSurroundings& surroundings, const Vec3& position_m) {
    return surroundings.caster.cast(position_m, -Vec3::UnitZ(), 2.0 * near_ground_m);
}

std::optional<Pose> freePose(const RobotSurroundings& surroundings, const BodyDescription& body, const Pose& wanted) {
    const Pose level{wanted.position_m, 0.0, 0.0, wanted.yaw_rad};
    const Probe probe(surroundings.physics, body, level);
    if (probe.roomAt_m(level.position_m) < same_place_m)
        return beside(surroundings, probe, level);
    return raised(probe, level, same_place_m);
}

} // namespace usar::sim
