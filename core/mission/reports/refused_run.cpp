#include "core/mission/reports/refused_run.h"

namespace usar::mission {

RunSummary refusedRun(const Error& error, const MissionOptions* options, const Mission* mission) {
    RunSummary known;
    known.reason = error.text();
    if (options) {
        known.behavior = options->behavior.toStdString();
        known.seed = options->seed;
    }
    if (mission) {
        known.mission = mission->name;
        known.behavior = mission->behavior;
        known.plan = mission->plan;
    }
    return known;
}

} // namespace usar::mission
