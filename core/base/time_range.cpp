#include "core/base/time_range.h"

#include <algorithm>
#include <cmath>

namespace usar {

namespace {

std::string twoDigits(long long value) {
    return (value < 10 ? "0" : "") + std::to_string(value);
}

} // namespace

std::string countdownText(Seconds span) {
    const auto total = static_cast<long long>(std::ceil(std::max(0.0, span.count())));
    const long long hours = total / 3600;
    const std::string minutes = std::to_string(total / 60 % 60);
    const std::string head = hours > 0 ? std::to_string(hours) + ":" + twoDigits(total / 60 % 60) : minutes;
    return head + ":" + twoDigits(total % 60);
}

} // namespace usar
