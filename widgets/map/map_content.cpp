#include "widgets/map/map_content.h"

#include <algorithm>
#include <utility>

#include "widgets/map/spawn_choice.h"

namespace usar::widgets {

namespace {

constexpr double around_start_poses_m = 20.0;

/// Extends `extent`, which may be nullopt, so that it includes the point, unless this is not finite.
void include(std::optional<Rectangle>& extent, const Vec2& point_m) {
    if (!point_m.allFinite())
        return;
    if (!extent)
        extent = Rectangle{point_m, point_m};
    extent->min_m = extent->min_m.cwiseMin(point_m);
    extent->max_m = extent->max_m.cwiseMax(point_m);
}

/// Leaves out a rectangle that is empty.
void include(std::optional<Rectangle>& extent, const Rectangle& part) {
    if (part.empty())
        return;
    include(extent, part.min_m);
    include(extent, part.max_m);
}

} // namespace

Rectangle MapContent::missionInMap(const Rectangle& scan_in_map) const {
    std::optional<Rectangle> mission;
    include(mission, scan_in_map);
    include(mission, area.area_in_map.value_or(Rectangle{}));
    if (!mission)
        return {};
    for (const Vec2& point_m : area.lanes_in_map_m)
        include(mission, point_m);
    if (const auto found = robots.find(selected_robot); found != robots.end()) {
        const RobotOnMap& robot = found->second;
        include(mission, Vec2(robot.robot.base_in_map.position_m.head<2>()));
        if (!robot.trail.points_m().empty())
            include(mission, robot.trail.points_m().front());
        if (robot.goal_in_map_m)
            include(mission, Vec2(robot.goal_in_map_m->head<2>()));
    }
    return *mission;
}

std::optional<Rectangle> MapContent::everythingInMap(const Rectangle& scan_in_map) const {
    std::optional<Rectangle> all;
    include(all, missionInMap(scan_in_map));
    include(all, groundInMap());
    for (const auto& [name, robot] : robots)
        include(all, Vec2(robot.robot.base_in_map.position_m.head<2>()));
    return all;
}

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
    FootprintPtr known = on_map.robot.footprint;
    on_map.robot = robot;
    if (!robot.footprint)
        on_map.robot.footprint = std::move(known); // Who tells only where it is does not make it forgotten.
    if (!robot.stale)
        on_map.trail.add(robot.base_in_map.position_m);
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

std::optional<Pose> MapContent::startOf(int start_pose) const {
    if (start_pose == SpawnChoice::at_draft)
        return spawn_draft_in_map;
    if (start_pose < 0 || start_pose >= static_cast<int>(start_poses.size()))
        return std::nullopt;
    return start_poses[static_cast<std::size_t>(start_pose)].pose_in_map;
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
