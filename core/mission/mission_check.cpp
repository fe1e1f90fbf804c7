#include "core/mission/mission_check.h"

#include <algorithm>

#include <QDir>
#include <QTemporaryFile>

#include "core/base/numbers.h"
#include "core/protocol/segments.h"

namespace usar::mission {

namespace {

std::string inWords(const Rectangle& area) {
    return "x " + fixed(area.min_m.x(), 1) + ".." + fixed(area.max_m.x(), 1) + " m, y " + fixed(area.min_m.y(), 1) +
           ".." + fixed(area.max_m.y(), 1) + " m";
}

} // namespace

Result<PreparedBehavior> prepareBehavior(const Mission& mission, const agent::PluginLoader& plugins) {
    const auto plugin = plugins.pluginFor(mission.behavior);
    if (!plugin)
        return tl::unexpected(plugin.error());
    const agent::BehaviorDescription* description = plugins.behavior(mission.behavior);
    auto parameters = agent::ParameterSet::make(description->parameters,
                                                withAnglesInRadians(mission.parameters, description->parameters));
    if (!parameters)
        return tl::unexpected(parameters.error());
    if (description->needs_area && mission.area_in_map.empty())
        return failure("the mission area has no size (" + inWords(mission.area_in_map) + ")", mission.name,
                       "Give area a width and a height above zero");
    return PreparedBehavior{*plugin, *std::move(parameters)};
}

Result<void> checkAreaInside(const Rectangle& area_in_map, const Rectangle& world_in_map) {
    if (area_in_map.empty() || world_in_map.contains(area_in_map))
        return {};
    return failure("the mission area (" + inWords(area_in_map) + ") reaches outside the world", "area",
                   "The world spans " + inWords(world_in_map) + "; move or shrink the area");
}

Result<void> checkFolderIsWritable(const QString& folder) {
    QTemporaryFile probe(folder + "/.usar-XXXXXX");
    if (QDir().mkpath(folder) && probe.open())
        return {};
    return failure("no results can be written to this folder", folder.toStdString(),
                   "Choose a folder that you may write to, with --out DIR");
}

Result<Pose> startPoseNamed(const std::string& name, const protocol::StartPoses& poses) {
    const auto found = std::ranges::find_if(
        poses.poses, [&](const protocol::StartPose& pose) { return protocol::sameWord(pose.name, name); });
    if (found != poses.poses.end())
        return found->pose_in_map;
    std::string names;
    for (const protocol::StartPose& pose : poses.poses)
        names += (names.empty() ? "" : ", ") + pose.name;
    return failure("the server knows no start pose of this name", name,
                   names.empty() ? "It has none at all" : "It has " + names);
}

} // namespace usar::mission
