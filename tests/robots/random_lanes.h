// Lanes at random places, and a way to compare two orders of them.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/random.h"
#include "core/mapping/coverage_path.h"

namespace usar {

using Lanes = std::vector<mapping::Lane>;

inline Lanes randomLanes(Random& random, int count) {
    Lanes lanes;
    const auto place = [&] { return Vec2(uniform(random, -100.0, 100.0), uniform(random, -100.0, 100.0)); };
    for (int i = 0; i < count; ++i)
        lanes.push_back({place(), place(), 0});
    return lanes;
}

/// Both ends of each lane, whichever comes first, in a fixed order.
inline std::vector<std::array<double, 4>> ends(const Lanes& lanes) {
    std::vector<std::array<double, 4>> all;
    for (const mapping::Lane& lane : lanes) {
        std::array<double, 4> one{lane.start_m.x(), lane.start_m.y(), lane.end_m.x(), lane.end_m.y()};
        const std::array<double, 4> other{one[2], one[3], one[0], one[1]};
        all.push_back(std::min(one, other));
    }
    std::ranges::sort(all);
    return all;
}

} // namespace usar
