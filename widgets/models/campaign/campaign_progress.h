// How far a campaign is, as a value and in words.
#pragma once

#include <optional>

#include <QString>

namespace usar::widgets {

/// What the program does with the campaign now. Closed: no campaign was begun or opened.
enum class CampaignState { Closed, Running, Stopping, Stopped, Complete };

struct CampaignProgress {
    CampaignState state = CampaignState::Closed;
    QString title{};        ///< It is the campaign's name.
    int runs = 0;           ///< It is 0 until the campaign's program has counted them.
    int done = 0;           ///< So many runs have a result.
    int failures = 0;       ///< So many results are something else than "done".
    double rate_hz = 0.0;   ///< Runs per second since this start; 0 before the first has ended.
    bool can_resume = true; ///< The campaign's file is known, so that missing runs can be flown.
    bool operator==(const CampaignProgress&) const = default;
};

/// "12 of 40 runs · 1 not done · 1.2 runs/s · 0:24 left"; what is not known is left out.
QString progressText(const CampaignProgress& progress);
/// "flying", "stopping", "stopped", "complete"; empty while there is no campaign.
QString stateWord(CampaignState state);

} // namespace usar::widgets
