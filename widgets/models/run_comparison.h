// The figures of finished runs side by side, read from the summaries (.json) that missions leave with their results.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "core/base/result.h"

namespace usar::widgets {

/// What a summary tells of a run; what it does not tell is absent. The keys of the file are in run_summary.h.
struct RunFigures {
    QString path{};     ///< of the summary
    QString title{};    ///< what it is known by to whoever compares it, such as its variant; empty: by its file
    QString mission{};  ///< its name; empty: unknown
    QString behavior{}; ///< its id; empty: unknown
    std::optional<bool> success{};
    std::optional<double> coverage_pct{};           ///< of the mission area, 0..100
    std::optional<double> reachable_coverage_pct{}; ///< of what could be reached of it
    std::optional<double> duration_s{};             ///< on the protocol clock
    std::optional<double> distance_m{};
    std::optional<double> lowest_m{}; ///< of the map
    std::optional<double> highest_m{};
    std::optional<double> error_m{}; ///< of the map on open ground, root mean square
    std::optional<double> charges{};
    std::optional<double> collisions{};
    QString picture{}; ///< path of the picture of the map; empty: there is none
};

/// Reads a summary. The error names the file, what is wrong with it, and what to choose instead. Reads files, so call
/// it outside of the GUI thread.
Result<RunFigures> readRun(const QString& path);

/// One figure of one run.
struct ComparedCell {
    QString value;       ///< with its unit; a dash if unknown
    QString difference;  ///< from the first run, with sign and unit: "+1.2 %"; empty for the first, or if unknown
    bool better = false; ///< none of the runs is better, and one of them is worse
};

/// One figure of all runs, in the order of the runs.
struct ComparedRow {
    QString name;
    QString help;
    std::vector<ComparedCell> cells;
};

/// The rows are always the same, also if no run knows the figure.
std::vector<ComparedRow> compared(const std::vector<RunFigures>& runs);
/// "Quick scan", and the run's title or the name of its file, because missions are flown more than once.
QString titleOf(const RunFigures& run);

} // namespace usar::widgets
