#include "app/cli/mission_program.h"

#include "app/cli/server_files_verb.h"
#include "core/campaign/comparison/compare_options.h"
#include "core/campaign/runs/campaign_options.h"
#include "core/mission/files/export_options.h"
#include "core/mission/files/mission_options.h"
#include "core/mission/files/replay_options.h"
#include "core/mission/files/report_options.h"

namespace usar::app {

usage::Program missionProgram() {
    const QList<usage::Verb> flying{mission::runVerb(), campaign::campaignVerb(), campaign::compareVerb()};
    return {
        .name = "usar-mission",
        .title = "fly robot missions without a window",
        .description = {"usar-mission flies missions and campaigns of missions in the embedded simulator, or against "
                        "a USARSim server, and writes the maps that come of it. Its other verbs read recordings, "
                        "protocol lines and POSH plans."},
        .verbs = flying + QList{mission::exportVerb()} + mission::replayVerbs() + mission::reportVerbs() +
                 QList{serverFilesVerb()},
        .sections = {{.title = "Files",
                      .entries = {{"MISSION.json", "a mission: what flies where; the window writes such files, too"},
                                  {"CAMPAIGN.json", "the missions, seeds, variants and faults of a campaign"},
                                  {"RECORDING.usarrec", "every byte of a flight, in and out, with its time and cause"},
                                  {"PLAN.lap", "a POSH plan"}}},
                     {.title = "Examples",
                      .entries = {{"usar-mission run resources/missions/quick_scan.json --seed 3 --speed max --out "
                                   "results",
                                   "fly the quick scan and write its map to the folder results"},
                                  {"usar-mission run --continue flight.usarrec --record rest.usarrec --out results",
                                   "fly the rest of a mission that was cut off"},
                                  {"usar-mission replay flight.usarrec --from 60 --to 90",
                                   "tell what half a minute of a recording holds"},
                                  {"usar-mission compare results --html report.html",
                                   "say which variant of a campaign is better, with a page of plots"}}}},
        .see_also = {"mission-control", "usar-sim", "usar-behavior-host"}};
}

} // namespace usar::app
