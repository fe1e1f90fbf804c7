#include "core/posh/trace/trace_file.h"

#include <algorithm>

#include "core/posh/language/plan_reader.h"

namespace usar::posh {

using namespace trace_codec;

namespace {

/// Returns the greatest detail that an engine writes with an event.
std::uint8_t mostDetail(TraceEvent event) {
    const auto number = [](auto greatest) { return static_cast<std::uint8_t>(greatest); };
    return event == TraceEvent::CycleEnd       ? number(Outcome::Won)
           : event == TraceEvent::DriveSkipped ? number(SkipReason::SwitchedOff)
           : event == TraceEvent::ActRun       ? number(ActResult::Failed)
           : event == TraceEvent::ActDone      ? number(DoneReason::Stopped)
           : event == TraceEvent::Warning      ? number(WarningCode::Host)
                                               : std::uint8_t{0};
}

/// Returns whether the fields of a record from a file are within the ranges that an engine writes.
bool isSound(const TraceRecord& record) {
    return record.event <= TraceEvent::Error && record.value <= ValueKind::Symbol &&
           record.detail <= mostDetail(record.event);
}

} // namespace

Result<TraceFile> TraceFile::open(std::string_view bytes) {
    if (!bytes.starts_with(magic))
        return failure("it does not begin like a plan trace of this version", "the trace",
                       "Open a file that this program recorded");
    TraceFile file;
    file.indexed_ = magic.size();
    file.extend(bytes);
    return file;
}

void TraceFile::extend(std::string_view bytes) {
    bytes_ = bytes;
    while (damage_.empty()) {
        const auto frame = frameAt(indexed_);
        if (!frame)
            return;
        index(*frame, indexed_);
        indexed_ = frame->end;
    }
}

std::optional<TraceFile::FrameView> TraceFile::frameAt(std::size_t offset) const {
    if (offset >= bytes_.size())
        return std::nullopt;
    ByteReader bytes(bytes_.substr(offset));
    const std::uint64_t length = bytes.varint();
    const std::size_t begin = offset + bytes.used();
    if (bytes.failed() || length == 0 || length > longest_frame || length > bytes_.size() - begin)
        return std::nullopt;
    FrameView frame;
    frame.kind = static_cast<Frame>(bytes_[begin]);
    frame.body = bytes_.substr(begin + 1, static_cast<std::size_t>(length) - 1);
    frame.end = begin + static_cast<std::size_t>(length);
    return frame;
}

void TraceFile::index(const FrameView& frame, std::size_t offset) {
    switch (frame.kind) {
    case Frame::Plan: {
        RecordedPlan plan{std::string(frame.body), nullptr};
        if (const auto program = compile(readPlan(plan.text).plan))
            plan.program = *program;
        plans_.push_back(std::move(plan));
        return;
    }
    case Frame::Key:
        keys_.push_back({ByteReader(frame.body).varint(), offset, plans_.size()});
        ++cycle_count_;
        return;
    case Frame::Delta:
        ++cycle_count_;
        return;
    case Frame::Between:
        return;
    }
    damage_ = "the trace is damaged at byte " + std::to_string(offset) + ": what follows is left out";
}

TraceFile::Cursor TraceFile::seek(std::uint64_t cycle) const {
    auto key = std::ranges::upper_bound(keys_, cycle, {}, &Key::cycle);
    if (key != keys_.begin())
        --key;
    if (key == keys_.end())
        return {*this, indexed_, plans_.size()};
    Cursor cursor(*this, key->offset, key->plan);
    if (key->cycle >= cycle || !cursor.next())
        return cursor;
    while (cursor.cycle_.number + 1 < cycle && cursor.deltaFollows() && cursor.next())
        ;
    return cursor;
}

bool TraceFile::Cursor::deltaFollows() const {
    for (auto frame = file_->frameAt(at_); frame; frame = file_->frameAt(frame->end))
        if (frame->kind == Frame::Key || frame->kind == Frame::Delta)
            return frame->kind == Frame::Delta;
    return false;
}

const TracedCycle* TraceFile::Cursor::next() {
    readBehind(); // What has come since the last cycle was read brings texts that later ones may repeat.
    while (at_ < file_->indexed_) {
        const auto frame = file_->frameAt(at_);
        if (!frame)
            return nullptr;
        at_ = frame->end;
        if (frame->kind == Frame::Plan)
            ++plan_;
        if (frame->kind != Frame::Key && frame->kind != Frame::Delta)
            continue;
        if (!readCycle(frame->kind, ByteReader(frame->body))) {
            at_ = file_->indexed_;
            return nullptr;
        }
        readBehind();
        return &cycle_;
    }
    return nullptr;
}

bool TraceFile::Cursor::readCycle(Frame kind, ByteReader bytes) {
    std::swap(before_, now_);
    now_.clear();
    if (kind == Frame::Key) {
        cycle_.number = bytes.varint();
        cycle_.time_ms = unzigzag(bytes.varint());
        cycle_.texts.clear();
        before_.clear();
        answers_.clear();
        step_ms_ = 0;
        keyed_plan_ = plan_;
    } else {
        if (keyed_plan_ != plan_)
            return false; // The previous cycle has places of another plan
        ++cycle_.number;
        step_ms_ = static_cast<std::int64_t>(static_cast<std::uint64_t>(step_ms_) +
                                             static_cast<std::uint64_t>(unzigzag(bytes.varint())));
        cycle_.time_ms = static_cast<std::int64_t>(static_cast<std::uint64_t>(cycle_.time_ms) +
                                                   static_cast<std::uint64_t>(step_ms_));
    }
    cycle_.program = plan_ == 0 ? nullptr : file_->plans_[plan_ - 1].program;
    cycle_.plan = plan_ == 0 ? 0 : plan_ - 1;
    if (!readEvents(bytes, now_))
        return false;
    cycle_.events = now_;
    stamp(cycle_.events);
    recallAnswers();
    return true;
}

bool TraceFile::Cursor::readEvents(ByteReader& bytes, std::vector<Entry>& events) {
    std::size_t at = 0; // Index in the previous cycle
    while (!bytes.empty() && !bytes.failed()) {
        const std::uint64_t word = bytes.varint();
        const std::uint64_t count = word / 4;
        const auto operation = static_cast<Operation>(word % 4);
        if (operation == Operation::Insert) {
            if (!readNew(bytes, events.emplace_back()))
                return false;
            continue;
        }
        const std::uint64_t needed = operation == Operation::Change ? 1 : count;
        if (needed > before_.size() - at)
            return false;
        if (operation != Operation::Skip)
            events.insert(events.end(), before_.begin() + static_cast<std::ptrdiff_t>(at),
                          before_.begin() + static_cast<std::ptrdiff_t>(at + needed));
        at += static_cast<std::size_t>(needed);
        if (operation == Operation::Change && !readChange(bytes, events.back()))
            return false;
    }
    return !bytes.failed();
}

bool TraceFile::Cursor::readChange(ByteReader& bytes, Entry& entry) {
    const std::uint8_t mask = bytes.byte();
    TraceRecord& record = entry.record;
    if (mask & payload_changes)
        record.payload ^= bytes.bits();
    if (mask & detail_changes)
        record.detail = bytes.byte();
    if (mask & flags_change)
        record.flags = bytes.byte();
    if (mask & kind_changes)
        record.value = static_cast<ValueKind>(bytes.byte());
    if ((mask & text_changes) && !readText(bytes, entry.text))
        return false;
    return !bytes.failed() && isSound(record);
}

bool TraceFile::Cursor::readNew(ByteReader& bytes, Entry& entry) {
    TraceRecord& record = entry.record;
    record.event = static_cast<TraceEvent>(bytes.byte());
    const std::uint64_t place = bytes.varint();
    record.place = static_cast<Index>(place);
    record.detail = bytes.byte();
    record.flags = bytes.byte();
    record.value = static_cast<ValueKind>(bytes.byte());
    record.payload = bytes.bits();
    const bool counts_acts = record.event == TraceEvent::CycleEnd;
    const bool known_place = counts_acts || !cycle_.program || place < cycle_.program->places.size();
    return readText(bytes, entry.text) && !bytes.failed() && known_place && isSound(record);
}

bool TraceFile::Cursor::readText(ByteReader& bytes, std::uint32_t& number) {
    const std::uint64_t given = bytes.varint();
    if (given > cycle_.texts.size() + 1)
        return false;
    number = static_cast<std::uint32_t>(given);
    if (given == cycle_.texts.size() + 1)
        cycle_.texts.emplace_back(bytes.text(bytes.varint()));
    return !bytes.failed();
}

/// Reads the frames between this cycle and the next, which belong to this one.
void TraceFile::Cursor::readBehind() {
    cycle_.behind.clear();
    for (auto frame = file_->frameAt(at_); frame && frame->kind == Frame::Between && at_ < file_->indexed_;
         frame = file_->frameAt(at_)) {
        ByteReader bytes(frame->body);
        std::vector<Entry> events;
        if (!readEvents(bytes, events))
            break; // Drop a damaged frame as a whole
        cycle_.behind.insert(cycle_.behind.end(), events.begin(), events.end());
        at_ = frame->end;
    }
    stamp(cycle_.behind);
}

/// Restores cached answers from the events in which the senses were evaluated.
void TraceFile::Cursor::recallAnswers() {
    const Program* const program = cycle_.program.get();
    if (!program)
        return;
    answers_.resize(program->sense_calls.size());
    for (Entry& entry : cycle_.events) {
        if (entry.record.event != TraceEvent::SenseEval)
            continue;
        const Place& place = program->places[entry.record.place];
        if (place.kind != PlaceKind::Sense && place.kind != PlaceKind::SenseStep)
            continue; // The trace is damaged
        Entry& answer = answers_[program->tests[place.item].call];
        if (entry.record.flags & trace_cached) {
            entry.record.payload = answer.record.payload;
            entry.record.value = answer.record.value;
            entry.text = answer.text;
        } else {
            answer = entry;
        }
    }
}

void TraceFile::Cursor::stamp(std::vector<Entry>& events) const {
    for (Entry& entry : events) {
        entry.record.cycle = cycle_.number;
        entry.record.time_ms = cycle_.time_ms;
    }
}

} // namespace usar::posh
