#include "core/mission/runs/run_summary.h"

#include <cmath>

#include <QJsonArray>

#include "core/mapping/hole_fill.h"
#include "core/mission/files/mission_check.h"

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

QJsonValue continuedBy(const std::optional<ContinuedRun>& run) {
    if (!run)
        return QJsonValue::Null;
    return QJsonObject{{"recording", run->recording},
                       {"duration_s", number(run->duration.count(), 2)},
                       {"distance_m", number(run->distance_m, 2)},
                       {"charges", run->charges},
                       {"cells", static_cast<qint64>(run->cells)}};
}

const char* wordOf(mapping::AdjustmentVerdict verdict) {
    switch (verdict) {
    case mapping::AdjustmentVerdict::Declined:
        return "declined";
    case mapping::AdjustmentVerdict::Bridged:
        return "bridged";
    case mapping::AdjustmentVerdict::Adjusted:
        return "adjusted";
    }
    return "";
}

QJsonValue adjustedBy(const std::optional<MapAdjustment>& adjustment) {
    if (!adjustment)
        return QJsonValue::Null;
    const std::optional<PathShift>& shift = adjustment->shift;
    return QJsonObject{{"verdict", wordOf(adjustment->verdict)},
                       {"reason", text(adjustment->reason)},
                       {"residual_before_m", number(adjustment->residual_before_m, 4)},
                       {"residual_after_m", number(adjustment->residual_after_m, 4)},
                       {"overlaps", static_cast<qint64>(adjustment->overlaps)},
                       {"mean_shift_m", number(shift ? std::optional(shift->mean_m) : std::nullopt, 3)},
                       {"greatest_shift_m", number(shift ? std::optional(shift->greatest_m) : std::nullopt, 3)}};
}

QJsonValue seedOf(const RunSummary& summary) {
    return summary.seed ? QJsonValue(static_cast<qint64>(*summary.seed)) : QJsonValue(QJsonValue::Null);
}

/// All keys are there; those of unknown figures are null.
void addTruth(QJsonObject& json, const std::optional<TrueFigures>& truth) {
    for (const char* key : {"collisions", "true_distance_m", "longest_stay_s", "falls", "touches", "first_touch_s",
                            "contacts_after_stop", "least_height_m", "mean_height_m", "height_spread_m"})
        json[key] = QJsonValue::Null;
    if (!truth)
        return;
    json["collisions"] = truth->collisions;
    json["true_distance_m"] = number(truth->distance_m, 2);
    json["longest_stay_s"] = number(truth->longest_stay.count(), 1);
    json["falls"] = truth->falls;
    json["touches"] = truth->touches;
    if (truth->first_touch)
        json["first_touch_s"] = number(truth->first_touch->count(), 1);
    if (truth->contacts_after_stop)
        json["contacts_after_stop"] = *truth->contacts_after_stop;
    if (const auto& height = truth->height) {
        json["least_height_m"] = number(height->least_m, 2);
        json["mean_height_m"] = number(height->mean_m, 2);
        json["height_spread_m"] = number(height->spread_m, 2);
    }
}

QJsonArray pointOf(const Vec2& point_m) {
    return {number(point_m.x(), 2), number(point_m.y(), 2)};
}

QJsonArray pointsOf(const std::vector<Vec2>& points_m) {
    QJsonArray points;
    for (const Vec2& point_m : points_m)
        points << pointOf(point_m);
    return points;
}

QJsonObject toJson(const RunCourse& course, const std::optional<TrueFigures>& truth) {
    QJsonArray coverage, collisions;
    for (const CoveragePoint& point : course.coverage)
        coverage << QJsonArray{number(point.elapsed.count(), 1), number(point.coverage_pct, 2)};
    if (truth)
        for (const Vec3& place_m : truth->collision_places_in_map_m)
            collisions << pointOf(place_m.head<2>());
    return {{"coverage", coverage},
            {"given_up", pointsOf(course.given_up_in_map_m)},
            {"path", pointsOf(course.path_in_map_m)},
            {"collisions", collisions}};
}

