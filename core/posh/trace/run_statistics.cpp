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
    switch (record.event) {
    case TraceEvent::CycleBegin:
        return beginCycle(record.time_ms);
    case TraceEvent::SenseEval:
        ++counts.asked;
        counts.held += record.flags & trace_holds ? 1 : 0;
        return;
    case TraceEvent::Push:
    case TraceEvent::ElementSelected:
        ++counts.started;
        return;
    case TraceEvent::ElementSkipped:
        ++counts.skipped;
        return;
    case TraceEvent::Goal:
        ++counts.succeeded;
        return;
    case TraceEvent::NoElement:
    case TraceEvent::Timeout:
        ++counts.failed;
        return;
    case TraceEvent::ActInit:
    case TraceEvent::ActRun:
    case TraceEvent::ActDone:
        return countAct(record, counts);
    case TraceEvent::Warning:
        return countWarning(record);
    default:
        return countDrive(record, counts);
    }
}

void RunStatistics::countDrive(const TraceRecord& record, PlaceCounts& counts) {
    switch (record.event) {
    case TraceEvent::DriveStarted:
        ++counts.started;
        return noteWinner(record);
    case TraceEvent::DriveSucceeded:
        ++counts.succeeded;
        return;
    case TraceEvent::DriveFailed:
        ++counts.failed;
        return;
    case TraceEvent::DriveInterrupted:
        ++counts.interrupted;
        return;
    case TraceEvent::DriveSkipped:
        ++counts.skipped;
        return;
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

void RunStatistics::countAct(const TraceRecord& record, PlaceCounts& counts) {
    if (record.event == TraceEvent::ActInit) {
        ++counts.started;
    } else if (record.event == TraceEvent::ActRun) {
        ++counts.runs;
        acting_ = record.place;
        counts.spent_ns += record.payload;
        counts.longest_ns = std::max(counts.longest_ns, record.payload);
    } else {
        const DoneReason reason = record.reason();
        ++(reason == DoneReason::Finished ? counts.succeeded
           : reason == DoneReason::Failed ? counts.failed
                                          : counts.interrupted);
    }
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
        mine.asked += theirs.asked;
        mine.held += theirs.held;
        mine.started += theirs.started;
        mine.succeeded += theirs.succeeded;
        mine.failed += theirs.failed;
        mine.interrupted += theirs.interrupted;
        mine.skipped += theirs.skipped;
        mine.runs += theirs.runs;
        mine.active_ms += theirs.active_ms;
        mine.spent_ns += theirs.spent_ns;
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
