#include "widgets/models/sonar_columns.h"

#include <algorithm>

#include "core/base/numbers.h"

namespace usar::widgets {

namespace {

/// Returns the place in the ring: L4 = -4 … M0 = 0 … R4 = 4; other names come last.
long long ringPlace(const std::string& name) {
    constexpr long long last = 1000000;
    const auto number = name.size() > 1 ? readInteger(std::string_view(name).substr(1)) : std::nullopt;
    if (!number)
        return last;
    const char side = name.front();
    return side == 'L' ? -*number : side == 'M' ? 0 : side == 'R' ? *number : last;
}

} // namespace

std::vector<SonarColumn> sonarColumns(const agent::SonarZones& zones) {
    std::vector<SonarColumn> columns;
    for (const agent::SonarZone& zone : zones.zones)
        columns.push_back({QString::fromStdString(zone.name), zone.range_m, zone.maximum_m, zone.low_risk_below_m,
                           zone.high_risk_below_m, zone.risk});
    return columns;
}

std::vector<SonarColumn> sonarColumns(const std::map<std::string, double>& ranges_m, double maximum_m) {
    std::vector<std::pair<std::string, double>> ordered(ranges_m.begin(), ranges_m.end());
    std::ranges::stable_sort(ordered, {}, [](const auto& entry) { return ringPlace(entry.first); });
    std::vector<SonarColumn> columns;
    for (const auto& [name, range_m] : ordered)
        columns.push_back({QString::fromStdString(name), range_m, maximum_m, 0.0, 0.0, agent::Risk::None});
    return columns;
}

QString riskWord(agent::Risk risk) {
    return risk == agent::Risk::None  ? QString()
           : risk == agent::Risk::Low ? QStringLiteral("low")
                                      : QStringLiteral("high");
}

} // namespace usar::widgets
