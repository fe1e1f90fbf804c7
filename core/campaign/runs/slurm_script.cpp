#include "core/campaign/runs/slurm_script.h"

#include <QFileInfo>

#include "core/campaign/plan/shell_word.h"

namespace usar::campaign {

namespace {

QString absolute(const QString& path) {
    return shellWord(QFileInfo(path).absoluteFilePath());
}

/// The options that change which runs there are, with a space before each.
QString furtherOptions(const CampaignOptions& options) {
    QString words;
    if (options.runs)
        words += QString(" --runs %1").arg(*options.runs);
    if (options.first_seed)
        words += QString(" --first-seed %1").arg(*options.first_seed);
    return words + QString(" --check-every %1").arg(options.check_every);
}

} // namespace

QString slurmScript(const CampaignOptions& options, const QString& program) {
    return QString(
               "#!/bin/sh\n"
               "# Submit this with sbatch. It submits a second job, which reports when all parts have ended; to be "
               "worse or\n"
               "# undecided is no failure of that job.\n"
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
               "        --wrap \"'$program' compare '$results' --html '$results/report.html' || case \\$? in 1|3) ;; "
               "*) exit 1 ;; esac\"\n"
               "fi\n"
               "exec \"$program\" campaign \"$campaign\" --out \"$results\" --jobs \"${SLURM_CPUS_PER_TASK:-1}\" \\\n"
               "    --shard \"$SLURM_ARRAY_TASK_ID/%5\"%6\n")
        .arg(QString::number(*options.slurm - 1), shellWord(program), absolute(options.file), absolute(options.folder),
             QString::number(*options.slurm), furtherOptions(options));
}

} // namespace usar::campaign
