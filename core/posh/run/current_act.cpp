#include "core/posh/run/current_act.h"

namespace usar::posh {

void CurrentAct::load() {
    act_ = nowhere;
    does_nothing_.clear();
    for (const ProgramCall& call : tracer_.program()->act_calls) {
        const bool built_in = call.name == "doNothing" || call.name == "cz.cuni.amis.pogamut.sposh.executor.DoNothing";
        does_nothing_.push_back(built_in && !host_.hasAct(call.name));
    }
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
    const ProgramAct& here = actAt(act);
    tracer_.note(TraceEvent::ActInit, here.place);
    if (!does_nothing_[here.call] && !profiler_.call(here.place, [&] { host_.init({here.call, here.place}); }))
        return ActResult::Failed;
    return runOnce();
}

ActResult CurrentAct::runOnce() {
    const ProgramAct& here = actAt(act_);
    ActResult result = ActResult::RunningOnce;
    const std::int64_t begin_ns = profiler_.now();
    if (!does_nothing_[here.call] && !profiler_.call(here.place, [&] { result = host_.run({here.call, here.place}); }))
        result = ActResult::Failed;
    tracer_.note(TraceEvent::ActRun, here.place, static_cast<std::uint64_t>(profiler_.now() - begin_ns),
                 static_cast<std::uint8_t>(result));
    return result;
}

void CurrentAct::end(DoneReason reason) {
    if (act_ == nowhere)
        return;
    const ProgramAct& here = actAt(act_);
    tracer_.note(TraceEvent::ActDone, here.place, 0, static_cast<std::uint8_t>(reason));
    if (!does_nothing_[here.call])
        profiler_.call(here.place, [&] { host_.done({here.call, here.place}, reason); });
    act_ = nowhere;
}

} // namespace usar::posh
