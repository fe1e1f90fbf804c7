#include "core/mission/claims/plan_watch.h"

#include "core/posh/run/program.h"

namespace usar::mission {

namespace {

bool isRun(posh::TraceEvent event) {
    return event == posh::TraceEvent::DriveStarted || event == posh::TraceEvent::Push ||
           event == posh::TraceEvent::ElementSelected || event == posh::TraceEvent::ActRun;
}

} // namespace

void PlanWatch::take(std::string_view piece, const Tell& ran, const std::function<void(Seconds)>& cycled) {
    if (piece.starts_with(posh::trace_codec::magic)) {
        bytes_.clear();
        file_.reset();
        next_ = 1;
    }
    bytes_ += piece;
    if (file_)
        file_->extend(bytes_);
    else if (auto opened = posh::TraceFile::open(bytes_))
        file_ = *std::move(opened);
    else
        return;
    auto cursor = file_->seek(next_);
    while (const posh::TracedCycle* const cycle = cursor.next()) {
        if (cycle->number < next_)
            continue;
        next_ = cycle->number + 1;
        program_ = cycle->program;
        const Seconds time{static_cast<double>(cycle->time_ms) / 1000.0};
        for (const posh::trace_codec::Entry& entry : cycle->events)
            if (isRun(entry.record.event) && cycle->program && entry.record.place < cycle->program->places.size())
                ran(posh::nameOf(*cycle->program, entry.record.place), time);
        if (cycled)
            cycled(time);
    }
}

bool PlanWatch::has(std::string_view name) const {
    for (std::size_t place = 0; program_ && place < program_->places.size(); ++place)
        if (posh::nameOf(*program_, static_cast<posh::Index>(place)) == name)
            return true;
    return false;
}

} // namespace usar::mission
