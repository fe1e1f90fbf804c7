// The drawings of a report, as inline SVG. Colors, fonts and strokes are classes of the style sheet, so that each
// drawing follows the reader's theme and the printer's.
#pragma once

#include <QXmlStreamWriter>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// Where the interval of the difference lies, against zero and the margin: one line of a table. The good side is on the
/// right for every metric, so that columns of intervals are read at a glance.
void drawInterval(QXmlStreamWriter& xml, const MetricComparison& result);
/// The same for the difference of the success rates.
void drawInterval(QXmlStreamWriter& xml, const SuccessComparison& success, double margin);

/// The differences of all pairs in ascending order, with zero and the margin; of more than a few hundred pairs every
/// n-th. The good ones have the color of what is good. Those far from most stand at the edge, and are counted there.
void drawDifferences(QXmlStreamWriter& xml, const MetricComparison& result);

/// Some values of a variant, which is drawn by its own stroke.
struct ProfileCurve {
    QString name;
    std::vector<double> sorted; ///< in ascending order
};

/// The performance profile: for each value x the share of `runs` that needed at most x. What is not in a curve never
/// got there, so that a curve ends below 1 where runs failed, and stays at 0 where none was done. A curve without a
/// name is not drawn. Draws nothing if neither has a value.
void drawProfile(QXmlStreamWriter& xml, const ProfileCurve& baseline, const ProfileCurve& candidate, std::size_t runs,
                 const Metric& metric);

} // namespace usar::campaign
