#include "core/link/clock_table.h"

#include <algorithm>
#include <cmath>

namespace usar::link {

namespace {

constexpr Seconds together_within{0.005};
constexpr Seconds farthest{1e9}; ///< clock readings beyond this are damage and ignored

RecordTime after(RecordTime play, Seconds span) {
    return play + std::chrono::round<RecordTime>(span);
}

} // namespace

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
