#include "core/posh/trace/run_activity.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/posh/run/value_text.h"

namespace usar::posh {

namespace {

/// Says what holds a drive back: "its frequency: 1.2 s left".
std::string frequencyText(const Program& program, const TraceRecord& record) {
    if (record.skip() == SkipReason::SwitchedOff)
        return "switched off by hand";
    const auto left = std::bit_cast<double>(record.payload);
    const ProgramDrive& drive = program.drives[program.places[record.place].item];
    if (drive.interval_cycles > 0.0)
        return "its frequency: " + std::to_string(static_cast<std::int64_t>(left)) + " cycles left";
    const auto tenths = static_cast<std::int64_t>(left / 100.0 + 0.5);
    return "its frequency: " + std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10) + " s left";
}

} // namespace

void RunActivity::start(std::shared_ptr<const Program> program) {
    if (!program_ || !program)
        board_.clear();
    program_ = std::move(program);
    statistics_ = {};
    if (program_)
        statistics_.takeProgram(program_);
    places_.assign(program_ ? program_->places.size() : 0, {});
    running_.clear();
    held_.clear();
}

void RunActivity::beginCycle(std::int64_t now_ms) {
    now_ms_ = now_ms;
    for (const Index place : std::exchange(running_, {}))
        places_[place].running = false;
    for (const Index place : std::exchange(held_, {}))
        places_[place].hold_back.clear();
}

void RunActivity::activate(Index place) {
    for (Index at = place; at != nowhere; at = program_->places[at].parent) {
        places_[at].last_active_ms = now_ms_;
        if (!std::exchange(places_[at].running, true))
            running_.push_back(at);
    }
}

void RunActivity::holdBack(Index place, std::string why) {
    places_[place].hold_back = std::move(why);
    held_.push_back(place);
}

void RunActivity::answer(PlaceActivity& place, const TraceRecord& record, std::string_view text) const {
    const bool holds = (record.flags & trace_holds) != 0;
    const bool same = place.answer && place.answer->holds == holds;
    place.answer =
        PlaceAnswer{answerOf(record, text), holds, same ? place.answer->since_ms : record.time_ms, record.time_ms};
}

void RunActivity::write(const TraceRecord& record, std::string_view text) {
    const auto change = readBoardChange(text);
    if (!change)
        return;
    auto entry = std::ranges::lower_bound(board_, change->key, {},
                                          [](const BoardEntry& one) -> std::string_view { return one.key; });
    if (entry == board_.end() || entry->key != change->key)
        entry = board_.insert(entry, {std::string(change->key), {}, 0});
    ++entry->writes;
    if (entry->values.size() == BoardEntry::most_values)
        entry->values.erase(entry->values.begin());
    entry->values.push_back({std::string(change->new_value), record.time_ms, record.place});
}

void RunActivity::take(const TraceRecord& record, std::string_view text) {
    statistics_.take(record, text);
    if (record.event == TraceEvent::CycleBegin)
        return beginCycle(record.time_ms);
    if (record.event == TraceEvent::CycleEnd || record.place >= places_.size())
        return;
    PlaceActivity& place = places_[record.place];
    const PlaceCounts& counts = statistics_.at(record.place);
    place.started = counts.started;
    place.succeeded = counts.succeeded;
    place.failed = counts.failed + counts.interrupted;
    place.skipped = counts.skipped;
    switch (record.event) {
    case TraceEvent::SenseEval:
        return answer(place, record, text);
    case TraceEvent::DriveSkipped:
        if (program_->places[record.place].kind == PlaceKind::Drive) // A damaged trace may say otherwise
            holdBack(record.place, frequencyText(*program_, record));
        return;
    case TraceEvent::Blackboard:
        return write(record, text);
    case TraceEvent::ElementSkipped:
        return holdBack(record.place, "its retries are used up");
    case TraceEvent::DriveStarted:
    case TraceEvent::ElementSelected:
    case TraceEvent::Push:
    case TraceEvent::ActInit:
    case TraceEvent::ActRun:
        return activate(record.place);
    default:
        return;
    }
}

} // namespace usar::posh
