#include "core/posh/run/engine.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace usar::posh {

Engine::Engine(Host& host, std::shared_ptr<const Program> program, EngineOptions options)
    : options_(options)
    , host_(host)
    , tracer_(std::move(program))
    , profiler_(tracer_, options.clock, options.slow)
    , senses_(host, tracer_, profiler_)
    , drives_(tracer_)
    , engagements_(tracer_)
    , act_(host, tracer_, profiler_)
    , descent_({tracer_, senses_, drives_, engagements_, act_}) {
    load();
}

Engine::~Engine() {
    stop();
}

void Engine::load() {
    senses_.load();
    drives_.load();
    engagements_.load();
    act_.load();
    descent_.load();
    host_.bind(*program());
    bound_ = program();
}

Outcome Engine::cycle(Milliseconds now) {
    const std::int64_t begin_ns = profiler_.now();
    const bool is_first = tracer_.cycle() == 0; // A clock may start below zero
    tracer_.setCycle(tracer_.cycle() + 1, is_first ? now : std::max(now, tracer_.now()));
    tracer_.note(TraceEvent::CycleBegin, 0);
    acts_ = 0;
    Outcome outcome = Outcome::Won;
    if (!won_) {
        outcome = runEpochs();
        if (!act_.ranIn(tracer_.cycle()))
            act_.end(DoneReason::Interrupted);
        engagements_.endUnvisited();
    }
    tracer_.note(TraceEvent::CycleEnd, static_cast<Index>(acts_),
                 static_cast<std::uint64_t>(profiler_.now() - begin_ns), static_cast<std::uint8_t>(outcome));
    return outcome;
}

Outcome Engine::runEpochs() {
    for (;;) {
        senses_.beginEpoch();
        if (!program()->goal.empty() && senses_.allHold(program()->goal))
            return reachGoal();
        makeActive(choose());
        if (active_ == nowhere)
            return acts_ > 0 ? Outcome::Fired : Outcome::Idle;
        if (!drives_[active_].in_progress)
            drives_.start(active_);
        const auto result = descent_.step(active_);
        if (!result && acts_ > 0)
            return Outcome::Fired;
        if (!result) {
            noteBarren(active_);
            return Outcome::NoAction;
        }
        ++acts_;
        if (*result != ActResult::Finished)
            return Outcome::Fired;
        if (acts_ >= options_.most_acts) {
            tracer_.warn(WarningCode::Budget, program()->drives[active_].place,
                         "the cycle's budget of acts is used up");
            return Outcome::Budget;
        }
    }
}

Index Engine::choose() {
    for (Index level = 0; level < program()->levels.size(); ++level)
        if (const Index winner = chooseIn(level); winner != nowhere)
            return winner;
    return nowhere;
}

Index Engine::chooseIn(Index level) {
    const Range drives = program()->levels[level];
    const bool has_active = drives.contains(active_) && drives_[active_].in_progress;
    if (has_active && ready(active_))
        return active_;
    const Index count = drives.end - drives.first;
    const Index last = drives_.lastEnded(level);
    const Index begin = last == nowhere ? 0 : last - drives.first + 1;
    for (Index turn = 0; turn < count; ++turn) {
        const Index drive = drives.first + (begin + turn) % count;
        if (!(has_active && drive == active_) && ready(drive))
            return drive;
    }
    return nowhere;
}

bool Engine::ready(Index drive) {
    const DriveState& state = drives_[drive];
    if (state.switched_off) {
        tracer_.note(TraceEvent::DriveSkipped, program()->drives[drive].place, payloadOf(0.0),
                     static_cast<std::uint8_t>(SkipReason::SwitchedOff));
        return false;
    }
    if (!state.in_progress && state.ever_started && heldBack(drive))
        return false;
    return senses_.allHold(program()->drives[drive].trigger);
}

bool Engine::heldBack(Index drive) {
    const ProgramDrive& here = program()->drives[drive];
    const DriveState& state = drives_[drive];
    double left = here.interval_ms - static_cast<double>((tracer_.now() - state.last_start).count());
    if (here.interval_cycles > 0.0)
        left = here.interval_cycles - static_cast<double>(tracer_.cycle() - state.last_start_cycle);
    if (left <= 0.0)
        return false;
    tracer_.note(TraceEvent::DriveSkipped, here.place, payloadOf(left),
                 static_cast<std::uint8_t>(SkipReason::Frequency));
    return true;
}

Outcome Engine::reachGoal() {
    act_.end(DoneReason::Goal);
    forgetProgress();
    won_ = options_.on_goal == OnGoal::Stop;
    return Outcome::GoalSatisfied;
}

void Engine::makeActive(Index winner) {
    if (active_ != nowhere && active_ != winner && drives_[active_].in_progress) {
        act_.end(DoneReason::Interrupted);
        drives_.interrupt(active_, winner);
        engagements_.endWithin(program()->drives[active_].forms);
    }
    active_ = winner;
}

void Engine::noteBarren(Index drive) {
    constexpr int starving_after = 10; // Cycles in a row in which the winning drive ran no act
    DriveState& state = drives_[drive];
    const bool in_a_row = state.last_barren_cycle + 1 == tracer_.cycle();
    state.barren_cycles = in_a_row ? state.barren_cycles + 1 : 1;
    state.last_barren_cycle = tracer_.cycle();
    if (state.barren_cycles == starving_after)
        tracer_.warn(WarningCode::StarvingDrive, program()->drives[drive].place,
                     "starving: its trigger holds, but for ten cycles it found nothing to do");
}

void Engine::forgetProgress() {
    drives_.clear();
    engagements_.endAll();
    active_ = nowhere;
}

void Engine::stop() {
    act_.end(DoneReason::Stopped);
    forgetProgress();
    won_ = false;
}

void Engine::replace(std::shared_ptr<const Program> program) {
    stop();
    const auto old = tracer_.setProgram(std::move(program));
    load();
    tracer_.announce();
}

void Engine::retune(std::shared_ptr<const Program> program) {
    assert(sameShape(*tracer_.program(), *program));
    const auto old = tracer_.setProgram(std::move(program));
    tracer_.announce();
}

} // namespace usar::posh
