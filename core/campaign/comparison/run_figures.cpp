#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

bool counts(Outcome outcome) {
    return outcome != Outcome::Refused && outcome != Outcome::Killed;
}

} // namespace usar::campaign
