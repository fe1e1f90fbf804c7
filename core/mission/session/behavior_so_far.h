// Values published by a running behavior that are still valid. A recording that starts during a run begins with them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/published.h"

namespace usar::mission {

/// True for kinds of values of which only the newest counts: status, zones, path, goal.
bool replacesItsPredecessor(const agent::Published& value);

/// Keeps the newest value of each kind that replaces its predecessor, and whether a plan is
/// halted. Of a plan it keeps the whole trace, so that the blackboard and all counts can be restored: some 20 bytes per
/// cycle, megabytes per day. Marks and the map are not kept here.
class BehaviorSoFar {
public:
    void take(const agent::Published& value);
    void clear() { *this = {}; }
    /// All that is kept, in an order in which a behavior could have published it.
    std::vector<agent::Published> all() const;

private:
    std::map<std::size_t, agent::Published> newest_; ///< by index in the variant Published
    std::optional<agent::PlanHalted> halted_;        ///< empty while the plan runs
    std::string trace_;                              ///< all pieces of the plan's trace, joined
};

} // namespace usar::mission
