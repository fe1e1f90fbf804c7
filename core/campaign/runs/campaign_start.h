// The steps before a campaign's first run: it is read and checked, and its manifest is kept.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QStringList>

#include "core/campaign/plan/manifest.h"
#include "core/campaign/runs/campaign_options.h"
#include "core/campaign/runs/campaign_runner.h"
#include "core/mission/files/mission_file.h"

namespace usar::campaign {

/// Facts that only the program knows that flies the campaign.
struct CampaignHost {
    QString program; ///< path of usar-mission
    std::string version;
    QStringList plugin_folders;
    QString robots_folder{};         ///< with the files of the simulated robots; empty: there is none
    std::vector<FaultChoice> faults; ///< those that a swarm may draw
    std::function<Result<void>(const std::string& fault)> check_fault;
    /// Folder of a world, by its name or path; an empty path for a world that the program makes from a seed.
    std::function<Result<QString>(const QString& world)> find_world;
    /// Whether a mission's behavior exists and takes its preset and parameters.
    std::function<Result<void>(const mission::Mission& mission)> check_mission;
};

/// Reads all that the campaign depends on: every mission must be readable with every variant's values, and fit its
/// behavior with those of its first seed; every world, plan and fault must exist. Errors name the file and the place.
Result<Manifest> manifestOf(const Campaign& campaign, const CampaignHost& host);

/// Changes the campaign's seeds as the command line wants it. With --runs, every mission and world gets as many seeds
/// as it takes to fly at least that many; known failures are not counted.
void applyTo(Campaign& campaign, const CampaignOptions& options);

/// Makes ready to fly: keeps the manifest in the folder, takes the shard's file, and reads earlier results. Fails if
/// the folder holds another campaign, if another process flies the same shard, and if there are results but neither
/// --resume nor --shard is given.
Result<std::unique_ptr<CampaignRunner>> startCampaign(const CampaignOptions& options, const CampaignHost& host);

} // namespace usar::campaign
