// A line scanner: a fan of single rays. Model: robots-and-worlds.md 4.1.
#pragma once

#include <string>
#include <vector>

#include "core/protocol/sensors/range_scan.h"
#include "core/sim/noise.h"
#include "core/sim/sensors/rays.h"

namespace usar::sim {

/// The fan is in the scanner's xy plane, around its x axis. Here and below, the base is the link that carries the
/// scanner.
struct RangeScannerParameters {
    std::string name;
    Pose scanner_in_base;
    double resolution_rad = pi / 180.0;
    double fov_rad = pi; ///< full angle
    double minimum_m = 0.1;
    double maximum_m = 20.0;
    double sigma = 0.0007; ///< see RangeNoise
};

/// The beams go from right to left, -fov/2 to fov/2 counter-clockwise; there are floor(fov / resolution) + 1 of them.
class RangeScanner {
public:
    RangeScanner(RangeScannerParameters parameters, Random random);

    /// One scan, without time and type.
    protocol::RangeScan measure(const Eigen::Isometry3d& base_in_map, const Rays& rays);
    const RangeScannerParameters& parameters() const { return parameters_; }

private:
    RangeScannerParameters parameters_;
    std::vector<Vec3> directions_in_base_;
    RangeNoise noise_;
};

} // namespace usar::sim
