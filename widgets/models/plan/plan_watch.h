// The plan of one robot and its activity, now and at any earlier moment, assembled from what the robot publishes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/agent/published.h"
#include "core/base/clock.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/trace/run_history.h"
#include "widgets/models/plan/plan_activity.h"

namespace usar::widgets {

/// Keeps the trace of the run: a few bytes per tick. Either follows the run or shows an earlier moment of it. When a
/// replay is rewound, the known trace is kept, and an earlier moment of it becomes the current one. GUI thread.
class PlanWatch {
public:
    /// Data of one update from a robot's session.
    struct Update {
        std::span<const agent::Published> published{};
        Seconds now{0.0};       ///< protocol clock
        bool is_replay = false; ///< the run comes from a recording
        bool rewound = false;   ///< a replay was rewound; `published` replaces everything before it
    };

    /// The change in what is shown. Plan: another plan, or another text of the same plan.
    enum class News { None, Activity, Plan };
    /// Returns what has changed; while an earlier moment is shown, new data changes only the time.
    News take(const Update& update);
    /// Takes the trace of the run that a replay is about to repeat, so that every moment can be shown from the start.
    void expect(const PlanWatch& flown) { expected_ = flown.history_.bytes(); }

    /// True if the shown state has no program, because no plan has run yet.
    bool empty() const { return !activity().program(); }
    const posh::Plan& plan() const { return reading_.plan; }
    const std::string& planText() const { return text_; }
    const posh::Findings& findings() const { return reading_.findings; }
    PlanSnapshot snapshot() const;
    /// The program of the shown state; null if there is none.
    const std::shared_ptr<const posh::Program>& program() const { return activity().program(); }
    /// Paths of all places of the program, by place.
    const std::vector<std::string>& paths() const;

    PlanTime time() const;
    /// Statistics of the run up to the shown moment. Requires a program.
    const posh::RunStatistics& statistics() const { return activity().statistics(); }
    /// True while it follows the run.
    bool live() const { return !moment_; }
    /// Follows the run again. This and the following return what has changed.
    News goLive() { return goToMoment(std::nullopt, std::nullopt); }
    /// Goes to the cycle that was the newest at that time of the protocol clock.
    News goTo(Seconds time);
    /// Goes forward (or back, if negative) by this many cycles. From the newest cycle on, it follows the run.
    News step(int cycles);
    /// Goes to the next epoch within the shown cycle; returns None if that was the last.
    News stepEpoch();
    /// Goes to the first epoch of the newest cycle; returns None if it has only one.
    News goToFirstEpoch();
    /// Time of the cycle that is `cycles` after the shown one, limited to the known cycles; 0 if none is shown.
    Seconds timeOfStep(int cycles) const;

private:
    const posh::RunActivity& activity() const { return moment_ || !all_heard_ ? shown_ : history_.newest(); }
    /// Takes the next piece of the trace.
    void hear(const std::string& piece);
    /// Forgets the known run and starts again with this trace.
    void startWith(const std::string& trace);
    /// Computes what is shown at the present moment, and reads its plan if it is another one.
    News refresh();
    /// Index of the newest moment heard so far (a replay may have been rewound); nullopt before the first.
    std::optional<std::size_t> heardMoment() const;
    std::optional<std::size_t> shownMoment() const { return moment_ ? moment_ : heardMoment(); }
    News goToMoment(std::optional<std::size_t> moment, std::optional<std::size_t> epoch);

    posh::RunHistory history_;
    std::string expected_;  ///< trace of the run from expect(); empty: unknown
    std::size_t heard_ = 0; ///< bytes of `history_` received since the last rewind of a replay
    bool all_heard_ = true;
    std::optional<std::size_t> moment_; ///< the shown moment; nullopt: follows the run
    std::optional<std::size_t> epoch_;  ///< the shown epoch of `moment_`; nullopt: all of it
    bool is_replay_ = false;
    Seconds now_{0.0};        ///< protocol clock
    posh::RunActivity shown_; ///< the shown state, unless it is the newest in `history_`
    std::shared_ptr<const posh::Program> program_;
    std::string text_;
    posh::PlanReading reading_;
    std::shared_ptr<const std::vector<std::string>> paths_;
};

} // namespace usar::widgets
