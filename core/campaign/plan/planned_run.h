// The runs of a campaign, numbered, each with everything that it is flown with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/campaign/plan/campaign.h"
#include "core/campaign/plan/swarm.h"

namespace usar::campaign {

/// One run. Equal campaigns give equal runs, whatever flies them and in whichever order.
struct PlannedRun {
    int number = 0;
    int pair = 0; ///< runs of one pair differ in the variant alone
    std::size_t mission = 0;
    std::size_t variant = 0;
    std::uint64_t seed = 1;
    std::vector<std::string>
        faults; ///< the campaign's and the drawn ones; those of the mission file are not among them
    std::vector<std::string> values; ///< KEY=VALUE: the world, the drawn values, and the variant's
    bool operator==(const PlannedRun&) const = default;
};

/// All runs in the order of missions, worlds, seeds and variants; then the known failures, each a pair of its own.
std::vector<PlannedRun> planRuns(const Campaign& campaign, std::span<const FaultChoice> choices);

/// Arguments for usar-mission that fly this run, without a result folder.
QStringList argumentsOf(const Campaign& campaign, const PlannedRun& run);
/// The same as a campaign flies it, with its files in `folder`.
QStringList flightArgumentsOf(const Campaign& campaign, const PlannedRun& run, const QString& folder);
/// What a person types to fly this run, as a command for a shell.
QString commandOf(const Campaign& campaign, const PlannedRun& run);

} // namespace usar::campaign
