// The plan of one robot and what it does, put together from what the robot publishes: now, and at any moment before.
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
#include "widgets/models/plan/plan_time.h"

namespace usar::widgets {

/// Keeps the trace of the run: a few bytes for each tick. Follows the run, or stands at a moment of it. A replay that
/// is wound back does not forget what it has heard: it is at an earlier moment of it. GUI thread.
class PlanWatch {
public:
    PlanWatch() = default;
    PlanWatch(const PlanWatch&) = delete;
    PlanWatch& operator=(const PlanWatch&) = delete;

    /// What a robot's session says at once.
    struct Update {
        std::span<const agent::Published> published{};
        Seconds now{0.0};       ///< protocol clock
        bool is_replay = false; ///< of a recorded run
        bool rewound = false;   ///< a replay was wound back; what is published is all there is now
    };

    /// Of what is shown. Plan: another one, or another text of it.
    enum class News { None, Activity, Plan };
    News take(const Update& update);
    /// What a replay of that robot's run is going to say, so that all of it can be gone to at once.
    void expect(const PlanWatch& flown) { expected_ = flown.history_.bytes(); }

    /// No plan has decided yet.
    bool empty() const { return !activity().program(); }
    const posh::Plan& plan() const { return reading_.plan; }
    const std::string& planText() const { return text_; }
    const posh::Findings& findings() const { return reading_.findings; }
    PlanSnapshot snapshot() const;
    /// What the shown state is of; null where it is empty.
    const std::shared_ptr<const posh::Program>& program() const { return activity().program(); }
    /// By place.
    const std::vector<std::string>& paths() const;

    PlanTime time() const;
    /// Of the run up to the shown moment; only where there is a program.
    const posh::RunStatistics& statistics() const { return activity().statistics(); }
    bool live() const { return !moment_; }
    News goLive();
    /// To the cycle that was the newest at that time.
    News goTo(Seconds time);
    /// So many cycles on or back. Beyond the newest it follows the run.
    News step(int cycles);
    /// One epoch on, within the shown cycle; None where it was the last.
    News stepEpoch();
    /// To the first epoch of the newest cycle, unless it has but one.
    News goToFirstEpoch();
    /// Of the cycle that is so many behind the shown one, or of the last that is known.
    Seconds timeOfStep(int cycles) const;

private:
    const posh::RunActivity& activity() const { return moment_ || !all_heard_ ? shown_ : history_.newest(); }
    void hear(const std::string& piece);
    void startWith(const std::string& trace);
    News refresh();
    /// Index of the newest moment heard so far (a replay may have been rewound); nullopt before the first.
    std::optional<std::size_t> heardMoment() const;
    std::optional<std::size_t> shownMoment() const { return moment_ ? moment_ : heardMoment(); }
    News goToMoment(std::optional<std::size_t> moment, std::optional<std::size_t> epoch);

    posh::RunHistory history_;
    std::string expected_;  ///< the trace of a run, as far as it is known from elsewhere
    std::size_t heard_ = 0; ///< bytes of `history_`, since a replay was wound back last
    bool all_heard_ = true;
    std::optional<std::size_t> moment_; ///< nothing: it follows
    std::optional<std::size_t> epoch_;  ///< of `moment_`
    bool is_replay_ = false;
    Seconds now_{0.0};        ///< the robot's clock
    posh::RunActivity shown_; ///< unless it is the newest of all
    std::shared_ptr<const posh::Program> program_;
    std::string text_;
    posh::PlanReading reading_;
    std::shared_ptr<const std::vector<std::string>> paths_;
};

} // namespace usar::widgets
