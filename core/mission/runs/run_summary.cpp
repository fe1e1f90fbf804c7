#include "core/mission/runs/run_summary.h"

#include <cmath>

#include <QJsonArray>

namespace usar::mission {

namespace {

/// Rounds to a readable number of digits; null if the value is not finite.
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

/// Returns `tell` applied to the part, or null if there is none.
template <class Part, class Tell>
QJsonValue partOf(const Part* part, Tell tell) {
    return part ? QJsonValue(tell(*part)) : QJsonValue(QJsonValue::Null);
}

template <class Part>
const Part* pointerTo(const std::optional<Part>& part) {
    return part ? &*part : nullptr;
}

QJsonObject truthToJson(const std::optional<TrueFigures>& figures) {
    const TrueFigures* const truth = pointerTo(figures);
    const HeightOverGround* const height = truth ? pointerTo(truth->height) : nullptr;
    const Seconds* const first_touch = truth ? pointerTo(truth->first_touch) : nullptr;
    return {
        {"collisions", partOf(truth, [](const TrueFigures& one) { return one.collisions; })},
        {"true_distance_m", partOf(truth, [](const TrueFigures& one) { return number(one.distance_m, 2); })},
        {"longest_stay_s", partOf(truth, [](const TrueFigures& one) { return number(one.longest_stay.count(), 1); })},
        {"falls", partOf(truth, [](const TrueFigures& one) { return one.falls; })},
        {"touches", partOf(truth, [](const TrueFigures& one) { return one.touches; })},
        {"first_touch_s", partOf(first_touch, [](Seconds at) { return number(at.count(), 1); })},
        {"least_height_m", partOf(height, [](const HeightOverGround& one) { return number(one.least_m, 2); })},
        {"mean_height_m", partOf(height, [](const HeightOverGround& one) { return number(one.mean_m, 2); })},
        {"height_spread_m", partOf(height, [](const HeightOverGround& one) { return number(one.spread_m, 2); })}};
}

} // namespace

void addSession(RunSummary& summary, const SessionFigures& figures) {
    summary.lines_received = figures.lines_received;
    summary.lines_malformed = figures.lines_malformed;
    summary.lockstep = figures.lockstep;
}

void addRecord(RunSummary& summary, const ScanRecord& record, const Truth* truth) {
    summary.distance_m = record.status.distance_flown_m;
    summary.charges = record.status.charges;
    summary.score = score(record.raster, record.area_in_map, truth);
    summary.cells = knownCellCount(record);
    for (const std::string& fault : record.faults)
        summary.faults << QString::fromStdString(fault);
}

QJsonObject toJson(const RunSummary& summary) {
    const double wall_s = summary.wall.count();
    QJsonObject all = truthToJson(summary.truth);
    const QJsonObject own{
        {"success", summary.success},
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
        {"coverage_pct", number(summary.score.coverage_pct, 2)},
        {"rmse_m", number(summary.score.rmse_m, 4)},
        {"rmse_surface_m", number(summary.score.rmse_surface_m, 4)},
        {"cells", static_cast<qint64>(summary.cells)},
        {"lines_received", static_cast<qint64>(summary.lines_received)},
        {"lines_malformed", static_cast<qint64>(summary.lines_malformed)},
        {"lockstep", summary.lockstep},
        {"faults", QJsonArray::fromStringList(summary.faults)},
        {"files", QJsonArray::fromStringList(summary.files)}};
    for (auto one = own.begin(); one != own.end(); ++one)
        all[one.key()] = one.value();
    return all;
}

} // namespace usar::mission
