#include "core/posh/trace/trace_encoder.h"

#include <algorithm>

namespace usar::posh {

using namespace trace_codec;

namespace {

/// Number of events of the previous cycle to search for the same event.
constexpr std::size_t look_ahead = 64;

std::uint64_t operation(Operation kind, std::uint64_t count = 0) {
    return count * 4 + static_cast<std::uint64_t>(kind);
}

bool sameSubject(const Entry& a, const Entry& b) {
    return a.record.event == b.record.event && a.record.place == b.record.place;
}

/// Compares everything except cycle and time, which belong to the frame.
bool same(const Entry& a, const Entry& b) {
    return sameSubject(a, b) && a.record.payload == b.record.payload && a.record.detail == b.record.detail &&
           a.record.flags == b.record.flags && a.record.value == b.record.value && a.text == b.text;
}

/// Removes a cached answer; the reader finds it in the event in which the sense was evaluated.
Entry withoutAnswer(TraceRecord record) {
    record.payload = 0;
    record.value = ValueKind::Nil;
    return {record, 0};
}

} // namespace

void TraceEncoder::takeProgram(const std::shared_ptr<const Program>&) {
    encodeBetween();
    body_ = plan_text_;
    appendFrame(Frame::Plan);
    until_key_ = 0;
}

void TraceEncoder::take(const TraceRecord& record, std::string_view text) {
    if (record.event == TraceEvent::CycleBegin) {
        encodeBetween();
        in_cycle_ = true;
        if (until_key_ == 0)
            forgetTexts();
    }
    if (record.event == TraceEvent::SenseEval && (record.flags & trace_cached))
        now_.push_back(withoutAnswer(record));
    else
        now_.push_back({record, text.empty() ? 0 : numberOf(text)});
    if (record.event == TraceEvent::CycleEnd && in_cycle_)
        encodeCycle();
}

std::string TraceEncoder::takeBytes() {
    if (!in_cycle_)
        encodeBetween();
    return std::exchange(bytes_, {});
}

std::uint32_t TraceEncoder::numberOf(std::string_view text) {
    const auto [known, is_new] = numbers_.try_emplace(std::string(text), static_cast<std::uint32_t>(texts_.size() + 1));
    if (is_new)
        texts_.emplace_back(text);
    return known->second;
}

void TraceEncoder::forgetTexts() {
    numbers_.clear();
    texts_.clear();
    texts_written_ = 0;
    before_.clear();
}

void TraceEncoder::encodeCycle() {
    const TraceRecord& first = now_.front().record;
    const bool key = until_key_ == 0;
    if (key) {
        appendVarint(body_, first.cycle);
        appendVarint(body_, zigzag(first.time_ms));
        step_ms_ = 0;
        until_key_ = cycles_per_key;
    } else {
        const std::int64_t step_ms = first.time_ms - time_ms_;
        appendVarint(body_, zigzag(step_ms - step_ms_));
        step_ms_ = step_ms;
    }
    time_ms_ = first.time_ms;
    encodeDifference();
    appendFrame(key ? Frame::Key : Frame::Delta);
    --until_key_;
    std::swap(now_, before_);
    now_.clear();
    in_cycle_ = false;
}

void TraceEncoder::encodeDifference() {
    std::size_t at = 0; // Index in the previous cycle
    for (const Entry& entry : now_) {
        const std::size_t found = findBefore(entry, at);
        if (found == before_.size()) {
            appendRun();
            appendNew(entry);
            continue;
        }
        if (found != at) {
            appendRun();
            appendVarint(body_, operation(Operation::Skip, found - at));
        }
        at = found + 1;
        if (same(before_[found], entry)) {
            ++run_;
            continue;
        }
        appendRun();
        appendChange(before_[found], entry);
    }
    appendRun();
}

std::size_t TraceEncoder::findBefore(const Entry& entry, std::size_t from) const {
    const std::size_t end = std::min(before_.size(), from + look_ahead);
    for (std::size_t at = from; at < end; ++at)
        if (sameSubject(before_[at], entry))
            return at;
    return before_.size();
}

void TraceEncoder::appendRun() {
    if (run_ > 0)
        appendVarint(body_, operation(Operation::Copy, run_));
    run_ = 0;
}

void TraceEncoder::appendChange(const Entry& before, const Entry& now) {
    appendVarint(body_, operation(Operation::Change));
    const TraceRecord& a = before.record;
    const TraceRecord& b = now.record;
    const int mask = (a.payload != b.payload ? payload_changes : 0) | (a.detail != b.detail ? detail_changes : 0) |
                     (a.flags != b.flags ? flags_change : 0) | (a.value != b.value ? kind_changes : 0) |
                     (before.text != now.text ? text_changes : 0);
    body_ += static_cast<char>(mask);
    if (mask & payload_changes)
        appendBits(body_, a.payload ^ b.payload);
    if (mask & detail_changes)
        body_ += static_cast<char>(b.detail);
    if (mask & flags_change)
        body_ += static_cast<char>(b.flags);
    if (mask & kind_changes)
        body_ += static_cast<char>(b.value);
    if (mask & text_changes)
        appendText(now.text);
}

void TraceEncoder::appendNew(const Entry& entry) {
    appendVarint(body_, operation(Operation::Insert));
    const TraceRecord& record = entry.record;
    body_ += static_cast<char>(record.event);
    appendVarint(body_, record.place);
    body_ += static_cast<char>(record.detail);
    body_ += static_cast<char>(record.flags);
    body_ += static_cast<char>(record.value);
    appendBits(body_, record.payload);
    appendText(entry.text);
}

/// Appends the number of a text, followed by the text itself the first time.
void TraceEncoder::appendText(std::uint32_t number) {
    appendVarint(body_, number);
    if (number <= texts_written_)
        return;
    const std::string& text = texts_[number - 1];
    appendVarint(body_, text.size());
    body_ += text;
    texts_written_ = number;
}

void TraceEncoder::encodeBetween() {
    if (now_.empty() || in_cycle_)
        return;
    for (const Entry& entry : now_)
        appendNew(entry);
    appendFrame(Frame::Between);
    now_.clear();
}

void TraceEncoder::appendFrame(Frame kind) {
    appendVarint(bytes_, body_.size() + 1);
    bytes_ += static_cast<char>(kind);
    bytes_ += body_;
    body_.clear();
}

} // namespace usar::posh
