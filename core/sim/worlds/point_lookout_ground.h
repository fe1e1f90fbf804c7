// The shape of the terrain of `point_lookout`: an island of hills, its cliffs and beaches, the bed of the sea around
// it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sim/worlds/fractal_noise.h"
#include "core/sim/worlds/start_places.h"

namespace usar::sim {

/// Follows the thesis's ONS-PointLookout as robots-and-worlds.md, section 5, reconstructs it; all sizes are ours. A
/// pure function of seed and point; map frame, meters, the sea's surface at 0.
class PointLookoutGround {
public:
    explicit PointLookoutGround(std::uint64_t seed);

    /// Height of the land or of the sea bed.
    double height_m(const Vec2& point_m) const;
    /// Approximate distance to the coast; negative at sea.
    double inland_m(const Vec2& point_m) const;
    /// Start places on land, where the ground is level, and at sea.
    const std::vector<StartPlace>& landStarts() const { return land_starts_; }
    const std::vector<StartPlace>& seaStarts() const { return sea_starts_; }

    static constexpr double side_m = 1024.0;
    static constexpr double open_radius_m = 10.0; ///< around a start place on land

private:
    /// 1 where the coast is a cliff, 0 where it is a beach.
    double cliffs(const Vec2& point_m) const;
    /// Height before the start places are leveled.
    double unlevelled_m(const Vec2& point_m) const;
    double land_m(const Vec2& point_m, double inland_m) const;
    double bed_m(const Vec2& point_m, double offshore_m) const;
    void chooseLandStarts();
    void chooseSeaStarts();

    FractalNoise coast_;
    FractalNoise cliffs_;
    FractalNoise hills_;
    FractalNoise bed_;
    Vec2 shift_m_ = Vec2::Zero();
    std::vector<StartPlace> land_starts_;
    std::vector<double> land_heights_m_;
    std::vector<StartPlace> sea_starts_;
};

} // namespace usar::sim
