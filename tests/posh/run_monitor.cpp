#include "tests/posh/run_monitor.h"

#include <algorithm>
#include <limits>

using namespace usar::posh;

void RunMonitor::takeProgram(const std::shared_ptr<const Program>& program) {
    program_ = program;
    drives_.assign(program->drives.size(), {});
    open_.assign(program->drives.size(), {});
}

void RunMonitor::expect(bool holds, const char* rule, const Record& record) {
    if (holds || !complaint_.empty())
        return;
    complaint_ = std::string(rule) + " in cycle " + std::to_string(record.cycle);
    if (record.event != TraceEvent::CycleEnd)
        complaint_ += " at " + pathOf(*program_, record.place) + " " + nameOf(*program_, record.place);
}

void RunMonitor::take(const Record& record, std::string_view) {
    if (goal_due_ != nowhere && record.event != TraceEvent::Warning) {
        expect(record.event == TraceEvent::Goal && record.place == goal_due_, "P18 a goal that holds ends its form",
               record);
        goal_due_ = nowhere;
    }
    switch (record.event) {
    case TraceEvent::CycleBegin:
        return beginCycle();
    case TraceEvent::CycleEnd:
        return endCycle(record);
    case TraceEvent::SenseEval:
        return sense(record);
    case TraceEvent::DriveSkipped:
    case TraceEvent::DriveStarted:
    case TraceEvent::DriveSucceeded:
    case TraceEvent::DriveFailed:
    case TraceEvent::DriveInterrupted:
        return drive(record);
    case TraceEvent::Push:
    case TraceEvent::Pop:
        return frame(record);
    case TraceEvent::ElementSelected:
    case TraceEvent::ElementSkipped:
        return element(record);
    case TraceEvent::ActInit:
    case TraceEvent::ActRun:
    case TraceEvent::ActDone:
        return act(record);
    default:
        return;
    }
}

void RunMonitor::beginCycle() {
    runs_ = 0;
    ran_ = false;
    failed_ = false;
    beginEpoch();
}

void RunMonitor::beginEpoch() {
    answers_.clear();
    skipped_.clear();
    refused_.clear();
    lowest_asked_ = 0;
}

void RunMonitor::endCycle(const Record& record) {
    const Outcome outcome = record.outcome();
    if (outcome == Outcome::Idle || outcome == Outcome::GoalSatisfied || outcome == Outcome::Won)
        expect(act_ == nowhere, "P5 no act goes on when no drive does", record);
    if (act_ != nowhere)
        expect(ran_ && last_result_ == ActResult::Running, "P6 only a running act outlives its cycle", record);
    expect(runs_ <= most_acts_, "P7 no more acts than the budget", record);
    if (outcome == Outcome::GoalSatisfied) { // activations end without a word
        for (std::size_t i = 0; i < drives_.size(); ++i)
            drives_[i].in_progress = false;
        for (auto& open : open_)
            open.clear();
    }
}

void RunMonitor::sense(const Record& record) {
    const ProgramTest& test = program_->tests[place(record.place).item];
    const auto [known, first] = answers_.try_emplace(test.call, record);
    expect(first != ((record.flags & trace_cached) != 0), "P8 a sense is asked once per epoch", record);
    expect(known->second.payload == record.payload && known->second.value == record.value,
           "P8 equal calls have equal answers", record);
    if (place(record.place).kind == PlaceKind::SenseStep) {
        stepBegins(place(record.place).parent, place(record.place).position, record);
        if (record.flags & trace_holds)
            stepSucceeds(place(record.place).parent, place(record.place).position);
        return;
    }
    const Place& asker = place(place(record.place).parent);
    if (asker.kind == PlaceKind::Drive)
        senseOfDrive(record, asker.item);
    else if (asker.kind == PlaceKind::Element)
        examined(asker.item, record);
    else if (asker.kind != PlaceKind::Collection)
        senseOfGoal(record, program_->forms[asker.item], asker.item);
}

void RunMonitor::senseOfDrive(const Record& record, Index drive) {
    expect(!skipped_.contains(drive), "P10 a drive that is held back is not asked", record);
    lowest_asked_ = std::max(lowest_asked_, program_->drives[drive].level);
    if (!(record.flags & trace_holds))
        refused_.insert(drive);
}

void RunMonitor::senseOfGoal(const Record& record, const ProgramForm& form, Index form_index) {
    const bool all_hold = place(record.place).item + 1 == form.goal.end && (record.flags & trace_holds);
    if (all_hold)
        goal_due_ = form.place;
    expect(findOpen(form_index) != nullptr, "P18 only open forms are asked for their goal", record);
}

void RunMonitor::drive(const Record& record) {
    const Index drive = place(record.place).item;
    switch (record.event) {
    case TraceEvent::DriveSkipped:
        skipped_.insert(drive);
        return;
    case TraceEvent::DriveStarted:
        return start(record);
    case TraceEvent::DriveInterrupted:
        return interrupt(record);
    default:
        expect(drives_[drive].in_progress && openOf(drive).empty(), "P3 only an activation ends, with all its forms",
               record);
        drives_[drive].in_progress = false;
        failed_ = failed_ || record.event == TraceEvent::DriveFailed;
    }
}

