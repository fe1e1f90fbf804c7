#include "core/posh/trace/run_history.h"

#include <algorithm>
#include <array>
#include <utility>

namespace usar::posh {

namespace {

constexpr std::size_t places_kept = 250'000; ///< total number of stored places, which takes tens of megabytes
constexpr std::size_t first_every = 256;

/// Returns whether the event can follow an act in the same epoch.
bool followsAct(TraceEvent event) {
    using enum TraceEvent;
    constexpr std::array followers{ActDone, Pop,     AdoptRetry, DriveSucceeded, Blackboard,
                                   Command, Warning, Error,      CycleEnd};
    return std::ranges::find(followers, event) != followers.end();
}

} // namespace

void RunHistory::clear() {
    cursor_.reset();
    file_.reset();
    bytes_.clear();
    moments_.clear();
    remembered_.clear();
    every_ = first_every;
    newest_.start(nullptr);
    last_asked_.reset();
}

void RunHistory::append(std::string_view piece) {
    if (piece.starts_with(trace_codec::magic))
        clear();
    bytes_ += piece;
    if (file_)
        file_->extend(bytes_);
    else if (auto opened = TraceFile::open(bytes_))
        cursor_ = file_.emplace(*std::move(opened)).begin();
    readOn();
}

void RunHistory::readOn() {
    while (cursor_) {
        const TracedCycle* const cycle = cursor_->next();
        if (!cycle)
            return;
        fold(newest_, *cycle);
        moments_.push_back({cycle->number, cycle->time_ms, bytes_.size()});
        if (moments_.size() % every_ == 0)
            remember();
    }
}

/// Stores the newest activity; drops every other stored one when there are too many.
void RunHistory::remember() {
    remembered_.push_back({moments_.size(), newest_});
    const std::size_t places = std::max<std::size_t>(1, newest_.places().size());
    if (remembered_.size() < std::clamp<std::size_t>(places_kept / places, 8, 64))
        return;
    every_ *= 2;
    std::erase_if(remembered_, [this](const Remembered& one) { return one.cycles % every_ != 0; });
}

void RunHistory::fold(RunActivity& activity, const TracedCycle& cycle) {
    if (cycle.program && cycle.program != activity.program()) {
        if (activity.program() && sameShape(*activity.program(), *cycle.program))
            activity.retune(cycle.program);
        else
            activity.start(cycle.program);
    }
    for (const auto& entry : cycle.events)
        activity.take(entry.record, cycle.textOf(entry));
    for (const auto& entry : cycle.behind)
        activity.take(entry.record, cycle.textOf(entry));
}

std::size_t RunHistory::momentAt(std::int64_t time_ms) const {
    const auto after = std::ranges::upper_bound(moments_, time_ms, {}, &RunMoment::time_ms);
    return after == moments_.begin() ? 0 : static_cast<std::size_t>(after - moments_.begin()) - 1;
}

RunActivity RunHistory::at(std::size_t moment, std::optional<std::size_t> epoch) const {
    const std::size_t whole_cycles = epoch ? moment : moment + 1;
    Remembered state = nearestTo(whole_cycles);
    if (state.cycles == moments_.size())
        return std::move(state.activity);
    TraceFile::Cursor cursor = cursorAt(state.cycles);
    for (; state.cycles < whole_cycles; ++state.cycles) {
        const TracedCycle* const cycle = cursor.next();
        if (!cycle)
            break;
        fold(state.activity, *cycle);
    }
    last_asked_ = state;
    if (const TracedCycle* const cycle = epoch ? cursor.next() : nullptr) {
        TracedCycle part = *cycle;
        const std::vector<std::size_t> ends = epochEnds(part);
        part.events.resize(ends[std::min(*epoch, ends.size() - 1)]);
        part.behind.clear();
        fold(state.activity, part);
    }
    return std::move(state.activity);
}

RunHistory::Remembered RunHistory::nearestTo(std::size_t cycles) const {
    if (cycles == moments_.size())
        return {cycles, newest_};
    const auto after = std::ranges::upper_bound(remembered_, cycles, {}, &Remembered::cycles);
    const std::size_t known = after == remembered_.begin() ? 0 : std::prev(after)->cycles;
    if (last_asked_ && last_asked_->cycles <= cycles && last_asked_->cycles >= known)
        return *last_asked_;
    return known == 0 ? Remembered() : *std::prev(after);
}

std::vector<std::size_t> RunHistory::epochEnds(const TracedCycle& cycle) {
    std::vector<std::size_t> ends;
    bool act_is_over = false;
    for (std::size_t i = 0; i < cycle.events.size(); ++i) {
        const TraceRecord& record = cycle.events[i].record;
        if (act_is_over && !followsAct(record.event)) {
            ends.push_back(i);
            act_is_over = false;
        }
        act_is_over = act_is_over || (record.event == TraceEvent::ActRun && record.result() == ActResult::Finished);
    }
    ends.push_back(cycle.events.size());
    return ends;
}

std::size_t RunHistory::epochCount(std::size_t moment) const {
    TraceFile::Cursor cursor = cursorAt(moment); // Owns the cycle
    const TracedCycle* const cycle = cursor.next();
    return cycle ? epochEnds(*cycle).size() : 1;
}

const std::string& RunHistory::planText(std::size_t moment) const {
    TraceFile::Cursor cursor = cursorAt(moment);
    const TracedCycle* const cycle = cursor.next();
    return file_->planText(cycle ? cycle->plan : 0);
}

} // namespace usar::posh
