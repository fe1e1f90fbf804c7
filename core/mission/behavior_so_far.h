// What a running behavior has published and what still holds: with this a recording begins in the midst of a run.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/published.h"

namespace usar::mission {

/// Of what replaces itself the newest is kept (status, zones, path, goal), and whether a plan stands still; of a plan
/// the whole trace, so that the blackboard and all that was counted are there: some 20 bytes a cycle, megabytes a day.
/// Marks and the map are not kept here.
class BehaviorSoFar {
public:
    void take(const agent::Published& value);
    void clear() { *this = {}; }
    /// In an order in which a behavior could have said it.
    std::vector<agent::Published> all() const;

private:
    std::map<std::size_t, agent::Published> newest_; ///< by kind
    std::optional<agent::PlanHalted> halted_;
    std::string trace_;
};

} // namespace usar::mission
