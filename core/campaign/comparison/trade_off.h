// How the variants of a campaign stand in two figures at once, such as time against error: what is gained in one is
// often paid for in the other.
#pragma once

#include <string>
#include <vector>

#include <QByteArray>
#include <QXmlStreamWriter>

#include "core/campaign/comparison/metric.h"
#include "core/campaign/comparison/run_figures.h"
#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

/// The middle of a figure, and the range of the middle half of the runs (quartiles), in the metric's unit.
struct Middle {
    double median = 0.0;
    Interval half;
};

/// One variant in one mission.
struct TradePoint {
    std::string variant;
    std::size_t place = 0; ///< among all variants; gives it its color
    std::size_t done = 0;
    std::size_t runs = 0; ///< those that count (see counts)
    Middle x;             ///< Only runs count that were done and have both figures.
    Middle y;
};

/// The variants that have both figures, in the order of their first runs.
struct TradeOff {
    std::string mission;
    Metric x;
    Metric y;
    std::vector<TradePoint> points;
};

/// Duration against mapping error and duration against coverage for each mission, in the order of their first runs;
/// without those in which fewer than two variants have both figures. If all runs are of one variant, it is enough.
std::vector<TradeOff> tradeOffsOf(const std::vector<RunFigures>& runs);

/// Draws a cross for each variant, as wide and high as the middle half of its runs.
void drawTradeOff(QXmlStreamWriter& xml, const TradeOff& trade_off);

/// All of them as one SVG picture, two in a row, with the style sheet within it; empty if there are none.
QByteArray tradeOffPicture(const std::vector<TradeOff>& trade_offs, const std::string& title);

} // namespace usar::campaign
