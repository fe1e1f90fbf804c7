#include "core/mission/fleet/roster.h"

#include <algorithm>
#include <utility>

#include "core/protocol/commands/spawn.h"

namespace usar::mission {

RobotId Roster::nextId() const {
    RobotId id{1};
    while (robots_.contains(id))
        ++id.value;
    return id;
}

bool Roster::has(const std::string& name) const {
    return std::ranges::any_of(robots_,
                               [&](const auto& entry) { return entry.second->view().spawn.robot_name == name; });
}

QString Roster::unusedName(const QString& name) const {
    QString unused = name;
    for (int number = 2; has(unused.toStdString()); ++number)
        unused = name + ' ' + QString::number(number);
    return unused;
}

Result<SpawnRequest> Roster::accept(SpawnRequest request) const {
    if (request.class_name.empty())
        return failure("no plugin says which robot to spawn", request.robot_name, "Start with --plugins FOLDER");
    if (full())
        return failure("there can be no more than " + std::to_string(most_robots) + " robots", request.robot_name,
                       "Remove one first");
    if (request.robot_name.empty())
        request.robot_name = nextName().toStdString();
    if (has(request.robot_name))
        return failure("a robot already has this name", request.robot_name, "Choose another name");
    return request;
}

void Roster::add(std::unique_ptr<Robot> robot) {
    const RobotId id = robot->view().id;
    robots_[id] = std::move(robot);
}

std::unique_ptr<Robot> Roster::take(RobotId id) {
    auto node = robots_.extract(id);
    return node.empty() ? nullptr : std::move(node.mapped());
}

Robot* Roster::robot(RobotId id) const {
    const auto found = robots_.find(id);
    return found == robots_.end() ? nullptr : found->second.get();
}

Robot* Roster::on(ConnectionId connection) const {
    const auto found =
        std::ranges::find_if(robots_, [&](const auto& entry) { return entry.second->view().connection == connection; });
    return found == robots_.end() ? nullptr : found->second.get();
}

std::vector<Robot*> Roster::robots() const {
    std::vector<Robot*> all;
    for (const auto& [id, robot] : robots_)
        all.push_back(robot.get());
    return all;
}

SpawnRequest stationRequest(const std::vector<protocol::StartPose>& poses, const std::vector<SpawnRequest>& present) {
    const auto is_free = [&](const protocol::StartPose& pose) {
        return std::ranges::none_of(present, [&](const SpawnRequest& robot) {
            return robot.start_in_map.position_m.isApprox(pose.pose_in_map.position_m);
        });
    };
    auto place = std::ranges::find_if(poses, is_free);
    if (place == poses.end())
        place = poses.begin();
    std::string name = "Base";
    for (int number = 2; std::ranges::count(present, name, &SpawnRequest::robot_name) > 0; ++number)
        name = "Base" + std::to_string(number);
    return {std::string(protocol::station_class), name, place->pose_in_map};
}

std::string startName(const std::vector<protocol::StartPose>& poses, const Robot* robot, const std::string& otherwise) {
    for (const protocol::StartPose& pose : poses)
        if (robot && pose.pose_in_map.position_m.isApprox(robot->view().spawn.start_in_map.position_m))
            return pose.name;
    return poses.empty() ? otherwise : poses.front().name;
}

} // namespace usar::mission
