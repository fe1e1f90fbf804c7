#include "core/campaign/plan/mission_names.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <QDir>
#include <QFileInfo>
#include <QStringList>

#include "core/mission/files/scan_record.h"

namespace usar::campaign {

namespace {

constexpr qsizetype longest_details = 60; ///< More would not fit into a heading.

QString drawInWords(const Draw& draw) {
    const QString key = QString::fromStdString(draw.key) + ' ';
    return draw.choices.empty() ? key + QString("%1 to %2").arg(draw.least).arg(draw.most)
                                : key + mission::textsOf(draw.choices).join('|');
}

/// All that may tell a mission from others of its file's name.
QStringList detailsOf(const CampaignMission& mission) {
    QStringList details{"of " + QFileInfo(mission.file).dir().dirName()};
    QStringList worlds;
    for (const std::string& world : mission.worlds)
        worlds << QFileInfo(QString::fromStdString(world)).fileName();
    if (!worlds.isEmpty())
        details << "in " + worlds.join('|');
    for (const Draw& draw : mission.draws)
        details << drawInWords(draw);
    return details << QString("from seed %1").arg(mission.first_seed);
}

QString nameAmong(const CampaignMission& mission, const std::vector<const CampaignMission*>& all) {
    QStringList details = detailsOf(mission);
    details.removeIf([&](const QString& detail) {
        return std::ranges::all_of(all, [&](const auto* other) { return detailsOf(*other).contains(detail); });
    });
    const QString words = details.join(", ");
    return words.isEmpty() || words.size() > longest_details ? QString() : nameOf(mission) + " (" + words + ')';
}

/// Names those of `group` that have no name; all of them would have the same.
void nameGroup(const std::vector<CampaignMission*>& group, std::set<std::string>& taken) {
    const std::vector<const CampaignMission*> all(group.begin(), group.end());
    std::vector<std::string> names;
    for (const CampaignMission* mission : all)
        names.push_back(nameAmong(*mission, all).toStdString());
    for (std::size_t i = 0; i < group.size(); ++i) {
        std::string name = names[i];
        for (std::size_t number = i + 1; name.empty() || std::ranges::count(names, name) > 1 || taken.contains(name);
             ++number)
            name = (nameOf(*group[i]) + QString(" %1").arg(number)).toStdString();
        taken.insert(name);
        group[i]->name = name;
    }
}

} // namespace

void nameMissions(std::vector<CampaignMission>& missions) {
    std::set<std::string> taken;
    std::map<QString, std::vector<CampaignMission*>> groups;
    for (CampaignMission& mission : missions) {
        if (mission.name.empty())
            groups[nameOf(mission)].push_back(&mission);
        else
            taken.insert(mission.name);
    }
    for (const auto& [name, group] : groups)
        if (group.size() > 1 || taken.contains(name.toStdString()))
            nameGroup(group, taken);
}

} // namespace usar::campaign
