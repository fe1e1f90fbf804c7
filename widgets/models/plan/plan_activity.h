// The state of a running plan, element by element, and its assignment to the nodes of a drawn plan.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/clock.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// The newest answer of a sense. All times are on the protocol clock, or on that of the recording, like
/// PlanSnapshot::now.
struct SenseAnswer {
    QString value;      ///< as the plan would write it: "0.31", "true", "'high"
    bool holds = false; ///< the comparison with this answer is true
    Seconds since{0.0}; ///< time at which the present verdict began
    Seconds asked{0.0}; ///< time of the newest answer
};

/// Activity of one element of the plan since the start of the run.
struct PlanActivity {
    bool running = false;               ///< on the path from the root to what was done in the newest cycle
    std::optional<Seconds> last_active; ///< nullopt: never
    std::uint64_t started = 0;
    std::uint64_t succeeded = 0;
    std::uint64_t failed = 0;          ///< failures and interruptions
    std::uint64_t skipped = 0;         ///< how often it was held back by its frequency or its retries
    QString hold_back;                 ///< why it is held back now, "its frequency: 1.2 s left"; empty if it is not
    std::optional<SenseAnswer> answer; ///< senses only; nullopt: not asked yet
};

/// The value of a key on the plan's blackboard.
struct BoardValue {
    QString key;
    QString value;   ///< as traces print it
    QString history; ///< its values, one per line, newest first; for a tooltip
    bool operator==(const BoardValue&) const = default;
};

/// State of a run at one moment. The paths are those of the engine (see PlanTree::find) and stay the same during a run,
/// so they are shared. `activities` has one entry per path.
struct PlanSnapshot {
    std::shared_ptr<const std::vector<std::string>> paths;
    std::vector<PlanActivity> activities;
    Seconds now{0.0};                ///< time of the snapshot
    std::vector<BoardValue> board{}; ///< sorted by key
};

/// The activity of each node of a tree. A node that is drawn once for several places has the sum of their counters and
/// the newest of their times and answers.
class PlanStates {
public:
    /// Sizes the states for this tree; all are empty.
    void reset(const PlanTree& tree);
    /// Takes over a snapshot; the nodes of its paths are looked up only when the paths have changed.
    void take(const PlanTree& tree, const PlanSnapshot& snapshot);

    const PlanActivity& operator[](PlanNodeId node) const { return states_[node.index()]; }
    Seconds now() const { return now_; }
    /// 1 while the node runs, then halved every `half_life`; 0 when that falls below 2 %.
    double recency(PlanNodeId node) const;
    /// Time after which the glow of a card has faded to one half.
    static constexpr Seconds half_life{2.0};
    /// Number of paths without a node; they belong to a different plan than the drawn one.
    int strangers() const { return strangers_; }
    /// The cards that run, in the order of the tree.
    std::vector<PlanNodeId> running(const PlanTree& tree) const;

private:
    std::vector<PlanActivity> states_;
    std::shared_ptr<const std::vector<std::string>> paths_;
    std::vector<PlanNodeId> node_of_path_;
    int strangers_ = 0;
    Seconds now_{0.0};
};

/// The moment of a run that a plan view shows. All times are on the protocol clock.
struct PlanTime {
    Seconds begin{0.0};      ///< start of the run
    Seconds end{0.0};        ///< newest moment known
    Seconds shown{0.0};      ///< the moment that is displayed
    std::uint64_t cycle = 0; ///< number of the cycle shown; 0: none
    std::size_t epoch = 0;   ///< epoch shown within the cycle, from 1; 0: the whole cycle
    std::size_t epochs = 1;  ///< number of epochs in the cycle
    bool live = true;        ///< follows the run
    bool replay = false;     ///< the run is a recording
};

} // namespace usar::widgets
