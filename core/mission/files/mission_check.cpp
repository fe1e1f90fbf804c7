#include "core/mission/files/mission_check.h"

#include <algorithm>
#include <iterator>

#include <QDir>
#include <QTemporaryFile>

#include "core/agent/posh/posh_binding.h"
#include "core/base/numbers.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

namespace {

std::string inWords(const Rectangle& area) {
    return "x " + fixed(area.min_m.x(), 1) + ".." + fixed(area.max_m.x(), 1) + " m, y " + fixed(area.min_m.y(), 1) +
           ".." + fixed(area.max_m.y(), 1) + " m";
}

/// The part that both share; `empty()` if there is none.
Rectangle commonOf(const Rectangle& one, const Rectangle& other) {
    return {one.min_m.cwiseMax(other.min_m), one.max_m.cwiseMin(other.max_m)};
}

/// Parameter spec with the units of a mission file: angles in degrees.
agent::ParameterSpec inFileUnits(agent::ParameterSpec spec) {
    if (spec.unit != "rad")
        return spec;
    spec.unit = "deg";
    spec.minimum = typedDegrees(spec.minimum);
    spec.maximum = typedDegrees(spec.maximum);
    return spec;
}

/// Checks each parameter by itself and in the units of the file, so that the error can name the place of the first
/// wrong one.
Result<void> checkParameters(const Mission& mission, const std::vector<agent::ParameterSpec>& specs) {
    std::vector<agent::ParameterSpec> written;
    std::ranges::transform(specs, std::back_inserter(written), inFileUnits);
    for (const auto& parameter : mission.parameters) {
        const std::string path = "parameters." + parameter.first;
        if (const auto made = agent::ParameterSet::make(written, {parameter}); made)
            continue;
        else if (std::ranges::find(specs, parameter.first, &agent::ParameterSpec::id) == specs.end())
            return tl::unexpected(atKey(mission, path, made.error()));
        else
            return tl::unexpected(atValue(mission, path, made.error()));
    }
    return {};
}

/// Advice such as "Choose airrobot/posh, or leave the plan out".
std::string whoTakesPlans(const agent::RobotDescription& robot) {
    for (const agent::BehaviorDescription& behavior : robot.behaviors)
        if (!behavior.plan_name.empty())
            return "Choose " + behavior.id + ", or leave the plan out";
    return "Leave the plan out";
}

} // namespace

Result<std::optional<agent::PlanText>> readOwnPlan(const QString& path, const std::string& behavior_id,
                                                   const agent::PluginLoader& plugins) {
    if (path.isEmpty())
        return std::nullopt;
    const agent::RobotDescription* const robot = plugins.robotOf(behavior_id);
    if (!robot)
        return tl::unexpected(plugins.pluginFor(behavior_id).error());
    if (plugins.behavior(behavior_id)->plan_name.empty())
        return failure("this behavior is not run by a plan", behavior_id, whoTakesPlans(*robot));
    auto plan = readPlanFile(path);
    if (!plan)
        return tl::unexpected(plan.error());
    if (const auto bound = agent::bindPlan(plan->text, robot->primitives); !bound.program)
        return tl::unexpected(agent::planRefusal(plan->name, bound.findings));
    return *std::move(plan);
}

Result<std::map<std::string, agent::ParameterValue>> resolvedParameters(const Mission& mission,
                                                                        const agent::BehaviorDescription& behavior) {
    auto values = withAnglesInRadians(mission.parameters, behavior.parameters);
    if (mission.preset.empty())
        return values;
    const auto preset = std::ranges::find(behavior.presets, mission.preset, &agent::ParameterPreset::id);
    if (preset == behavior.presets.end()) {
        std::vector<std::string> known;
        std::ranges::transform(behavior.presets, std::back_inserter(known), &agent::ParameterPreset::id);
        return tl::unexpected(
            atValue(mission, "preset",
                    {behavior.id + " has no preset \"" + mission.preset + "\"", "preset",
                     known.empty() ? "It has none at all; leave the preset out"
                                   : "Did you mean \"" + nearestWord(mission.preset, known) +
                                         "\"? Known here: " + textsOf(known).join(", ").toStdString()}));
    }
    values.insert(preset->values.begin(), preset->values.end()); // Values that are there stay.
    return values;
}

