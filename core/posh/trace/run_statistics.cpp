#include "core/posh/trace/run_statistics.h"

#include <algorithm>

namespace usar::posh {

namespace {

/// Returns whether the indices of places have the same meaning in both programs.
bool samePlaces(const Program& a, const Program& b) {
    return std::ranges::equal(a.places, b.places, [&](const Place& x, const Place& y) {
        return x.kind == y.kind && x.parent == y.parent && x.position == y.position && x.reference == y.reference &&
               a.names[x.name] == b.names[y.name];
    });
}

using Counter = std::uint64_t PlaceCounts::*;

/// Returns the counter of a place that an event there counts up; nullptr if there is none.
Counter counterOf(const TraceRecord& record) {
    switch (record.event) {
    case TraceEvent::SenseEval:
        return &PlaceCounts::asked;
    case TraceEvent::DriveStarted:
    case TraceEvent::Push:
    case TraceEvent::ElementSelected:
    case TraceEvent::ActInit:
        return &PlaceCounts::started;
    case TraceEvent::DriveSucceeded:
    case TraceEvent::Goal:
        return &PlaceCounts::succeeded;
    case TraceEvent::DriveFailed:
    case TraceEvent::NoElement:
    case TraceEvent::Timeout:
        return &PlaceCounts::failed;
    case TraceEvent::DriveInterrupted:
        return &PlaceCounts::interrupted;
    case TraceEvent::DriveSkipped:
    case TraceEvent::ElementSkipped:
        return &PlaceCounts::skipped;
    case TraceEvent::ActRun:
        return &PlaceCounts::runs;
    case TraceEvent::ActDone:
        return record.reason() == DoneReason::Finished ? &PlaceCounts::succeeded
               : record.reason() == DoneReason::Failed ? &PlaceCounts::failed
                                                       : &PlaceCounts::interrupted;
    default:
        return nullptr;
    }
}

} // namespace

void RunStatistics::takeProgram(const std::shared_ptr<const Program>& program) {
    const bool goes_on = program_ && samePlaces(*program_, *program);
    program_ = program;
    winner_ = nowhere;
    acting_ = nowhere;
    switches_.clear();
    if (goes_on)
        return;
    counts_.assign(program->places.size(), {});
    cycles_ = 0;
    alternations_.clear();
    starved_.clear();
    spun_.clear();
}

void RunStatistics::take(const TraceRecord& record, std::string_view) {
    if (record.event == TraceEvent::CycleEnd || record.place >= counts_.size())
        return;
    PlaceCounts& counts = counts_[record.place];
    counts.last_cycle = record.cycle;
    if (const auto counter = counterOf(record))
        ++(counts.*counter);
    switch (record.event) {
    case TraceEvent::CycleBegin:
        return beginCycle(record.time_ms);
    case TraceEvent::SenseEval:
        counts.held += record.flags & trace_holds ? 1 : 0;
        return;
    case TraceEvent::DriveStarted:
        return noteWinner(record);
    case TraceEvent::ActRun:
        acting_ = record.place;
        counts.spent_ns += record.payload;
        counts.longest_ns = std::max(counts.longest_ns, record.payload);
        return;
    case TraceEvent::Warning:
        return countWarning(record);
    default:
        return;
    }
}

/// Counts the time since the last cycle for the act that was run last in it.
void RunStatistics::beginCycle(std::int64_t now_ms) {
    ++cycles_;
    const std::int64_t passed_ms = now_ms - std::exchange(now_ms_, now_ms);
    for (Index at = std::exchange(acting_, nowhere); at != nowhere; at = program_->places[at].parent)
        counts_[at].active_ms += passed_ms;
}

void RunStatistics::countWarning(const TraceRecord& record) {
    if (record.warning() == WarningCode::StarvingDrive)
        ++starved_[record.place];
    else if (record.warning() == WarningCode::Budget)
        ++spun_[record.place];
}

/// Counts a switch if another drive started than the last time.
void RunStatistics::noteWinner(const TraceRecord& record) {
    const Index before = std::exchange(winner_, record.place);
    if (before == nowhere || before == record.place)
        return;
    const std::pair<Index, Index> drives = std::minmax(before, record.place);
    std::erase_if(switches_,
                  [&record](const Switch& old) { return record.time_ms - old.time_ms >= alternation_within_ms; });
    switches_.push_back({record.time_ms, drives});
    const auto count = static_cast<int>(std::ranges::count(switches_, drives, &Switch::drives));
    Alternation& known = alternations_[drives];
    if (count > known.most)
        known = {count, record.cycle};
}

bool RunStatistics::add(const RunStatistics& other) {
    if (!program_ || !other.program_ || !samePlaces(*program_, *other.program_))
        return false;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
        PlaceCounts& mine = counts_[i];
        const PlaceCounts& theirs = other.counts_[i];
        for (const Counter sum : {&PlaceCounts::asked, &PlaceCounts::held, &PlaceCounts::started,
                                  &PlaceCounts::succeeded, &PlaceCounts::failed, &PlaceCounts::interrupted,
                                  &PlaceCounts::skipped, &PlaceCounts::runs, &PlaceCounts::spent_ns})
            mine.*sum += theirs.*sum;
        mine.active_ms += theirs.active_ms;
        mine.longest_ns = std::max(mine.longest_ns, theirs.longest_ns);
        mine.last_cycle = std::max(mine.last_cycle, theirs.last_cycle);
    }
    cycles_ += other.cycles_;
    for (const auto& [drives, alternation] : other.alternations_)
        if (alternation.most > alternations_[drives].most)
            alternations_[drives] = alternation;
    for (const auto& [drive, count] : other.starved_)
        starved_[drive] += count;
    for (const auto& [drive, count] : other.spun_)
        spun_[drive] += count;
    return true;
}

} // namespace usar::posh
