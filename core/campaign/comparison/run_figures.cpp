#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

const char* wordOf(RunOutcome outcome) {
    switch (outcome) {
    case RunOutcome::Done:
        return "done";
    case RunOutcome::Failed:
        return "failed";
    case RunOutcome::Refused:
        return "refused";
    case RunOutcome::Crashed:
        return "crashed";
    case RunOutcome::Killed:
        return "killed";
    case RunOutcome::TimedOut:
        return "timed out";
    case RunOutcome::OutOfMemory:
        return "out of memory";
    }
    return "";
}

bool counts(RunOutcome outcome) {
    return outcome != RunOutcome::Refused && outcome != RunOutcome::Killed;
}

} // namespace usar::campaign
