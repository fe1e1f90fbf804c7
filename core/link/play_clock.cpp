#include "core/link/play_clock.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::link {

namespace {

std::optional<Seconds> newestTime(std::string_view bytes) {
    constexpr std::string_view key = "{Time ";
    const auto at = bytes.rfind(key);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::string_view value = bytes.substr(at + key.size());
    const NumberPrefix number = readNumberPrefix(value);
    const bool whole = number.used > 0 && number.used < value.size(); // Not cut off at the end of a chunk.
    return whole ? std::optional(Seconds{number.value}) : std::nullopt;
}

constexpr Seconds together_within{0.005};

RecordTime after(RecordTime play, Seconds span) {
    return play + std::chrono::round<RecordTime>(span);
}

void appendTime(std::string& bytes, RecordTime time) {
    appendVarint(bytes, zigzag(time.count()));
}

/// Sets `good` to false if it is no time that this program would have written.
RecordTime readTime(ByteReader& bytes, bool& good) {
    const RecordTime time(unzigzag(bytes.varint()));
    good = good && time >= RecordTime{0} && time <= PlayClock::longest;
    return time;
}

void appendReading(std::string& bytes, const std::optional<Seconds>& now) {
    bytes += static_cast<char>(now.has_value());
    if (now)
        appendDouble(bytes, now->count());
}

/// The same for a reading of the protocol clock. One that is damaged may be written; nothing can be counted from it.
Seconds readClock(ByteReader& bytes, bool& good) {
    const double now_s = bytes.number();
    good = good && std::abs(now_s) < PlayClock::farthest.count(); // Not true for NaN.
    return Seconds{now_s};
}

std::optional<Seconds> readReading(ByteReader& bytes, bool& good) {
    return bytes.byte() ? std::optional(readClock(bytes, good)) : std::nullopt;
}

} // namespace

void PlayClock::anchor(RecordTime arrival, std::optional<Seconds> now) {
    anchor_arrival_ = arrival;
    anchor_play_ = play_;
    anchor_now_ = now_ = now;
}

RecordTime PlayClock::at(const Record& record) {
    const RecordTime arrival = std::min(record.time, longest);
    const auto stretched = [&] {
        const RecordTime by_arrival = arrival - anchor_arrival_;
        const RecordTime by_clock =
            anchor_now_ ? std::chrono::duration_cast<RecordTime>(*now_ - *anchor_now_) : RecordTime{0};
        return anchor_play_ + std::max(by_arrival, by_clock);
    };
    if (record.kind == RecordKind::Opened || record.kind == RecordKind::Start) {
        play_ = std::max(play_, stretched());
        anchor(arrival, std::nullopt);
    }
    const auto now = record.kind == RecordKind::In ? newestTime(record.bytes) : std::nullopt;
    if (now && now_ && *now >= *now_ && *now - *now_ <= longest_leap) {
        now_ = now;
    } else if (now) { // Also reached with a NaN, which the next reading replaces.
        play_ = std::max(play_, stretched());
        anchor(arrival, now);
    }
    play_ = std::max(play_, stretched());
    return play_;
}

void PlayClock::appendTo(std::string& bytes) const {
    for (const RecordTime time : {anchor_arrival_, anchor_play_, play_})
        appendTime(bytes, time);
    appendReading(bytes, anchor_now_);
    appendReading(bytes, now_);
}

bool PlayClock::readFrom(ByteReader& bytes) {
    bool good = true;
    for (RecordTime* const time : {&anchor_arrival_, &anchor_play_, &play_})
        *time = readTime(bytes, good);
    anchor_now_ = readReading(bytes, good);
    now_ = readReading(bytes, good);
    return good && !bytes.failed() && anchor_now_.has_value() <= now_.has_value();
}

void ClockTable::add(RecordTime play, Seconds now) {
    if (!(std::abs(now.count()) < PlayClock::farthest.count())) // Also true for NaN.
        return;
    if (!stretches_.empty()) {
        Stretch& last = stretches_.back();
        const Seconds apart = Seconds(play - last.play) - (now - last.begin);
        if (now >= last.end && apart <= together_within && apart >= -together_within) {
            last.end = now;
            return;
        }
    }
    if (stretches_.size() < most_stretches)
        stretches_.push_back({now, now, play});
}

void ClockTable::append(const ClockTable& later, RecordTime begin) {
    for (Stretch stretch : later.stretches_) {
        stretch.play = std::min(stretch.play + begin, PlayClock::longest);
        if (stretches_.size() < most_stretches)
            stretches_.push_back(stretch);
    }
}

std::optional<RecordTime> ClockTable::at(Seconds now) const {
    if (stretches_.empty() || std::isnan(now.count()))
        return std::nullopt;
    now = std::clamp(now, -PlayClock::farthest, PlayClock::farthest); // No reading is beyond, and times can be added.
    for (auto stretch = stretches_.rbegin(); stretch != stretches_.rend(); ++stretch) {
        if (now < stretch->begin)
            continue;
        const RecordTime wanted = after(stretch->play, now - stretch->begin);
        if (now <= stretch->end)
            return wanted;
        const auto next = stretch.base(); // The stretch after this one.
        if (next != stretches_.end() && next->begin > now)
            return std::min(wanted, next->play);
    }
    const Stretch& last = stretches_.back();
    return now < last.begin ? stretches_.front().play : after(last.play, last.end - last.begin);
}

void ClockTable::appendTo(std::string& bytes, std::size_t first) const {
    appendVarint(bytes, first);
    appendVarint(bytes, stretches_.size() - first);
    for (std::size_t i = first; i < stretches_.size(); ++i) {
        appendDouble(bytes, stretches_[i].begin.count());
        appendDouble(bytes, stretches_[i].end.count());
        appendTime(bytes, stretches_[i].play);
    }
}

bool ClockTable::readFrom(ByteReader& bytes) {
    const std::uint64_t first = bytes.varint();
    if (bytes.failed() || first > stretches_.size())
        return false;
    stretches_.resize(static_cast<std::size_t>(first));
    bool good = true;
    for (std::uint64_t left = bytes.varint(); left > 0 && good && !bytes.failed(); --left) {
        Stretch stretch{readClock(bytes, good), readClock(bytes, good), {}};
        stretch.play = readTime(bytes, good);
        if (stretches_.size() < most_stretches)
            stretches_.push_back(stretch);
    }
    return good && !bytes.failed();
}

} // namespace usar::link
