// The words that a campaign says while it runs and when it is over.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include <QJsonObject>

#include "core/campaign/runs/campaign_runner.h"

namespace usar::campaign {

/// A line such as "[####----------------]  20 %  40 of 200 runs  3 not done  1.2 runs/s  ETA 2:13", cut to `columns`
/// characters.
std::string progressLine(const CampaignProgress& progress, std::optional<std::size_t> columns = {});

/// One sentence about a result that is not Outcome::Done or that came out differently when it was flown again, with the
/// command that flies it; empty for others.
std::string sentenceOf(const RunResult& result);

/// The sentence about a campaign that a person or a scheduler has stopped, and how it goes on if its results are
/// `kept`.
std::string stoppedSentence(const CampaignProgress& progress, bool kept);

/// Returns an object with the keys folder, runs, done, outcomes (an object with a count for each), different (numbers
/// of runs), complete, wall_s.
QJsonObject toJson(const CampaignProgress& progress, const QString& folder);

/// The exit code of `usar-mission campaign`, as that of a mission. `may_lack_runs`: it is over although some have not
/// been flown.
int exitCodeOf(const CampaignProgress& progress, bool may_lack_runs = false);

} // namespace usar::campaign