QJsonArray verdictsOf(const std::vector<ClaimVerdict>& verdicts) {
    QJsonArray list;
    for (const ClaimVerdict& verdict : verdicts)
        list << QJsonObject{
            {"claim", text(sentenceOf(verdict.claim))}, {"holds", verdict.holds == true}, {"why", text(verdict.why)}};
    return list;
}

} // namespace

RunCourse courseOf(const ScanRecord& record, double coverage_pct, std::size_t most) {
    RunCourse course{record.course.points(), {}, {}};
    if (course.coverage.empty() || course.coverage.back().elapsed < record.status.elapsed)
        course.coverage.push_back({record.status.elapsed, coverage_pct});
    for (const agent::MapMark& mark : record.marks)
        if (mark.kind == agent::MarkKind::GoalGivenUp && course.given_up_in_map_m.size() < most)
            course.given_up_in_map_m.emplace_back(mark.position_in_map_m.head<2>());
    const std::vector<Vec3>& path_m = record.path_m;
    const std::size_t step = path_m.size() / (most - 1) + 1; // At most `most` - 1 points, and the last one.
    for (std::size_t i = 0; i + 1 < path_m.size(); i += step)
        course.path_in_map_m.emplace_back(path_m[i].head<2>());
    if (!path_m.empty())
        course.path_in_map_m.emplace_back(path_m.back().head<2>());
    return course;
}

void judgeDamage(RunSummary& summary) {
    if (!summary.success || !summary.truth || !summary.truth->broken)
        return;
    summary.success = false;
    summary.reason += " But the robot is broken.";
}

void addSession(RunSummary& summary, const SessionFigures& figures) {
    summary.lines_received = figures.lines_received;
    summary.lines_malformed = figures.lines_malformed;
    summary.lockstep = figures.lockstep;
}

void addRecord(RunSummary& summary, const ScanRecord& record, const Truth* truth,
               const std::optional<FlightLimits>& flight) {
    summary.distance_m = record.status.distance_flown_m;
    summary.charges = record.status.charges;
    summary.score = score(record.raster, record.area_in_map, truth);
    summary.cells = knownCellCount(record);
    summary.filled_m2 = mapping::holes_m2(record.raster);
    summary.heights = record.raster.range();
    summary.faults += textsOf(record.faults);
    summary.continues = record.continues;
    summary.adjustment = record.adjustment;
    if (truth && flight)
        summary.reach = areaReach(record.raster, record.area_in_map, *truth, *flight);
    const std::string warning = summary.reach ? unreachableNotice(*summary.reach)
                                : truth       ? beyondWorldNotice(record.area_in_map, truth->world_in_map)
                                              : std::string();
    if (!warning.empty())
        summary.warnings += QString::fromStdString(warning);
}

QJsonObject toJson(const RunSummary& summary) {
    const double wall_s = summary.wall.count();
    const auto& reach = summary.reach;
    QJsonObject json{
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
        {"reachable_coverage_pct", number(reach ? std::optional(reach->coverage_pct) : std::nullopt, 2)},
        {"unreachable_m2", number(reach ? std::optional(reach->unreachable_m2()) : std::nullopt, 1)},
        {"rmse_m", number(summary.score.rmse_m, 4)},
        {"rmse_surface_m", number(summary.score.rmse_surface_m, 4)},
        {"cells", static_cast<qint64>(summary.cells)},
        {"filled_m2", number(summary.filled_m2, 2)},
        {"lines_received", static_cast<qint64>(summary.lines_received)},
        {"lines_malformed", static_cast<qint64>(summary.lines_malformed)},
        {"lockstep", summary.lockstep},
        {"continues", continuedBy(summary.continues)},
        {"adjustment", adjustedBy(summary.adjustment)},
        {"warnings", QJsonArray::fromStringList(summary.warnings)},
        {"faults", QJsonArray::fromStringList(summary.faults)},
        {"files", QJsonArray::fromStringList(summary.files)}};
    addTruth(json, summary.truth);
    if (!summary.claims.empty())
        json["claims"] = verdictsOf(summary.claims);
    if (summary.course)
        json["course"] = toJson(*summary.course, summary.truth);
    return json;
}

} // namespace usar::mission
