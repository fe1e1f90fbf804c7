// How wrong a robot's estimates of its position were, over the time of its flights.
#pragma once

#include <cstddef>
#include <vector>

#include "core/mapping/scan_store.h"

namespace usar::mapping {

/// Errors are estimate minus truth, map frame, meters; `sigma_m` is their standard deviation.
struct PathKnot {
    Seconds time{0.0}; ///< clock of the ScanStore
    Vec3 error_m = Vec3::Zero();
    Vec3 sigma_m = Vec3::Zero();
    double yaw_error_rad = 0.0;

    /// A pose that was told at that time, without the error.
    Pose corrected(Pose in_map) const;
};

/// Between two knots of a sortie an error is interpolated linearly; before the first and after the last one it stays
/// the same. A plain value.
struct PathCorrection {
    std::vector<std::vector<PathKnot>> sorties; ///< knots by sortie of the ScanStore, in order of time

    /// The error at a time of a sortie; zero, with zero sigma, for a sortie that has no knots.
    PathKnot at(std::size_t sortie, Seconds time) const;
    /// The pose of a scan without the errors of its position and its yaw.
    Pose corrected(const KeptScan& scan) const;
};

} // namespace usar::mapping
