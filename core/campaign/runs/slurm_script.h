// The job script that flies a campaign on a cluster with Slurm.
#pragma once

#include <QString>

#include "core/campaign/runs/campaign_options.h"

namespace usar::campaign {

/// Returns a script for sbatch: an array with one shard a task. A task that is about to be ended, because its time is
/// over or its node is needed, gets SIGTERM 60 s before and stops; a task whose node fails is started again, and goes
/// on where it was. When all have ended, a job of its own reports. `program`: path of usar-mission, the same on every
/// node. `options.slurm` must be set.
QString slurmScript(const CampaignOptions& options, const QString& program);

} // namespace usar::campaign
