// The plan of one robot and its activity, now or at any earlier moment, from the traces that the robot publishes.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/mission/session/session_update.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/trace/run_history.h"
#include "widgets/models/plan/plan_activity.h"
#include "widgets/models/plan/plan_time.h"

namespace usar::app {

/// Keeps the trace of the run, a few bytes per tick, and shows one moment of it: it follows the run, or stays at a
/// chosen moment. If a replay is rewound, the trace heard so far is kept, and an earlier moment of it is shown. One
/// moment is one cycle of the plan. GUI thread.
class PlanWatch {
public:
    PlanWatch() = default;
    PlanWatch(const PlanWatch&) = delete;
    PlanWatch& operator=(const PlanWatch&) = delete;

    /// The change of what is shown. Plan: another plan, or another text of it; this includes the activity.
    enum class News { None, Activity, Plan };
    News take(const mission::SessionUpdate& update);
    /// For a replay of the robot that `flown` watches: its trace is expected to come again, so that all of its moments
    /// can be shown at once. Call it before the replay has published anything.
    void expect(const PlanWatch& flown) { expected_ = flown.history_.bytes(); }

    /// True if no plan decides at the shown moment.
    bool empty() const { return !activity().program(); }
    /// The plan, its text and the problems in it. While `empty` they are those of the last plan, if there was one.
    const posh::Plan& plan() const { return reading_.plan; }
    const std::string& planText() const { return text_; }
    const posh::Findings& findings() const { return reading_.findings; }
    widgets::PlanSnapshot snapshot() const;
    /// The program of the shown plan; null while `empty`.
    const std::shared_ptr<const posh::Program>& program() const { return activity().program(); }
    /// Paths of the program's places, by index; empty while `empty`.
    const std::vector<std::string>& paths() const;

    /// The shown moment and the limits of the run; cycle 0 if nothing is known.
    widgets::PlanTime time() const;
    /// Statistics of the run up to the shown moment. Must not be called while `empty`.
    const posh::RunStatistics& statistics() const { return activity().statistics(); }
    /// True while it follows the run.
    bool live() const { return !moment_; }
    News goLive();
    /// Shows the cycle that was the newest at that time (protocol clock).
    News goTo(Seconds time);
    /// Shows the cycle that is so many cycles later, or earlier if negative. At the newest it follows the run.
    News step(int cycles);
    /// Shows the next epoch of the shown cycle; None if the last one, or the whole cycle, is shown.
    News stepEpoch();
    /// Shows the first epoch of the newest cycle; None if the cycle has only one.
    News goToFirstEpoch();
    /// Time of the cycle that is so many cycles after the shown one, limited to the known ones; 0 if none is shown.
    Seconds timeOfStep(int cycles) const;

private:
    /// The activity at the shown moment.
    const posh::RunActivity& activity() const { return moment_ || !all_heard_ ? shown_ : history_.newest(); }
    void hear(const std::string& piece);
    /// Replaces the history by this trace and follows it.
    void startWith(const std::string& trace);
    /// Computes what is shown after any change.
    News refresh();
    /// Index of the newest moment heard so far (a replay may have been rewound); nullopt before the first.
    std::optional<std::size_t> heardMoment() const;
    std::optional<std::size_t> shownMoment() const { return moment_ ? moment_ : heardMoment(); }
    /// Shows this moment, or follows the run for nullopt.
    News goToMoment(std::optional<std::size_t> moment, std::optional<std::size_t> epoch);

    posh::RunHistory history_;
    std::string expected_;  ///< the trace that a replay is expected to publish; empty: unknown
    std::size_t heard_ = 0; ///< number of bytes of `history_` heard since the start or since the last rewind
    bool all_heard_ = true; ///< `heard_` is all of `history_`
    std::optional<std::size_t> moment_; ///< chosen moment, as an index in the history; nullopt: it follows the run
    std::optional<std::size_t> epoch_;  ///< epoch of `moment_` that is shown; nullopt: the whole cycle
    bool is_replay_ = false;
    Seconds now_{0.0};        ///< the robot's clock
    posh::RunActivity shown_; ///< activity at the shown moment, unless that is the newest of the history
    std::shared_ptr<const posh::Program> program_; ///< the program at the last refresh
    std::string text_;
    posh::PlanReading reading_;
    std::shared_ptr<const std::vector<std::string>> paths_;
};

} // namespace usar::app
