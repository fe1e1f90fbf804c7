// What a running plan does, element by element, and what of it stands at each node of a drawn plan.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/clock.h"
#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// Times are those of the protocol (or of the recording), as is `PlanSnapshot::now`.
struct SenseAnswer {
    QString value;      ///< as the plan would write it: "0.31", "true", "'high"
    bool holds = false; ///< after the comparison
    Seconds since{0.0}; ///< the verdict has been this one
    Seconds asked{0.0}; ///< last
    bool operator==(const SenseAnswer&) const = default;
};

/// Of one element of the plan since its start.
struct PlanActivity {
    bool running = false;               ///< on the way from the root to what was done in the newest cycle
    std::optional<Seconds> last_active; ///< nothing: never
    std::uint64_t started = 0;
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;  ///< and interrupted
    std::uint64_t skipped = 0; ///< held back by its frequency or its retries
    QString hold_back;         ///< why it is held back now: "its frequency: 1.2 s left"; empty while nothing does
    std::optional<SenseAnswer> answer; ///< of senses
    bool operator==(const PlanActivity&) const = default;
};

/// A key of the plan's blackboard.
struct BoardValue {
    QString key;
    QString value;   ///< as traces print it
    QString history; ///< of its values, a line each, the newest first: for a tooltip
    bool operator==(const BoardValue&) const = default;
};

/// The paths are those of the engine (see PlanTree::find) and the same for a whole run: they are shared. One activity
/// for each path.
struct PlanSnapshot {
    std::shared_ptr<const std::vector<std::string>> paths;
    std::vector<PlanActivity> activities;
    Seconds now{0.0};
    std::vector<BoardValue> board{}; ///< by key
};

/// The activity of each node of a tree. What is drawn once for several places has that of all of them: sums, and the
/// newest times and answers.
class PlanStates {
public:
    /// Nothing has happened yet.
    void reset(const PlanTree& tree);
    /// Finds the nodes of the paths when they are others than last time.
    void take(const PlanTree& tree, const PlanSnapshot& snapshot);

    const PlanActivity& operator[](int node) const { return states_[static_cast<std::size_t>(node)]; }
    Seconds now() const { return now_; }
    /// From 1 while it runs down to 0 where it has not for long; halves every `half_life`.
    double recency(int node) const;
    static constexpr Seconds half_life{2.0};
    /// Paths that no node has: those of another plan than the drawn one.
    int strangers() const { return strangers_; }
    /// Cards that run, in the order of the tree.
    std::vector<int> running(const PlanTree& tree) const;

private:
    std::vector<PlanActivity> states_;
    std::shared_ptr<const std::vector<std::string>> paths_;
    std::vector<int> node_of_path_;
    int strangers_ = 0;
    Seconds now_{0.0};
};

} // namespace usar::widgets
