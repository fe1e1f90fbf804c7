#include "core/mission/claims/plan_watch.h"

#include "core/posh/run/program.h"

namespace usar::mission {

namespace {

bool isRun(posh::TraceEvent event) {
    return event == posh::TraceEvent::DriveStarted || event == posh::TraceEvent::Push ||
           event == posh::TraceEvent::ElementSelected || event == posh::TraceEvent::ActRun;
}

} // namespace

void PlanWatch::take(std::string_view piece, const Tell& ran) {
    if (piece.starts_with(posh::trace_codec::magic))
        clear();
    bytes_ += piece;
    if (file_) {
        file_->extend(bytes_);
    } else if (auto opened = posh::TraceFile::open(bytes_)) {
        file_ = *std::move(opened);
        next_ = file_->begin();
    } else {
        return;
    }
    while (const posh::TracedCycle* const cycle = next_->next()) {
        program_ = cycle->program;
        const Seconds time{static_cast<double>(cycle->time_ms) / 1000.0};
        for (const posh::trace_codec::Entry& entry : cycle->events)
            if (isRun(entry.record.event) && program_ && entry.record.place < program_->places.size())
                ran(posh::nameOf(*program_, entry.record.place), time);
    }
}

void PlanWatch::clear() {
    bytes_.clear();
    next_.reset();
    file_.reset();
    program_.reset();
}

bool PlanWatch::has(std::string_view name) const {
    for (std::size_t place = 0; program_ && place < program_->places.size(); ++place)
        if (posh::nameOf(*program_, static_cast<posh::Index>(place)) == name)
            return true;
    return false;
}

} // namespace usar::mission
