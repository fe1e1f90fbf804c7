// Makes a campaign from the mission that is set up in the window and the fields of the campaign's form.
#pragma once

#include <vector>

#include "core/agent/robot_plugin.h"
#include "core/campaign/plan/campaign.h"
#include "core/campaign/plan/campaign_choices.h"
#include "core/mission/files/mission_file.h"
#include "widgets/campaign/campaign_form.h"

namespace usar::app {

/// Behaviors of a robot for the form.
std::vector<widgets::CampaignBehavior> behaviorsOf(const agent::RobotDescription& robot);

/// Numbers of a behavior that can be varied, with the mission's values in the units that people type.
std::vector<widgets::CampaignParameter> parametersOf(const agent::BehaviorDescription& behavior,
                                                     const mission::Mission& mission);

/// The unit and the words that people may type beside a value of the parameter, or in its place.
campaign::ValueWords valueWordsOf(const agent::ParameterSpec& spec);

/// A campaign is made from these parts of what is set up in the window.
struct CampaignBasis {
    mission::Mission mission; ///< Its parameters are in the units of its behavior.
    agent::RobotDescription robot;
    std::vector<std::string> dock_faults; ///< The Faults dock has these now, as texts.
};

/// Files of a campaign that was set up in the window.
struct CampaignFiles {
    QByteArray campaign;
    QByteArray mission;
};

/// Names of the two files in the folder of a campaign's results.
inline constexpr char campaign_file[] = "campaign.json";
inline constexpr char mission_of_campaign[] = "mission.json";

/// The files as they are to be written at `campaign_path` and `mission_path`. The error says which field is wrong.
Result<CampaignFiles> campaignFiles(const CampaignBasis& basis, const widgets::CampaignWish& wish,
                                    const QString& campaign_path, const QString& mission_path);

/// Writes the files into the folder of the results, and returns the path of the campaign's file. Fails if the folder
/// holds another campaign or other files of these names, and if it cannot be written.
Result<QString> keepCampaign(const CampaignBasis& basis, const widgets::CampaignWish& wish);

/// Text of a file; empty if it cannot be read.
QByteArray textOf(const QString& path);

/// Fails if a file with another text would be lost by writing this one.
Result<void> checkVacant(const QString& path, const QByteArray& text);

/// The first of "FOLDER/NAME", "FOLDER/NAME-2" … that holds nothing yet.
QString freeFolder(const QString& folder, const QString& name);

} // namespace usar::app
