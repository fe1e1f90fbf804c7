// What is plotted and how, without any values: canvases, series and options, as readable JSON.
#pragma once

#include <string>
#include <vector>

#include <QJsonObject>

#include "core/base/result.h"

namespace usar::widgets {

/// A field that is plotted.
struct PlotSeries {
    std::string robot; ///< the robot that it was taken from; empty: the selected one, whoever that is
    std::string path;  ///< as protocol::Field::path() returns it
    std::string unit;  ///< SI unit; may be empty until the first value
    bool operator==(const PlotSeries&) const = default;
};

/// The layout of the plots. In a file:
///
///     {"version": 1, "follow_robot": true, "statistics": false, "window_s": 60,
///      "canvases": [{"series": [{"robot": "R1", "path": "SEN Sonar/F1/range", "unit": "m"}]}]}
///
/// `window_s` is a number of seconds, or "all". Plain value.
struct PlotLayout {
    std::vector<std::vector<PlotSeries>> canvases{1}; ///< from top to bottom; never empty
    bool follow_robot = true;                         ///< the series become those of the robot that is selected
    bool statistics = false;                          ///< the table shows statistics
    double window_s = 60.0;                           ///< span of time while following; infinity: all
    bool operator==(const PlotLayout&) const = default;

    static constexpr std::size_t most_canvases = 8;
};

/// The layout as an object of the form above.
QJsonObject toJson(const PlotLayout& layout);
/// Reads what `toJson` wrote. Missing options have their defaults and unknown keys are ignored, so that layouts of
/// other versions are understood as far as possible; an entry of another type than above is an error that names it.
Result<PlotLayout> plotLayoutFrom(const QJsonObject& object);

} // namespace usar::widgets
