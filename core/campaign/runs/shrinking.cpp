#include "core/campaign/runs/shrinking.h"

#include <QDir>
#include <QEventLoop>

#include "core/campaign/runs/invariants.h"
#include "core/campaign/runs/run_process.h"

namespace usar::campaign {

namespace {

RunResult flyOnce(const Campaign& campaign, const PlannedRun& run, const QString& program, const QString& folder) {
    RunResult result;
    if (campaign.limit_h)
        result.limit_s = *campaign.limit_h * 3600.0;
    RunProcess process;
    QEventLoop loop;
    QObject::connect(
        &process, &RunProcess::ended, &loop,
        [&](const ProcessEnd& end) {
            judge(result, end);
            loop.quit();
        },
        Qt::QueuedConnection); // The process may fail to start before the loop runs.
    process.start(program, flightArgumentsOf(campaign, run, folder), Seconds{campaign.wall_limit_s});
    loop.exec();
    QDir(folder).removeRecursively();
    return result;
}

bool endedByItself(const RunResult& result) {
    return result.outcome == Outcome::Done || result.outcome == Outcome::Failed;
}

} // namespace

FaultTexts shrunk(FaultTexts faults, const std::function<bool(const FaultTexts&)>& still_breaks) {
    for (std::size_t i = 0; i < faults.size();) {
        FaultTexts fewer = faults;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (!still_breaks(fewer)) {
            ++i;
            continue;
        }
        faults = std::move(fewer);
        i = 0; // What an earlier fault was needed for may be gone.
    }
    return faults;
}

KnownFailure knownFailure(const Campaign& campaign, const PlannedRun& run, const RunResult& result) {
    std::vector<std::string> values = run.values;
    values.resize(values.size() - campaign.variants[run.variant].values.size()); // The variant's own are the last.
    return {result.mission, result.variant,    run.seed,
            run.faults,     std::move(values), result.broken.join(' ').toStdString()};
}

bool breaksAsBefore(const Campaign& campaign, const PlannedRun& run, const RunResult& before, const QString& program,
                    const QString& folder) {
    RunResult result = flyOnce(campaign, run, program, folder);
    if (before.differences)
        result.differences = differencesOf(result.summary, flyOnce(campaign, run, program, folder).summary);
    const bool ended_alike = result.outcome == before.outcome || (endedByItself(result) && endedByItself(before));
    return ended_alike && !brokenInvariants(result).isEmpty();
}

} // namespace usar::campaign
