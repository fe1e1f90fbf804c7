#include "core/link/play_clock.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::link {

namespace {

/// A protocol clock that leaps farther ahead than this, or backward, is damaged or another clock: counting restarts
/// there.
constexpr Seconds longest_leap{10.0};

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
constexpr Seconds farthest{1e9}; ///< clock readings beyond this are damage and ignored

RecordTime after(RecordTime play, Seconds span) {
    return play + std::chrono::round<RecordTime>(span);
}

} // namespace

void PlayClock::anchor(RecordTime arrival, std::optional<Seconds> now) {
    anchor_arrival_ = arrival;
    anchor_play_ = play_;
    anchor_now_ = now_ = now;
}

RecordTime PlayClock::at(const Record& record) {
    const auto stretched = [&] {
        const RecordTime by_arrival = record.time - anchor_arrival_;
        const RecordTime by_clock =
            anchor_now_ ? std::chrono::duration_cast<RecordTime>(*now_ - *anchor_now_) : RecordTime{0};
        return anchor_play_ + std::max(by_arrival, by_clock);
    };
    if (record.kind == RecordKind::Opened) {
        play_ = std::max(play_, stretched());
        anchor(record.time, std::nullopt);
    }
    const auto now = record.kind == RecordKind::In ? newestTime(record.bytes) : std::nullopt;
    if (now && now_ && *now >= *now_ && *now - *now_ <= longest_leap) {
        now_ = now;
    } else if (now) { // Also reached with a NaN, which the next reading replaces.
        play_ = std::max(play_, stretched());
        anchor(record.time, now);
    }
    play_ = std::max(play_, stretched());
    return play_;
}

void ClockTable::add(RecordTime play, Seconds now) {
    if (!(std::abs(now.count()) < farthest.count())) // Also true for NaN.
        return;
    if (!stretches_.empty()) {
        Stretch& last = stretches_.back();
        const Seconds apart = Seconds(play - last.play) - (now - last.begin);
        if (now >= last.end && apart <= together_within && apart >= -together_within) {
            last.end = now;
            return;
        }
    }
    stretches_.push_back({now, now, play});
}

std::optional<RecordTime> ClockTable::at(Seconds now) const {
    if (stretches_.empty())
        return std::nullopt;
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

} // namespace usar::link
