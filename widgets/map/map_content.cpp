#include "widgets/map/map_content.h"

#include <algorithm>
#include <utility>

namespace usar::widgets {

namespace {

constexpr double around_start_poses_m = 20.0;

} // namespace

Rectangle MapContent::groundInMap() const {
    if (world_in_map)
        return *world_in_map;
    if (start_poses.empty())
        return {};
    const Vec2 first = start_poses.front().pose_in_map.position_m.head<2>();
    Rectangle ground{first, first};
    for (const protocol::StartPose& pose : start_poses) {
        ground.min_m = ground.min_m.cwiseMin(pose.pose_in_map.position_m.head<2>());
        ground.max_m = ground.max_m.cwiseMax(pose.pose_in_map.position_m.head<2>());
    }
    const Vec2 around(around_start_poses_m, around_start_poses_m);
    return {ground.min_m - around, ground.max_m + around};
}

void MapContent::forgetServer() {
    MapContent kept;
    kept.layers = layers;
    kept.area.editing = area.editing;
    *this = std::move(kept);
}

void MapContent::takeRobot(const MapRobot& robot) {
    RobotOnMap& on_map = robots[robot.name];
    on_map.robot = robot;
    if (!robot.stale)
        on_map.trail.add(robot.base_in_map.position_m.head<2>());
}

const MapRobot* MapContent::selectedRobot() const {
    const auto found = robots.find(selected_robot);
    return found == robots.end() ? nullptr : &found->second.robot;
}

void MapContent::setObjects(const std::vector<MapObject>& all) {
    objects.objects = all;
    if (!object(objects.selected))
        objects.selected.clear();
    if (!object(objects.held))
        objects.held.clear();
}

MapObject* MapContent::object(const QString& name) {
    return const_cast<MapObject*>(std::as_const(*this).object(name));
}

const MapObject* MapContent::object(const QString& name) const {
    const auto found = std::ranges::find(objects.objects, name, &MapObject::name);
    return found == objects.objects.end() ? nullptr : &*found;
}

const protocol::StartPose* MapContent::stepStartPose(int by) {
    const int count = static_cast<int>(start_poses.size());
    if (count == 0)
        return nullptr;
    const int from = hot_start_pose ? static_cast<int>(*hot_start_pose) : (by > 0 ? -1 : 0);
    hot_start_pose = static_cast<std::size_t>((from + by + count) % count);
    return &start_poses[*hot_start_pose];
}

} // namespace usar::widgets
