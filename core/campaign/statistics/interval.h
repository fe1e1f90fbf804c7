// A range of values that are compatible with what was measured.
#pragma once

#include <limits>

namespace usar::campaign {

/// Both ends belong to it. One that nothing is known of reaches from minus to plus infinity.
struct Interval {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    double halfWidth() const { return (high - low) / 2.0; }
    bool operator==(const Interval&) const = default;
};

} // namespace usar::campaign
