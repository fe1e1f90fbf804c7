// Names, figures and tables of the plots as text.
#pragma once

#include <string>
#include <vector>

#include <QString>

#include "widgets/models/plot/plot_model.h"

namespace usar::widgets {

/// "Sonar F1 range" for the path "SEN Sonar/F1/range"; the repeated name in "INS/INS/yaw" is said once.
QString spokenPath(const std::string& path);
/// "R1 · Sonar F1 range": whose value it is, always.
QString labelOf(const SeriesKey& key);
/// "00:01:02.3", on the protocol clock.
QString momentText(double time_s);

/// A value of this SI unit as it is shown: "28.65 °". "≈" stands before one that is not exact, "–" for none.
QString readingText(const std::optional<Reading>& reading, const std::string& unit);
/// A difference or slope: with a sign. `per`: what stands behind the unit, as "/s"; may be empty.
QString differenceText(const std::optional<double>& difference, const std::string& unit, const QString& per = {});
/// What the cursors read of all series that are shown, in sentences, for screen readers. Empty without a cursor.
QString cursorSentences(const PlotModel& model);

/// Statistics in the order of the table's columns: n, least, most, mean, standard deviation.
std::vector<QString> statisticsTexts(const Statistics& statistics, const std::string& unit);

/// One column of a table.
struct TableColumn {
    std::string head;            ///< "R1 SEN Sonar/F1/range [m]"
    std::vector<Sample> samples; ///< in SI units and in order of time
};
/// Every sample that is known one by one of what is shown (see SampleHistory), each series once.
std::vector<TableColumn> tableOf(const PlotModel& model);
/// CSV with the head "time_s,R1 SEN Sonar/F1/range [m],…" and one row for every time at which any series has a sample;
/// cells without a sample or with NaN are empty. Values are in SI units and read back to the same double. May take a
/// second for long histories, so call it in a pool thread.
std::string csvOf(const std::vector<TableColumn>& columns);

} // namespace usar::widgets
