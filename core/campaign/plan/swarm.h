// Draws sets of faults: which kinds a run has, then when each begins and how strong it is.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/campaign/plan/campaign.h"

namespace usar::campaign {

/// One number of a kind of fault, with its range.
struct FaultRange {
    std::string name;
    double least = 0.0;
    double usual = 0.0;
    double most = 0.0;
    bool whole = false; ///< it counts something
};

/// A kind of fault that can be drawn. The simulator's owner knows them.
struct FaultChoice {
    std::string word; ///< the first word of the fault's text
    std::vector<FaultRange> numbers;
};

/// Returns the texts of the faults, in the syntax of --fault, for the robot `robot`. Each kind of the swarm has the
/// swarm's probability; a set may be empty. Leaving out random kinds reaches more states than having all of them at
/// once (Groce et al. 2012, Swarm testing). Half of the faults last to the end; the others last up to a minute. Each
/// has at least one of its kind's numbers, between half and twice the usual one, within the kind's range; a whole one
/// is any of the range.
std::vector<std::string> drawFaults(const Swarm& swarm, std::span<const FaultChoice> choices, Random& random);

} // namespace usar::campaign
