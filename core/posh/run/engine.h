// Runs a program: each cycle decides again what to do, based on the host's senses and the time that is passed in.
#pragma once

#include <memory>

#include "core/posh/run/current_act.h"
#include "core/posh/run/descent.h"
#include "core/posh/run/drive_states.h"
#include "core/posh/run/engagements.h"
#include "core/posh/run/host.h"
#include "core/posh/run/sense_memo.h"
#include "core/posh/run/tracer.h"

namespace usar::posh {

/// The effect of a satisfied goal of the collection: it ends the plan for good, or suspends it while the goal holds.
enum class OnGoal { Stop, Hold };

struct EngineOptions {
    int most_acts = 16; ///< budget of acts per cycle; at least one runs even if this is smaller
    OnGoal on_goal = OnGoal::Stop;
    ProfileClock* clock = nullptr; ///< measures durations; nullptr turns measuring off; must outlive the engine
    Milliseconds slow{20};         ///< a call of the host that takes longer causes a warning; needs a clock
};

/// Equal programs, options, times and answers of the host give equal traces. After loading, a cycle allocates no memory
/// (the host may) and its work is bounded. Exceptions from the host are traced and never leave the engine. All calls
/// must come from one thread. During a cycle, the host and the observer must not call the engine, except that the host
/// may call `note`.
class Engine {
public:
    /// Loads the program and binds the host to it. `host` must outlive the engine; `program` must not be null.
    Engine(Host& host, std::shared_ptr<const Program> program, EngineOptions options = {});
    Engine(const Engine&) = delete;
    Engine& operator=(const Engine&) = delete;
    /// Stops first, so that every init of an act has its done.
    ~Engine();

    /// Runs one cycle. `now` is the time of a clock with any starting point that never runs backward; an earlier time
    /// than in the last cycle counts as that one.
    Outcome cycle(Milliseconds now);
    /// Ends the current act as stopped and forgets all progress, including a reached goal; a later cycle starts from
    /// the beginning.
    void stop();
    /// Stops, then continues with another program. Call it between cycles. The cycle number keeps counting.
    void replace(std::shared_ptr<const Program> program);

    /// Replaces the program by one of the same shape (a precondition, see sameShape) and keeps all progress. Call it
    /// between cycles.
    void retune(std::shared_ptr<const Program> program);

    /// Sets the observer of the trace, which must outlive the engine; nullptr removes it.
    void watch(TraceObserver* observer) { tracer_.watch(observer); }
    bool watched() const { return tracer_.watched(); }
    /// Adds to the trace what the host wrote or sent. For the host, during one of its calls, with the place of that
    /// call.
    void note(TraceEvent event, Index place, std::string_view text) { tracer_.noteText(event, place, text); }
    /// Switches a drive (an index in Program::drives) on or off. A drive that is off is never ready.
    void switchDrive(Index drive, bool on) { drives_[drive].switched_off = !on; }

    const std::shared_ptr<const Program>& program() const { return tracer_.program(); }
    /// The number of the last cycle, counting from 1; 0 before the first.
    std::uint64_t cycleNumber() const { return tracer_.cycle(); }
    /// The current act as an index in Program::acts; `nowhere` if there is none.
    Index currentAct() const { return act_.index(); }
    /// Whether the goal of the collection ended the plan for good (OnGoal::Stop).
    bool won() const { return won_; }

private:
    void load();
    Outcome runEpochs();
    /// Returns the drive that runs in this epoch, or `nowhere` if none is ready. Searches the levels in order of
    /// priority. Within a level a ready drive that is in progress keeps running; the others take turns, starting after
    /// the one that ended last.
    Index choose();
    /// Returns the winner within one level, or `nowhere`.
    Index chooseIn(Index level);
    bool ready(Index drive);
    /// Returns whether the drive's frequency forbids a start now.
    bool heldBack(Index drive);
    Outcome reachGoal();
    void makeActive(Index winner);
    void noteBarren(Index drive);
    void forgetProgress();

    EngineOptions options_;
    Host& host_;
    std::shared_ptr<const Program>
        bound_;     ///< the program that the host was bound to; has the same calls as the one that runs
    Tracer tracer_; ///< owns the program
    Profiler profiler_;
    SenseMemo senses_;
    DriveStates drives_;
    Engagements engagements_;
    CurrentAct act_;
    Descent descent_;
    Index active_ = nowhere; ///< the drive that won last
    int acts_ = 0;           ///< number of acts run in this cycle
    bool won_ = false;
};

} // namespace usar::posh
