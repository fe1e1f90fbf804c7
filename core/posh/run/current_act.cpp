#include "core/posh/run/current_act.h"

#include <exception>

namespace usar::posh {

void CurrentAct::load(const Program& program) {
    program_ = &program;
    act_ = nowhere;
    does_nothing_.clear();
    for (const ProgramCall& call : program.act_calls) {
        const bool built_in = call.name == "doNothing" || call.name == "cz.cuni.amis.pogamut.sposh.executor.DoNothing";
        does_nothing_.push_back(built_in && !host_.hasAct(call.name));
    }
}

/// Calls the host; traces an exception as an error and then returns false.
template <class Call>
bool CurrentAct::guarded(Index place, Call&& call) {
    const Profiler::Span span(profiler_, place);
    try {
        call(CallSite{program_->acts[act_].call, place});
        return true;
    } catch (const std::exception& thrown) {
        tracer_.noteText(TraceEvent::Error, place, thrown.what());
    } catch (...) {
        tracer_.noteText(TraceEvent::Error, place, "it threw something that is no std::exception");
    }
    return false;
}

ActResult CurrentAct::run(Index act) {
    const ActResult result = act == act_ ? runOnce() : begin(act);
    last_run_ = tracer_.cycle();
    if (result != ActResult::Running)
        end(result == ActResult::Failed ? DoneReason::Failed : DoneReason::Finished);
    return result;
}

ActResult CurrentAct::begin(Index act) {
    end(DoneReason::Interrupted);
    act_ = act;
    const ProgramAct& here = program_->acts[act];
    tracer_.note(TraceEvent::ActInit, here.place);
    if (!does_nothing_[here.call] && !guarded(here.place, [this](CallSite site) { host_.init(site); }))
        return ActResult::Failed;
    return runOnce();
}

ActResult CurrentAct::runOnce() {
    const ProgramAct& here = program_->acts[act_];
    ActResult result = ActResult::RunningOnce;
    const std::int64_t begin_ns = profiler_.now();
    if (!does_nothing_[here.call] && !guarded(here.place, [&](CallSite site) { result = host_.run(site); }))
        result = ActResult::Failed;
    tracer_.note(TraceEvent::ActRun, here.place, static_cast<std::uint64_t>(profiler_.now() - begin_ns),
                 static_cast<std::uint8_t>(result));
    return result;
}

void CurrentAct::end(DoneReason reason) {
    if (act_ == nowhere)
        return;
    const ProgramAct& here = program_->acts[act_];
    tracer_.note(TraceEvent::ActDone, here.place, 0, static_cast<std::uint8_t>(reason));
    if (!does_nothing_[here.call])
        guarded(here.place, [&](CallSite site) { host_.done(site, reason); });
    act_ = nowhere;
}

} // namespace usar::posh
