// The command line of `usar-mission campaign`.
#pragma once

#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/result.h"
#include "core/campaign/runs/shard_file.h"
#include "core/usage/program.h"

namespace usar::campaign {

/// Options of `usar-mission campaign`, with their defaults.
struct CampaignOptions {
    QString file;
    QString tests{};                 ///< a folder whose missions are flown as tests, instead of a campaign's file
    QString junit{};                 ///< file for the results of the tests; empty: none
    QString folder;                  ///< for the results; empty: tests need none
    int jobs = 0;                    ///< processes at a time; 0: as many as there are processors
    bool resume = false;             ///< go on with the results that are in the folder
    std::optional<Shard> shard{};    ///< absent: all runs
    int check_every = 100;           ///< one run in so many is flown twice; 0: none
    std::optional<int> slurm{};      ///< only print a job script with so many shards
    std::optional<int> runs{};       ///< about so many in all, instead of as many as the file's seeds make
    std::optional<int> first_seed{}; ///< instead of the file's
    QString shrink{};                ///< file for the runs that break an invariant, with the fewest faults; empty: none
    bool until_decided = false;      ///< fly no more once it is known which of two variants is better
    bool operator==(const CampaignOptions&) const = default;
};

/// Slurm's usual MaxArraySize is 1001, and an array's numbers begin with 0.
inline constexpr int most_shards = 1000;

/// Reads the command line; `arguments` begins with the verb. Errors name the option and how to write it.
Result<CampaignOptions> readCampaignOptions(const QStringList& arguments);

/// The verb and its options in words.
usage::Verb campaignVerb();

} // namespace usar::campaign