void RunMonitor::start(const Record& record) {
    const Index drive = place(record.place).item;
    DriveNotes& notes = drives_[drive];
    expect(lowest_asked_ <= program_->drives[drive].level, "P9 no sense below the winner is asked", record);
    expect(!notes.in_progress && openOf(drive).empty(), "P13 an activation starts at its root", record);
    expect(!failed_, "P20 failure does not reach another drive", record);
    const ProgramDrive& here = program_->drives[drive];
    if (notes.ever_started)
        expect(static_cast<double>(record.time_ms - notes.started_ms) >= here.interval_ms &&
                   static_cast<double>(record.cycle - notes.started_cycle) >= here.interval_cycles,
               "P16 the interval passes between two starts", record);
    notes = {true, true, record.time_ms, record.cycle};
}

void RunMonitor::interrupt(const Record& record) {
    const Index drive = place(record.place).item;
    expect(act_ == nowhere, "P4 the act is over before its drive is interrupted", record);
    const bool kept = (record.flags & trace_adopt_kept) != 0;
    const bool at_adopt = !openOf(drive).empty() && program_->forms[openOf(drive).back().form].kind == PlaceKind::Adopt;
    expect(kept ? at_adopt : openOf(drive).empty(), "P13, P14 an interrupted drive keeps its adopt or nothing", record);
    for (Open& open : openOf(drive)) // the time of a competence begins anew when its drive comes back
        if (program_->forms[open.form].kind == PlaceKind::Competence)
            open.pushed_ms = std::numeric_limits<std::int64_t>::max();
    drives_[drive].in_progress = kept;
    const auto winner = static_cast<Index>(record.payload);
    if (winner != nowhere && program_->drives[place(winner).item].level == program_->drives[drive].level)
        expect(refused_.contains(drive), "P22 an equal does not displace the drive in progress", record);
}

void RunMonitor::frame(const Record& record) {
    const Place& here = place(record.place);
    auto& open = openOf(driveOf(record.place));
    if (record.event == TraceEvent::Pop) {
        expect(!open.empty() && open.back().form == here.item, "P3 the last form to open closes first", record);
        if (!open.empty())
            open.pop_back();
        return;
    }
    const Index parent = program_->forms[here.item].parent;
    expect(parent == nowhere ? open.empty() : !open.empty() && open.back().form == parent,
           "P13 forms open from the root on", record);
    if (place(here.parent).kind == PlaceKind::Pattern)
        stepBegins(here.parent, here.reference, record);
    open.push_back({here.item, record.time_ms, 0});
}

void RunMonitor::element(const Record& record) {
    const ProgramElement& here = program_->elements[place(record.place).item];
    examined(place(record.place).item, record);
    if (record.event == TraceEvent::ElementSelected && here.retries > 0)
        expect(record.payload <= static_cast<std::uint64_t>(here.retries), "P15 no more starts than the limit", record);
}

/// The competence must be the innermost open form: while a pattern below it is open, nothing beside it is looked at.
void RunMonitor::examined(Index element, const Record& record) {
    const Index competence = place(place(program_->elements[element].place).parent).item;
    const auto& open = openOf(driveOf(record.place));
    expect(!open.empty() && open.back().form == competence, "P12 nothing is examined beside an open pattern", record);
}

void RunMonitor::act(const Record& record) {
    const Place& here = place(record.place);
    if (record.event == TraceEvent::ActInit) {
        expect(act_ == nowhere, "P2, P4 the old act is done before the new one begins", record);
        act_ = record.place;
        ran_ = false;
        if (place(here.parent).kind == PlaceKind::Pattern)
            stepBegins(here.parent, here.position, record);
        return;
    }
    expect(act_ == record.place, "P3 only the current act runs and is done", record);
    if (record.event == TraceEvent::ActDone) {
        const bool worked = ran_ && last_result_ != ActResult::Failed && last_result_ != ActResult::Running;
        expect((record.reason() == DoneReason::Finished) == worked, "P3 an act is done as it answered", record);
        if (record.reason() == DoneReason::Finished && place(here.parent).kind == PlaceKind::Pattern)
            stepSucceeds(here.parent, here.position);
        failed_ = failed_ || record.reason() == DoneReason::Failed;
        act_ = nowhere;
        return;
    }
    expect(!failed_, "P20 nothing runs after a failure", record);
    expect(!ran_, "P3 an act runs once per cycle", record);
    checkLimits(record);
    last_result_ = record.result();
    ran_ = true;
    ++runs_;
    beginEpoch();
}

void RunMonitor::checkLimits(const Record& record) {
    for (const Open& open : openOf(driveOf(record.place))) {
        const auto& limit = program_->forms[open.form].limit_ms;
        if (limit)
            expect(static_cast<double>(record.time_ms - open.pushed_ms) < *limit, "P17 nothing runs past a limit",
                   record);
    }
}

void RunMonitor::stepBegins(Index place_index, Index position, const Record& record) {
    Open* const open = findOpen(place(place_index).item);
    if (!open)
        return expect(false, "P11 steps begin in open patterns", record);
    // a form that was a step and is left behind has succeeded: failure would have closed the pattern
    expect(position == open->next_step || position == open->next_step + 1, "P11 steps begin in order", record);
    open->next_step = std::max(open->next_step, position);
}

void RunMonitor::stepSucceeds(Index place_index, Index position) {
    if (Open* const open = findOpen(place(place_index).item))
        open->next_step = position + 1;
}

Index RunMonitor::driveOf(Index place_index) const {
    while (place(place_index).kind != PlaceKind::Drive)
        place_index = place(place_index).parent;
    return place(place_index).item;
}

RunMonitor::Open* RunMonitor::findOpen(Index form) {
    for (Open& open : openOf(driveOf(program_->forms[form].place)))
        if (open.form == form)
            return &open;
    return nullptr;
}
