// The shape of the terrain of `tall_test`: hills, a ravine, a pond, level places to start from.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/worlds/fractal_noise.h"
#include "core/sim/worlds/start_places.h"

namespace usar::sim {

/// Follows the thesis's DM-TallTestWorld as robots-and-worlds.md, section 5, reconstructs it; all sizes are ours. A
/// pure function of seed and point; map frame, meters.
class TallTestGround {
public:
    explicit TallTestGround(std::uint64_t seed);

    /// Height of the ground, also under the pond.
    double height_m(const Vec2& point_m) const;
    /// Height of the pond's surface.
    double water_z_m() const { return water_z_m_; }
    const std::vector<StartPlace>& starts() const { return starts_; }
    /// Distance to the center line of the ravine, accurate only near it.
    double ravineDistance_m(const Vec2& point_m) const;

    static constexpr double side_m = 256.0;
    static constexpr double open_radius_m = 10.0; ///< around a start place

private:
    double hills_m(const Vec2& point_m) const;
    /// The y of the ravine's center line.
    double ravineLine_m(double x_m) const;
    double hillsAndRavine_m(const Vec2& point_m) const;
    /// Height before the start places are leveled.
    double unlevelled_m(const Vec2& point_m) const;
    void chooseStarts();
    void choosePond();

    FractalNoise hills_;
    Vec2 shift_m_ = Vec2::Zero();
    double bend_rad_ = 0.0;
    double wiggle_rad_ = 0.0;
    Vec2 pond_m_ = Vec2::Zero();
    double water_z_m_ = 0.0;
    std::vector<StartPlace> starts_;
    std::vector<double> start_heights_m_;
};

} // namespace usar::sim
