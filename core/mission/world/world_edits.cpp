#include "core/mission/world/world_edits.h"

#include <algorithm>
#include <cmath>

namespace usar::mission {

namespace {

constexpr double drop_height_m = 0.02;

Vec2 placeOf(const Pose& pose) {
    return pose.position_m.head<2>();
}

} // namespace

double groundHeight_m(const GroundSources& sources, const Vec2& at_m) {
    if (sources.terrain_m)
        if (const auto height_m = sources.terrain_m(at_m))
            return *height_m;
    if (sources.tiles)
        if (const auto probe = mapping::probeHeight(*sources.tiles, sources.cell_size_m, at_m))
            return double(probe->height_m);
    const auto nearest = std::ranges::min_element(sources.start_poses, {}, [&](const protocol::StartPose& pose) {
        return (placeOf(pose.pose_in_map) - at_m).norm();
    });
    return nearest == sources.start_poses.end() ? 0.0 : nearest->pose_in_map.position_m.z();
}

protocol::Token tokenOf(const std::string& name) {
    return protocol::Token::make(name).value_or(protocol::Token("unnamed"));
}

Result<protocol::CreateObject> placed(const NewObject& object, const Vec2& at_m, double ground_m) {
    const auto class_name = protocol::Token::make(object.class_name);
    if (!class_name)
        return tl::unexpected(class_name.error());
    protocol::CreateObject created{*class_name};
    created.object_name = protocol::Name::mended(object.name);
    const double rise_m = object.size_m.z() / 2.0 + (object.conveyor ? 0.0 : drop_height_m);
    created.start = Pose{Vec3(at_m.x(), at_m.y(), ground_m + rise_m)};
    if (!object.scale.isApprox(Vec3::Ones()))
        created.scale = object.scale;
    return created;
}

Pose movedTo(const Pose& body_in_map, const Vec2& center_m, const GroundHeight& ground) {
    Pose moved = body_in_map;
    moved.position_m.z() += ground(center_m) - ground(placeOf(body_in_map));
    moved.position_m.head<2>() = center_m;
    return moved;
}

Vec3 waypointAt(const Pose& body_in_map, const Vec2& at_m, const GroundHeight& ground) {
    const double over_ground_m = body_in_map.position_m.z() - ground(placeOf(body_in_map));
    return {at_m.x(), at_m.y(), ground(at_m) + over_ground_m};
}

protocol::Command motionOf(const std::string& name, bool is_conveyor, bool has_way, const Motion& motion) {
    if (is_conveyor && !has_way)
        return protocol::RunConveyor{tokenOf(name), motion.moving ? motion.speed_m_s : 0.0};
    return protocol::FollowWaypoints{
        tokenOf(name), protocol::WaypointSpeed{std::abs(motion.speed_m_s)}, motion.loop, {}, motion.moving};
}

} // namespace usar::mission
