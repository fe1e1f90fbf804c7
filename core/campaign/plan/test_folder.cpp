#include "core/campaign/plan/test_folder.h"

#include <QDir>

#include "core/mission/files/mission_file.h"

namespace usar::campaign {

Result<Campaign> campaignOfTests(const QString& folder) {
    const QDir dir(folder);
    const QStringList names = dir.entryList({"*.json"}, QDir::Files, QDir::Name);
    if (names.isEmpty())
        return failure(dir.exists() ? "there is no test in the folder" : "there is no such folder",
                       folder.toStdString(), "Name a folder with missions (*.json) that have \"claims\"");
    Campaign campaign;
    campaign.name = dir.dirName().toStdString();
    campaign.variants.push_back({tests_variant, {}, {}, {}});
    for (const QString& name : names) {
        const QString path = dir.absoluteFilePath(name);
        const auto mission = mission::readMissionFile(path);
        if (!mission)
            return tl::unexpected(mission.error());
        if (mission->claims.empty())
            return failure("the mission claims nothing, so it is no test", path.toStdString(),
                           "Add \"claims\", or move the file to another folder");
        CampaignMission& one = campaign.missions.emplace_back();
        one.file = path;
        one.first_seed = mission->seed.value_or(1);
    }
    return campaign;
}

} // namespace usar::campaign
