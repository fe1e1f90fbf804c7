// The columns of the sonar view (nine for the usual ring): names, ranges and risk zones, in the order of the ring.
#pragma once

#include <map>
#include <vector>

#include <QString>

#include "core/agent/published.h"
#include "core/modules/sensor.h"
#include "core/protocol/usual_values.h"

namespace usar::widgets {

/// One sensor of the ring: range along its beam in meters, and the limits below which a reading is a risk.
struct SonarColumn {
    QString name;
    double range_m = 0.0;                               ///< NaN if the server sent no number
    double maximum_m = protocol::usual_sonar_maximum_m; ///< full height of the column
    double low_risk_below_m = 0.0;                      ///< 0: no zone known
    double high_risk_below_m = 0.0;
    agent::Risk risk = agent::Risk::None;
    bool operator==(const SonarColumn&) const = default;
};

/// The columns as the behavior judges them, in the behavior's order.
std::vector<SonarColumn> sonarColumns(const agent::SonarZones& zones);
/// The columns for plain ranges, without risk zones, for when no behavior runs: L4 to L1, M0, R1 to R4; sensors with
/// other names follow in the order of the map.
std::vector<SonarColumn> sonarColumns(const std::map<std::string, double>& ranges_m, double maximum_m);

/// "low", "high" or empty: the word shown in the column.
QString riskWord(agent::Risk risk);

} // namespace usar::widgets
