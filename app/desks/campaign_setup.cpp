#include "app/desks/campaign_setup.h"

#include <algorithm>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/campaign/plan/campaign_writer.h"
#include "core/campaign/plan/manifest.h"
#include "widgets/models/parameter_display.h"

namespace usar::app {

namespace {

const QString parameter_path = QStringLiteral("parameters.");

bool has(const agent::BehaviorDescription& behavior, const std::string& parameter) {
    return std::ranges::find(behavior.parameters, parameter, &agent::ParameterSpec::id) != behavior.parameters.end();
}

const agent::BehaviorDescription* behaviorOf(const agent::RobotDescription& robot, const std::string& id) {
    const auto found = std::ranges::find(robot.behaviors, id, &agent::BehaviorDescription::id);
    return found == robot.behaviors.end() ? nullptr : &*found;
}

/// Returns the words in brackets, or the whole name if it has none: "C++" for "Terrain survey (C++)".
std::string shortTitle(const agent::BehaviorDescription& behavior) {
    const QString name = QString::fromStdString(behavior.name);
    const QString inside = name.section('(', 1, 1).section(')', 0, 0);
    return (inside.isEmpty() ? name : inside).toStdString();
}

/// Splits the mission's parameters: what all chosen behaviors have stays in the mission, the rest belongs to the
/// mission's own behavior alone.
std::vector<std::string> takeOwnValues(mission::Mission& mission,
                                       const std::vector<const agent::BehaviorDescription*>& chosen,
                                       const QJsonObject& written) {
    std::vector<std::string> own;
    for (auto one = mission.parameters.begin(); one != mission.parameters.end();) {
        const bool shared =
            std::ranges::all_of(chosen, [&](const auto* behavior) { return has(*behavior, one->first); });
        if (!shared) {
            const QString key = QString::fromStdString(one->first);
            own.push_back((parameter_path + key + '=' + written[key].toVariant().toString()).toStdString());
        }
        one = shared ? std::next(one) : mission.parameters.erase(one);
    }
    return own;
}

Result<std::vector<const agent::BehaviorDescription*>> chosenBehaviors(const CampaignBasis& basis,
                                                                       const QStringList& ids) {
    std::vector<const agent::BehaviorDescription*> chosen;
    for (const QString& id : ids)
        if (const auto* behavior = behaviorOf(basis.robot, id.toStdString()))
            chosen.push_back(behavior);
    if (chosen.empty())
        return failure("no behavior is checked", "Behaviors", "Check at least one");
    return chosen;
}

Result<void> choose(campaign::CampaignChoices& choices, const CampaignBasis& basis,
                    const std::vector<const agent::BehaviorDescription*>& chosen, const widgets::CampaignWish& wish) {
    if (!wish.parameter.isEmpty()) {
        const auto* behavior = behaviorOf(basis.robot, basis.mission.behavior);
        const auto spec =
            std::ranges::find(behavior->parameters, wish.parameter.toStdString(), &agent::ParameterSpec::id);
        const bool is_known = spec != behavior->parameters.end();
        auto values = campaign::readValues(wish.values, is_known ? valueWordsOf(*spec) : campaign::ValueWords());
        if (!values)
            return tl::unexpected(values.error());
        if (values->empty())
            return failure("there is no value of the parameter", "Values", "Write them as 3, 4.5, 6");
        choices.values = *std::move(values);
        choices.parameter = (parameter_path + wish.parameter).toStdString();
        choices.parameter_title = is_known ? spec->label : wish.parameter.toStdString();
        for (const auto* one : chosen)
            if (!has(*one, wish.parameter.toStdString()))
                return failure(one->name + " has no parameter " + choices.parameter_title, "Parameter",
                               "Choose another one, or uncheck this behavior");
    }
    if (wish.faults == widgets::CampaignFaults::OfTheDock) {
        if (basis.dock_faults.empty())
            return failure("the dock Faults has no fault now", "Faults", "Inject one there, or choose none here");
        choices.faults = basis.dock_faults;
    } else if (wish.faults == widgets::CampaignFaults::Swarm) {
        choices.swarm.emplace().share = wish.swarm_share;
    }
    return {};
}

} // namespace

QByteArray textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Result<void> checkVacant(const QString& path, const QByteArray& text) {
    if (QFileInfo::exists(path) && textOf(path) != text)
        return failure("this file is there already, with another text", path.toStdString(), "Choose another folder");
    return {};
}

std::vector<widgets::CampaignBehavior> behaviorsOf(const agent::RobotDescription& robot) {
    std::vector<widgets::CampaignBehavior> behaviors;
    for (const agent::BehaviorDescription& one : robot.behaviors)
        behaviors.push_back({QString::fromStdString(one.id), QString::fromStdString(one.name)});
    return behaviors;
}

std::vector<widgets::CampaignParameter> parametersOf(const agent::BehaviorDescription& behavior,
                                                     const mission::Mission& mission) {
    std::vector<widgets::CampaignParameter> parameters;
    for (const agent::ParameterSpec& spec : behavior.parameters) {
        if (!std::holds_alternative<double>(spec.default_value) &&
            !std::holds_alternative<long long>(spec.default_value))
            continue;
        const auto set = mission.parameters.find(spec.id);
        const agent::ParameterValue value = set == mission.parameters.end() ? spec.default_value : set->second;
        parameters.push_back({QString::fromStdString(spec.id), QString::fromStdString(spec.label),
                              widgets::displayUnit(spec.unit).text,
                              widgets::valueText(spec, value).section(QChar(0x00a0), 0, 0)}); // without its unit
    }
    return parameters;
}

campaign::ValueWords valueWordsOf(const agent::ParameterSpec& spec) {
    const widgets::DisplayUnit unit = widgets::displayUnit(spec.unit);
    return {unit.text, QString::fromStdString(spec.minimum_words), spec.minimum * unit.factor};
}

Result<CampaignFiles> campaignFiles(const CampaignBasis& basis, const widgets::CampaignWish& wish,
                                    const QString& campaign_path, const QString& mission_path) {
    const auto chosen = chosenBehaviors(basis, wish.behaviors);
    if (!chosen)
        return tl::unexpected(chosen.error());
    const auto* own = behaviorOf(basis.robot, basis.mission.behavior);
    if (!own)
        return failure("no plugin has this behavior", basis.mission.behavior, "Choose a behavior in the dock Behavior");
    campaign::CampaignChoices choices;
    choices.name = basis.mission.name;
    choices.mission_file = mission_path;
    choices.first_seed = static_cast<std::uint64_t>(wish.first_seed);
    choices.seeds = wish.seeds;
    mission::Mission mission = basis.mission;
    const QJsonObject written = QJsonDocument::fromJson(mission::writeMission(mission, own->parameters)).object();
    const std::vector<std::string> own_values = takeOwnValues(mission, *chosen, written["parameters"].toObject());
    const std::string plan = std::exchange(mission.plan, {});
    for (const auto* behavior : *chosen) {
        const bool is_own = behavior->id == basis.mission.behavior;
        choices.behaviors.push_back({behavior->id, shortTitle(*behavior), is_own ? plan : std::string(),
                                     is_own ? own_values : std::vector<std::string>()});
    }
    if (const auto well = choose(choices, basis, *chosen, wish); !well)
        return tl::unexpected(well.error());
    return CampaignFiles{
        campaign::writeCampaign(campaign::campaignOf(choices), QFileInfo(campaign_path).absolutePath()),
        mission::writeMission(mission, own->parameters, QFileInfo(mission_path).absolutePath())};
}

Result<QString> keepCampaign(const CampaignBasis& basis, const widgets::CampaignWish& wish) {
    if (wish.folder.isEmpty())
        return failure("there is no folder for the results", "Folder", "Choose one");
    const QDir folder(QFileInfo(wish.folder).absoluteFilePath());
    const QString campaign_path = folder.filePath(campaign_file), mission_path = folder.filePath(mission_of_campaign);
    const auto files = campaignFiles(basis, wish, campaign_path, mission_path);
    if (!files)
        return tl::unexpected(files.error());
    const bool is_same = textOf(campaign_path) == files->campaign && textOf(mission_path) == files->mission;
    if (is_same)
        return campaign_path;
    if (folder.exists(campaign::manifest_file))
        return failure("this folder holds the results of another campaign", folder.path().toStdString(),
                       "Choose another folder, or open these results");
    for (const auto& [path, text] :
         {std::pair(mission_path, files->mission), std::pair(campaign_path, files->campaign)})
        if (const auto vacant = checkVacant(path, text); !vacant)
            return tl::unexpected(vacant.error());
    for (const auto& [path, text] :
         {std::pair(mission_path, files->mission), std::pair(campaign_path, files->campaign)})
        if (const auto kept = campaign::writeWhole(path, text); !kept)
            return tl::unexpected(kept.error());
    return campaign_path;
}

QString freeFolder(const QString& folder, const QString& name) {
    const QString first = QDir(folder).filePath(name);
    QString free = first;
    for (int i = 2; QFileInfo::exists(free); ++i)
        free = first + '-' + QString::number(i);
    return free;
}

} // namespace usar::app
