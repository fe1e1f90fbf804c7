#include "core/posh/run/engine.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace usar::posh {

namespace {

constexpr int starving_after = 10; ///< number of cycles in a row in which the winning drive ran no act

} // namespace

Engine::Engine(Host& host, std::shared_ptr<const Program> program, EngineOptions options)
    : options_(options)
    , host_(host)
    , program_(std::move(program))
    , profiler_(tracer_, options.clock, options.slow)
    , senses_(host, tracer_, profiler_)
    , drives_(tracer_)
    , engagements_(tracer_)
    , act_(host, tracer_, profiler_)
    , arbitration_(tracer_, senses_, drives_)
    , descent_({tracer_, senses_, drives_, engagements_, act_}) {
    load();
}

Engine::~Engine() {
    stop();
}

void Engine::load() {
    senses_.load(*program_);
    drives_.load(*program_);
    engagements_.load(*program_);
    act_.load(*program_);
    arbitration_.load(*program_);
    descent_.load(*program_);
    host_.bind(*program_);
    bound_ = program_;
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
        close();
    }
    tracer_.note(TraceEvent::CycleEnd, static_cast<Index>(acts_),
                 static_cast<std::uint64_t>(profiler_.now() - begin_ns), static_cast<std::uint8_t>(outcome));
    return outcome;
}

Outcome Engine::runEpochs() {
    for (;;) {
        senses_.beginEpoch();
        if (goalHolds())
            return reachGoal();
        makeActive(arbitration_.choose(active_));
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
            tracer_.warn(WarningCode::Budget, program_->drives[active_].place, "the cycle's budget of acts is used up");
            return Outcome::Budget;
        }
    }
}

bool Engine::goalHolds() {
    return !program_->goal.empty() && senses_.allHold(program_->goal);
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
        engagements_.endWithin(program_->drives[active_].forms);
    }
    active_ = winner;
}

void Engine::noteBarren(Index drive) {
    DriveState& state = drives_[drive];
    const bool in_a_row = state.last_barren_cycle + 1 == tracer_.cycle();
    state.barren_cycles = in_a_row ? state.barren_cycles + 1 : 1;
    state.last_barren_cycle = tracer_.cycle();
    if (state.barren_cycles == starving_after)
        tracer_.warn(WarningCode::StarvingDrive, program_->drives[drive].place,
                     "starving: its trigger holds, but for ten cycles it found nothing to do");
}

void Engine::close() {
    if (!act_.ranIn(tracer_.cycle()))
        act_.end(DoneReason::Interrupted);
    engagements_.endUnvisited();
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
    const std::shared_ptr<const Program> old = std::exchange(program_, std::move(program));
    load();
    tracer_.announce(program_);
}

void Engine::retune(std::shared_ptr<const Program> program) {
    assert(sameShape(*program_, *program));
    const std::shared_ptr<const Program> old = std::exchange(program_, std::move(program));
    senses_.retune(*program_);
    drives_.retune(*program_);
    engagements_.retune(*program_);
    act_.retune(*program_);
    arbitration_.load(*program_);
    descent_.retune(*program_);
    tracer_.announce(program_);
}

} // namespace usar::posh
