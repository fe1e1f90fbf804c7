// Statistics of how high something was above the ground.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace usar::sim {

/// Height of the base's origin above the ground straight below it, in meters.
struct HeightFigures {
    double least_m = 0.0;
    double mean_m = 0.0;
    double spread_m = 0.0; ///< standard deviation
};

/// Collects heights, one per tick.
class HeightWatch {
public:
    void step(double height_m) {
        least_m_ = count_ == 0 ? height_m : std::min(least_m_, height_m);
        ++count_;
        const double off_m = height_m - mean_m_;
        mean_m_ += off_m / count_;
        squares_m2_ += off_m * (height_m - mean_m_);
    }
    /// Returns nullopt before the first height.
    std::optional<HeightFigures> figures() const {
        if (count_ == 0)
            return std::nullopt;
        return HeightFigures{least_m_, mean_m_, std::sqrt(squares_m2_ / count_)};
    }

private:
    double least_m_ = 0.0;
    double mean_m_ = 0.0;
    double squares_m2_ = 0.0; ///< sum of squared distances from the mean
    double count_ = 0.0;
};

} // namespace usar::sim