Result<PreparedBehavior> prepareBehavior(const Mission& mission, const agent::PluginLoader& plugins) {
    const auto plugin = plugins.pluginFor(mission.behavior);
    if (!plugin)
        return tl::unexpected(atValue(mission, "behavior", plugin.error()));
    const agent::BehaviorDescription* description = plugins.behavior(mission.behavior);
    if (const auto good = checkParameters(mission, description->parameters); !good)
        return tl::unexpected(good.error());
    const auto values = resolvedParameters(mission, *description);
    if (!values)
        return tl::unexpected(values.error());
    auto parameters = agent::ParameterSet::make(description->parameters, *values);
    if (!parameters)
        return tl::unexpected(parameters.error());
    if (description->needs_area && mission.area_in_map.empty())
        return tl::unexpected(atValue(mission, "behavior",
                                      {"it needs a mission area", mission.behavior,
                                       "Add \"area\" with x, y, width and height in meters to the mission"}));
    auto plan = readOwnPlan(QString::fromStdString(mission.plan), mission.behavior, plugins);
    if (!plan)
        return tl::unexpected(atValue(mission, "plan", plan.error()));
    return PreparedBehavior{*plugin, *std::move(parameters), *std::move(plan)};
}

Result<void> checkAreaInWorld(const Rectangle& area_in_map, const Rectangle& world_in_map) {
    if (area_in_map.empty() || world_in_map.empty() || !commonOf(area_in_map, world_in_map).empty())
        return {};
    return failure("the mission area (" + inWords(area_in_map) + ") is entirely outside the world", "area",
                   "The world spans " + inWords(world_in_map) + "; move the area");
}

Result<void> checkAreaInWorld(const Mission& mission, const Rectangle& world_in_map) {
    const auto inside = checkAreaInWorld(mission.area_in_map, world_in_map);
    return inside ? inside : tl::unexpected(atValue(mission, "area", inside.error()));
}

std::string beyondWorldNotice(const Rectangle& area_in_map, const Rectangle& world_in_map) {
    if (area_in_map.empty() || world_in_map.empty() || world_in_map.contains(area_in_map))
        return {};
    const double outside_pct = 100.0 * (1.0 - commonOf(area_in_map, world_in_map).area_m2() / area_in_map.area_m2());
    const std::string share = outside_pct < 0.1 ? "Less than 0.1" : fixed(outside_pct, outside_pct < 10.0 ? 1 : 0);
    return share + " % of the mission area (" + inWords(area_in_map) + ") is outside the world, which spans " +
           inWords(world_in_map) + "; only the part inside is flown.";
}

Rectangle areaWithin(const Rectangle& area_in_map, const Rectangle& world_in_map) {
    return world_in_map.empty() ? area_in_map : commonOf(area_in_map, world_in_map);
}

Result<void> checkFolderIsWritable(const QString& folder) {
    QTemporaryFile probe(folder + "/.usar-XXXXXX");
    if (QDir().mkpath(folder) && probe.open())
        return {};
    return failure("no results can be written to this folder", folder.toStdString(),
                   "Choose a folder that you may write to, with --out DIR");
}

Result<Pose> startPoseOf(const Mission& mission, const protocol::StartPoses& poses) {
    const auto found = std::ranges::find_if(
        poses.poses, [&](const protocol::StartPose& pose) { return sameWord(pose.name, mission.start); });
    if (found != poses.poses.end())
        return found->pose_in_map;
    std::string names;
    for (const protocol::StartPose& pose : poses.poses)
        names += (names.empty() ? "" : ", ") + pose.name;
    const Error error{"the server knows no start pose with this name", mission.start,
                      names.empty() ? "It has none at all" : "It has " + names};
    return tl::unexpected(atValue(mission, "start", error));
}

std::string plannedBehavior(const std::string& chosen, const agent::PluginLoader& plugins) {
    if (const auto* behavior = plugins.behavior(chosen); behavior && !behavior->plan_name.empty())
        return chosen;
    if (const auto* robot = plugins.robotOf(chosen))
        for (const agent::BehaviorDescription& behavior : robot->behaviors)
            if (!behavior.plan_name.empty())
                return behavior.id;
    return chosen;
}

} // namespace usar::mission
