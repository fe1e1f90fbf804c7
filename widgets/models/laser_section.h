// A scan as a cross-section under the robot: where every ray ends, and the terrain line through the hits.
#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "core/protocol/sensors/range_scan.h"

namespace usar::widgets {

/// In metres in the scanner's plane: x to the robot's left is negative (drawn on the left, as seen from behind), y is
/// down. The belly scanner's beam at angle 0 looks straight down.
struct LaserRay {
    QPointF end_m;
    bool hit = false; ///< false: the reading is the maximum range or no number
};

/// A value to paint from; without beams there is no scan yet.
struct LaserSection {
    std::vector<LaserRay> rays; ///< one per beam, in the scan's order
    double maximum_m = 20.0;
    std::optional<double> clearance_m; ///< straight down, mean of the beams within 2 degrees
    std::optional<double> nearest_m;

    /// Depth that the picture should show: round, so that it does not breathe with every scan.
    double depthShown_m() const;
};

/// A range at or beyond `maximum_m` is a miss.
LaserSection laserSection(const protocol::RangeScan& scan, double maximum_m);

} // namespace usar::widgets
