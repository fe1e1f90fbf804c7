// What the user has drawn to measure the ground: a line with the heights along it, or the rectangle that it spans.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <QString>

#include "core/base/geometry.h"

namespace usar::widgets {

/// Both ends are in meters of the map frame.
struct MeasuredLine {
    Vec2 from_m = Vec2::Zero();
    Vec2 to_m = Vec2::Zero();
    bool spans_rectangle = false; ///< the line is the diagonal of the rectangle that is measured
    bool operator==(const MeasuredLine&) const = default;

    double length_m() const { return (to_m - from_m).norm(); }
    Rectangle rectangle_in_map() const { return {from_m.cwiseMin(to_m), from_m.cwiseMax(to_m)}; }
};

/// Heights at evenly spaced points of the line, both ends included.
struct LineProfile {
    double length_m = 0.0;
    std::vector<std::optional<double>> heights_m; ///< nullopt: unknown there

    /// Lowest and highest of the known heights; nullopt if none is known.
    std::optional<std::pair<double, double>> range_m() const;
    /// How much higher the last known height is than the first one; nullopt if none is known.
    std::optional<double> rise_m() const;
};

/// Looks up heights along the line, one for each cell that it crosses, but at most `most_points`.
LineProfile profileOf(const MeasuredLine& line, double cell_size_m,
                      const std::function<std::optional<double>(const Vec2&)>& height_at_m, int most_points = 2000);

/// "34.2 m · 1.20 … 4.31 m · rises 3.11 m"; the heights are left out where none is known.
QString profileText(const LineProfile& profile);
/// "12.0 × 8.5 m · 102.0 m² · heights 1.20 … 4.31 m"; `range_m`: lowest and highest height, nullopt: unknown.
QString rectangleText(const Rectangle& rectangle, const std::optional<std::pair<double, double>>& range_m);

} // namespace usar::widgets
