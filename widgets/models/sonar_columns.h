// The nine columns of the sonar view: names, ranges and zones in ring order, from either source.
#pragma once

#include <map>
#include <vector>

#include <QString>

#include "core/agent/published.h"
#include "core/modules/sensor.h"

namespace usar::widgets {

/// One sensor of the ring: metres along its beam, and the limits below which a reading is a risk.
struct SonarColumn {
    QString name;
    double range_m = 0.0; ///< NaN where the server sent no number
    double maximum_m = 5.0;
    double low_risk_below_m = 0.0; ///< 0: no zone known
    double high_risk_below_m = 0.0;
    agent::Risk risk = agent::Risk::None;
    bool operator==(const SonarColumn&) const = default;
};

/// As the behavior judges them; the order is the behavior's.
std::vector<SonarColumn> sonarColumns(const agent::SonarZones& zones);
/// Plain ranges, when no behavior runs: L4 to L1, M0, R1 to R4; other names follow in their own order.
std::vector<SonarColumn> sonarColumns(const std::map<std::string, double>& ranges_m, double maximum_m);

/// "low", "high" or nothing: the word in the column.
QString riskWord(agent::Risk risk);

} // namespace usar::widgets
