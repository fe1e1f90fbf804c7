#include "core/mission/runs/export_clock.h"

#include <algorithm>
#include <cmath>

#include "core/link/play_clock.h"

namespace usar::mission {

namespace {

/// In nanoseconds, this is just below 2^63. Only a damaged recording gets there, by restarts of its clock.
constexpr Seconds end_of_line{9e9};

bool canBe(Seconds reading) {
    return reading >= Seconds{0.0} && reading <= link::PlayClock::farthest; // False for NaN.
}

bool agree(Seconds one, Seconds other) {
    return canBe(one) && canBe(other) && std::abs((one - other).count()) <= link::PlayClock::longest_leap.count();
}

std::uint64_t nanoseconds(Seconds time) {
    return static_cast<std::uint64_t>(std::llround(time.count() * 1e9));
}

} // namespace

ExportClock::ExportClock(Seconds begin) : newest_(canBe(begin) ? begin : Seconds{0.0}) {}

void ExportClock::take(Seconds reading) {
    if (!canBe(reading))
        return;
    const bool believed = is_new_ || (doubted_ && agree(*doubted_, reading));
    if (agree(newest_, reading) && !is_new_) {
        newest_ = std::max(newest_, reading);
        doubted_.reset();
    } else if (believed) {
        goOnAt(reading);
    } else {
        doubted_ = reading;
    }
}

Seconds ExportClock::onLine(Seconds reading) const {
    return std::min(reading + shift_, end_of_line);
}

void ExportClock::goOnAt(Seconds reading) {
    if (reading < newest_)
        shift_ += newest_ - reading;
    newest_ = reading;
    doubted_.reset();
    is_new_ = false;
}

McapTimes ExportClock::timesOf(std::optional<Seconds> own) const {
    const std::uint64_t now_ns = nanoseconds(now());
    return {now_ns, own && agree(*own, newest_) ? nanoseconds(onLine(*own)) : now_ns};
}

} // namespace usar::mission
