// The longest time that something stayed in one place, be it a robot that is trapped or one that waits.
#pragma once

#include <algorithm>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::sim {

/// A new stay begins when the position is more than a meter from where the last one began.
class StayWatch {
public:
    static constexpr double place_radius_m = 1.0;

    explicit StayWatch(const Vec3& position_m) : place_m_(position_m) {}

    /// Takes the position after another `dt`.
    void step(Seconds dt, const Vec3& position_m) {
        stay_ += dt;
        if ((position_m - place_m_).norm() > place_radius_m) {
            place_m_ = position_m;
            stay_ = Seconds{0.0};
        }
        longest_ = std::max(longest_, stay_);
    }
    Seconds longest() const { return longest_; }

private:
    Vec3 place_m_;
    Seconds stay_{0.0};
    Seconds longest_{0.0};
};

} // namespace usar::sim
