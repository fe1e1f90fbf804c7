#include "widgets/models/mission_outcome.h"

#include <algorithm>

#include <QFileInfo>
#include <QObject>

#include "core/mapping/raster_export.h"
#include "core/mapping/relief/relief_scene.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

/// The first of the files whose name ends like this; empty: there is none.
QString fileWith(const char* ending, const MissionOutcome& outcome) {
    const auto fits = [&](const QString& path) { return path.endsWith(QLatin1String(ending)); };
    const auto found = std::ranges::find_if(outcome.files, fits);
    return found == outcome.files.end() ? QString() : *found;
}

} // namespace

MissionOutcome outcomeOf(const QString& robot, std::optional<double> coverage_pct,
                         const std::optional<agent::BehaviorFinished>& finished,
                         const std::optional<agent::BehaviorStatus>& status) {
    MissionOutcome outcome{.robot = robot, .coverage_pct = coverage_pct};
    if (finished) {
        outcome.success = finished->success;
        outcome.reason = QString::fromStdString(finished->reason);
    }
    if (status) {
        outcome.duration = status->elapsed;
        outcome.distance_m = status->distance_flown_m;
        outcome.charges = status->charges;
    }
    return outcome;
}

std::vector<OutcomeFigure> figuresOf(const MissionOutcome& outcome) {
    std::vector<OutcomeFigure> figures;
    if (outcome.coverage_pct)
        figures.push_back({QObject::tr("Coverage"), QObject::tr("%1 %").arg(figure(*outcome.coverage_pct, 1)),
                           QObject::tr("Part of the mission area whose height is known")});
    if (outcome.reachable_pct)
        figures.push_back({QObject::tr("Of what can be reached"),
                           QObject::tr("%1 %").arg(figure(*outcome.reachable_pct, 1)), outcome.unreachable});
    figures.push_back(
        {QObject::tr("Time"), durationText(outcome.duration), QObject::tr("Since the start, on the robot's clock")});
    figures.push_back({QObject::tr("Distance"), QObject::tr("%1 m").arg(figure(outcome.distance_m, 0)),
                       QObject::tr("As the robot estimates it")});
    if (outcome.heights_m)
        figures.push_back(
            {QObject::tr("Heights"),
             QObject::tr("%1 to %2 m").arg(figure(outcome.heights_m->first, 1), figure(outcome.heights_m->second, 1)),
             QObject::tr("Lowest and highest place of the whole map")});
    if (outcome.error_m)
        figures.push_back({QObject::tr("Error"), QObject::tr("%1 m").arg(figure(*outcome.error_m, 2)),
                           QObject::tr("Root mean square difference to the simulator's true heights, on open ground")});
    if (outcome.overlaps_m)
        figures.push_back({QObject::tr("Overlaps"),
                           QObject::tr("%1 m, before %2 m")
                               .arg(figure(outcome.overlaps_m->second, 2), figure(outcome.overlaps_m->first, 2)),
                           QObject::tr("Root mean square difference of the heights where strips overlap, in the "
                                       "corrected map and as it was flown")});
    if (outcome.shift_m)
        figures.push_back({QObject::tr("Path moved"),
                           QObject::tr("%1 m, %2 m at most")
                               .arg(figure(outcome.shift_m->first, 2), figure(outcome.shift_m->second, 2)),
                           QObject::tr("How far the correction of the map has moved the path, on average and at most; "
                                       "the map shows the corrected path as a dashed line")});
    if (outcome.charges > 0)
        figures.push_back({QObject::tr("Charges"), QString::number(outcome.charges),
                           QObject::tr("How often the battery was charged")});
    return figures;
}

QString titleOf(const MissionOutcome& outcome) {
    return (outcome.success ? QObject::tr("%1: mission complete") : QObject::tr("%1: mission ended early"))
        .arg(outcome.robot);
}

QString pictureOf(const MissionOutcome& outcome) {
    return fileWith(mapping::picture_ending, outcome);
}

QString reliefPictureOf(const MissionOutcome& outcome) {
    return fileWith(mapping::relief_picture_ending, outcome);
}

QString summaryOf(const MissionOutcome& outcome) {
    return fileWith(".json", outcome);
}

QString folderOf(const MissionOutcome& outcome) {
    return outcome.files.isEmpty() ? QString() : QFileInfo(outcome.files.front()).path();
}

} // namespace usar::widgets
