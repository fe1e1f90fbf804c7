// What range sensors measured, prepared for painting: a scan as a cross-section, and the columns of the sonars.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include <QPointF>
#include <QString>

#include "core/agent/published.h"
#include "core/modules/sensor.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/usual_values.h"

namespace usar::widgets {

/// End of a ray in meters in the scanner's plane: negative x is to the robot's left, y is along the beam at angle 0
/// (down for a belly scanner).
struct LaserRay {
    QPointF end_m;
    bool hit = false; ///< false: the reading is the maximum range or no number
};

/// A scan prepared for painting; without rays there is no scan yet.
struct LaserSection {
    std::vector<LaserRay> rays; ///< one per beam, in the order of the scan
    double maximum_m = protocol::usual_scanner_maximum_m;
    /// Distance in the direction of the beam at angle 0: mean of the hits within 2 degrees of it; nullopt: no hits.
    std::optional<double> clearance_m;
    /// Shortest range of all hits; nullopt: no hits.
    std::optional<double> nearest_m;

    /// Depth, in meters, that the picture should show; a round value, so that the scale does not change with every
    /// scan.
    double depthShown_m() const;
};

/// Computes the rays; a range of `maximum_m` or more is a miss.
LaserSection laserSection(const protocol::RangeScan& scan, double maximum_m);

/// The sonars with plain ranges and without risk zones, for when no behavior runs: L4 to L1, M0, R1 to R4; sensors with
/// other names follow in the order of the map. `maximum_m` is the range of all of them, in meters.
agent::SonarZones zonesOf(const std::map<std::string, double>& ranges_m, double maximum_m);

/// "low", "high" or empty: the word shown in the column.
QString riskWord(agent::Risk risk);

} // namespace usar::widgets
