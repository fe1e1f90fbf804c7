// Plans made by chance, for properties that must hold of any plan.
#pragma once

#include <cstddef>

#include "core/base/random.h"
#include "core/posh/model/plan.h"

namespace doubles {

struct RandomPlanOptions {
    std::size_t most_forms = 6;   ///< besides the collection
    std::size_t most_levels = 4;  ///< of drives or elements
    std::size_t most_members = 3; ///< of a level
    std::size_t most_steps = 4;   ///< of a pattern
    std::size_t most_senses = 3;  ///< of a goal or trigger
    std::size_t sense_names = 6;  ///< s0, s1, …
    std::size_t action_names = 6; ///< a0, a1, …
    bool with_parameters = true;  ///< parameters and arguments
    bool with_limits = true;      ///< times, frequencies, retries
    bool with_adopts = true;
    bool with_decoration = false; ///< comments, documentation, odd names and spellings: what only readers care about
    bool with_collection = true;
};

/// Sound: without errors, references without cycles (forms are called c0, p1, d2 … by kind and index in the file). Each
/// literal has its spelling, so that reading what is written gives an equal plan.
usar::posh::Plan randomPlan(usar::Random& random, const RandomPlanOptions& options = {});

} // namespace doubles
