// Runs a program: each cycle decides anew what to do, by the data of the host and the time it passes.
#pragma once

#include <memory>

#include "core/posh/arbitration.h"
#include "core/posh/current_act.h"
#include "core/posh/descent.h"
#include "core/posh/drive_states.h"
#include "core/posh/engagements.h"
#include "core/posh/host.h"
#include "core/posh/profiler.h"
#include "core/posh/sense_memo.h"
#include "core/posh/tracer.h"

namespace usar::posh {

/// What a satisfied goal of the collection does: end the plan for good, or suspend it while the goal holds.
enum class OnGoal { Stop, Hold };

struct EngineOptions {
    int most_acts = 16; ///< per cycle (the budget); at least one runs
    OnGoal on_goal = OnGoal::Stop;
    ProfileClock* clock = nullptr; ///< measures durations, if there is one; must outlive the engine
    Milliseconds slow{20};         ///< a call of the host that takes longer is warned of
};

/// Equal programs, options, times and answers of the host give equal traces. After loading, a cycle allocates nothing
/// (the host may) and its work is bounded. Nothing that the host throws leaves it. Not to be called by host or observer
/// during a cycle, but for `note` and `site`. On one thread.
class Engine {
public:
    /// `host` must outlive the engine.
    Engine(Host& host, std::shared_ptr<const Program> program, EngineOptions options = {});
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    /// Stops, so that every init has its done.
    ~Engine();

    /// One cycle at that time of a clock that never goes back (an earlier time counts as the last).
    Outcome cycle(Milliseconds now);
    /// Ends the current act (stopped) and forgets all progress; a later cycle begins anew.
    void stop();
    /// Between cycles: stops, then goes on with another program. Cycles count on.
    void replace(std::shared_ptr<const Program> program);

    /// Between cycles: goes on where it is, with a program of the same shape (see sameShape).
    void retune(std::shared_ptr<const Program> program);

    /// Nothing: nobody watches.
    void watch(TraceObserver* observer) { tracer_.watch(observer, program_); }
    bool watched() const { return tracer_.watched(); }
    /// For the host, during its calls: what it wrote or sent, put into the trace at the place of that call.
    void note(TraceEvent event, Index place, std::string_view text) { tracer_.noteText(event, place, text); }
    /// A drive that is switched off is never ready.
    void switchDrive(Index drive, bool on) { drives_[drive].switched_off = !on; }

    const std::shared_ptr<const Program>& program() const { return program_; }
    std::uint64_t cycleNumber() const { return tracer_.cycle(); }
    /// In `acts` of the program; nowhere for none.
    Index currentAct() const { return act_.index(); }
    bool won() const { return won_; }

private:
    void load();
    Outcome runEpochs();
    bool goalHolds();
    Outcome reachGoal();
    void makeActive(Index winner);
    void noteBarren(Index drive);
    void close();
    void forgetProgress();

    EngineOptions options_;
    Host& host_;
    std::shared_ptr<const Program> program_;
    std::shared_ptr<const Program> bound_; ///< that the host knows: calls of this and `program_` are the same
    Tracer tracer_;
    Profiler profiler_;
    SenseMemo senses_;
    DriveStates drives_;
    Engagements engagements_;
    CurrentAct act_;
    Arbitration arbitration_;
    Descent descent_;
    Index active_ = nowhere; ///< the drive that won last
    int acts_ = 0;           ///< run in this cycle
    bool won_ = false;
};

} // namespace usar::posh
