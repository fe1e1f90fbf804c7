// How long clients wait before they try to connect again.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/clock.h"

namespace usar::link {

/// The pause after so many failures (0: after the first): `first`, doubled each time, up to `longest`.
inline Seconds retryPause(Seconds first, Seconds longest, int failed_tries) {
    return std::min(longest, first * std::exp2(std::min(failed_tries, 20)));
}

} // namespace usar::link
