// How a mission ended, as a value and in the words and figures of the card that tells it.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QString>
#include <QStringList>

#include "core/agent/published.h"
#include "core/base/clock.h"

namespace usar::widgets {

/// What is known of a mission that has ended; what is absent is not told.
struct MissionOutcome {
    QString robot{}; ///< its name
    bool success = false;
    QString reason{};                     ///< a sentence
    std::optional<double> coverage_pct{}; ///< of the mission area, 0..100
    std::optional<double>
        reachable_pct{};   ///< the same of what could be reached of the area; absent: all could, or unknown
    QString unreachable{}; ///< a sentence about the rest
    Seconds duration{0.0}; ///< on the protocol clock
    double distance_m = 0.0;
    int charges = 0;
    std::optional<std::pair<double, double>> heights_m{}; ///< lowest and highest of the map
    std::optional<double> error_m{};                      ///< of the map on open ground, root mean square
    /// Difference of the heights where strips overlap, root mean square, as flown and in the corrected map.
    std::optional<std::pair<double, double>> overlaps_m{};
    /// How far the correction of the map has moved the path, mean and greatest.
    std::optional<std::pair<double, double>> shift_m{};
    QStringList files{}; ///< full paths; empty: nothing was scanned
};

/// What a behavior has told of its mission: how it ended and its last status. What only the files tell is left out.
MissionOutcome outcomeOf(const QString& robot, std::optional<double> coverage_pct,
                         const std::optional<agent::BehaviorFinished>& finished,
                         const std::optional<agent::BehaviorStatus>& status);

/// A figure of the card: "Coverage", "99.7 %", and what it means.
struct OutcomeFigure {
    QString name;
    QString value;
    QString help;
};

/// The figures that are known, in the order of the card.
std::vector<OutcomeFigure> figuresOf(const MissionOutcome& outcome);
/// "R1: mission complete", or "R1: mission ended early".
QString titleOf(const MissionOutcome& outcome);
/// Path of a picture among the files, of the map and of it in perspective; empty: there is none.
QString pictureOf(const MissionOutcome& outcome);
QString reliefPictureOf(const MissionOutcome& outcome);
/// Path of the summary (.json) among the files; empty: there is none.
QString summaryOf(const MissionOutcome& outcome);
/// The folder of the files; empty: there are none.
QString folderOf(const MissionOutcome& outcome);

} // namespace usar::widgets
