#include "core/campaign/runs/slurm_script.h"

#include <QFileInfo>

#include "core/campaign/plan/shell_word.h"

namespace usar::campaign {

namespace {

QString absolute(const QString& path) {
    return shellWord(QFileInfo(path).absoluteFilePath());
}

} // namespace

QString slurmScript(const CampaignOptions& options, const QString& program) {
    return QString(
               "#!/bin/sh\n"
               "# Submit this with sbatch. It submits itself once more, to report when all parts have ended.\n"
               "#SBATCH --job-name=usar-campaign\n"
               "#SBATCH --array=0-%1\n"
               "#SBATCH --requeue\n"
               "#SBATCH --open-mode=append\n"
               "#SBATCH --signal=B:TERM@60\n"
               "program=%2\n"
               "campaign=%3\n"
               "results=%4\n"
               "if [ \"$SLURM_ARRAY_TASK_ID\" = 0 ] && [ \"${SLURM_RESTART_COUNT:-0}\" = 0 ]; then\n"
               "    sbatch --job-name=usar-campaign-report --dependency=afterany:\"$SLURM_ARRAY_JOB_ID\" \\\n"
               "        --wrap \"'$program' compare '$results' --html '$results/report.html'\"\n"
               "fi\n"
               "exec \"$program\" campaign \"$campaign\" --out \"$results\" --jobs \"${SLURM_CPUS_PER_TASK:-1}\" \\\n"
               "    --shard \"$SLURM_ARRAY_TASK_ID/%5\"\n")
        .arg(QString::number(*options.slurm - 1), shellWord(program), absolute(options.file), absolute(options.folder),
             QString::number(*options.slurm));
}

} // namespace usar::campaign
