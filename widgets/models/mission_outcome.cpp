#include "widgets/models/mission_outcome.h"

#include <algorithm>

#include <QCoreApplication>
#include <QFileInfo>

#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("MissionOutcome", text);
}

} // namespace

std::vector<OutcomeFigure> figuresOf(const MissionOutcome& outcome) {
    std::vector<OutcomeFigure> figures;
    if (outcome.coverage_pct)
        figures.push_back({tr("Coverage"), tr("%1 %").arg(figure(*outcome.coverage_pct, 1)),
                           tr("Part of the mission area whose height is known")});
    figures.push_back({tr("Time"), durationText(outcome.duration), tr("Since the start, on the robot's clock")});
    figures.push_back({tr("Distance"), tr("%1 m").arg(figure(outcome.distance_m, 0)), tr("As the robot estimates it")});
    if (outcome.heights_m)
        figures.push_back(
            {tr("Heights"),
             tr("%1 to %2 m").arg(figure(outcome.heights_m->first, 1), figure(outcome.heights_m->second, 1)),
             tr("Lowest and highest place of the whole map")});
    if (outcome.error_m)
        figures.push_back({tr("Error"), tr("%1 m").arg(figure(*outcome.error_m, 2)),
                           tr("Root mean square difference to the simulator's true heights, on open ground")});
    if (outcome.charges > 0)
        figures.push_back({tr("Charges"), QString::number(outcome.charges), tr("How often the battery was charged")});
    return figures;
}

QString titleOf(const MissionOutcome& outcome) {
    return (outcome.success ? tr("%1: mission complete") : tr("%1: mission ended early")).arg(outcome.robot);
}

QString pictureOf(const MissionOutcome& outcome) {
    const auto is_picture = [](const QString& path) { return path.endsWith(QStringLiteral("_picture.png")); };
    const auto found = std::ranges::find_if(outcome.files, is_picture);
    return found == outcome.files.end() ? QString() : *found;
}

QString folderOf(const MissionOutcome& outcome) {
    return outcome.files.isEmpty() ? QString() : QFileInfo(outcome.files.front()).path();
}

} // namespace usar::widgets
