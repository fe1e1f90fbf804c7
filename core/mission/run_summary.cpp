#include "core/mission/run_summary.h"

#include <cmath>

#include <QJsonArray>

namespace usar::mission {

namespace {

/// Rounded, for nobody reads the fifteenth digit; what is not a number is null.
QJsonValue number(double value, int decimals) {
    if (!std::isfinite(value))
        return QJsonValue::Null;
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

QJsonValue number(const std::optional<double>& value, int decimals) {
    return value ? number(*value, decimals) : QJsonValue(QJsonValue::Null);
}

QJsonValue text(const std::string& text) {
    return text.empty() ? QJsonValue(QJsonValue::Null) : QString::fromStdString(text);
}

QJsonValue seedOf(const RunSummary& summary) {
    return summary.seed ? QJsonValue(static_cast<qint64>(*summary.seed)) : QJsonValue(QJsonValue::Null);
}

} // namespace

QJsonObject toJson(const RunSummary& summary) {
    const double wall_s = summary.wall.count();
    const std::optional<TrueFigures>& truth = summary.truth;
    return {{"success", summary.success},
            {"reason", QString::fromStdString(summary.reason)},
            {"mission", text(summary.mission)},
            {"behavior", text(summary.behavior)},
            {"plan", text(summary.plan)},
            {"seed", seedOf(summary)},
            {"duration_s", number(summary.duration.count(), 2)},
            {"wall_s", number(wall_s, 3)},
            {"speed_x", wall_s > 0.0 ? number(summary.duration.count() / wall_s, 1) : QJsonValue(QJsonValue::Null)},
            {"distance_m", number(summary.distance_m, 2)},
            {"charges", summary.charges},
            {"collisions", truth ? QJsonValue(truth->collisions) : QJsonValue(QJsonValue::Null)},
            {"true_distance_m", truth ? number(truth->distance_m, 2) : QJsonValue(QJsonValue::Null)},
            {"longest_stay_s", truth ? number(truth->longest_stay.count(), 1) : QJsonValue(QJsonValue::Null)},
            {"coverage_pct", number(summary.score.coverage_pct, 2)},
            {"rmse_m", number(summary.score.rmse_m, 4)},
            {"rmse_surface_m", number(summary.score.rmse_surface_m, 4)},
            {"cells", static_cast<qint64>(summary.cells)},
            {"lines_received", static_cast<qint64>(summary.lines_received)},
            {"lines_malformed", static_cast<qint64>(summary.lines_malformed)},
            {"lockstep", summary.lockstep},
            {"faults", QJsonArray::fromStringList(summary.faults)},
            {"files", QJsonArray::fromStringList(summary.files)}};
}

} // namespace usar::mission
