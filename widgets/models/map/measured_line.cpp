#include "widgets/models/map/measured_line.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "widgets/models/figures.h"

namespace usar::widgets {

std::optional<std::pair<double, double>> LineProfile::range_m() const {
    std::optional<std::pair<double, double>> range;
    for (const std::optional<double>& height_m : heights_m)
        if (height_m)
            range = range ? std::pair(std::min(range->first, *height_m), std::max(range->second, *height_m))
                          : std::pair(*height_m, *height_m);
    return range;
}

std::optional<double> LineProfile::rise_m() const {
    const auto known = [](const std::optional<double>& height_m) { return height_m.has_value(); };
    const auto first = std::ranges::find_if(heights_m, known);
    if (first == heights_m.end())
        return std::nullopt;
    const auto last = std::find_if(heights_m.rbegin(), heights_m.rend(), known);
    return **last - **first;
}

LineProfile profileOf(const MeasuredLine& line, double cell_size_m,
                      const std::function<std::optional<double>(const Vec2&)>& height_at_m, int most_points) {
    LineProfile profile{line.length_m(), {}};
    const double steps = std::clamp(std::ceil(profile.length_m / cell_size_m), 1.0, most_points - 1.0);
    for (int i = 0; i <= static_cast<int>(steps); ++i)
        profile.heights_m.push_back(height_at_m(line.from_m + (line.to_m - line.from_m) * (i / steps)));
    return profile;
}

QString profileText(const LineProfile& profile) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("MeasuredLine", text); };
    const QString length = tr("%1 m").arg(figure(profile.length_m, 1));
    const auto range = profile.range_m();
    if (!range)
        return tr("%1 · heights unknown").arg(length);
    const double rise_m = *profile.rise_m();
    return tr("%1 · heights %2 … %3 m · %4 %5 m")
        .arg(length, figure(range->first, 2), figure(range->second, 2), rise_m < 0.0 ? tr("falls") : tr("rises"),
             figure(std::abs(rise_m), 2));
}

QString rectangleText(const Rectangle& rectangle, const std::optional<std::pair<double, double>>& range_m) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("MeasuredLine", text); };
    const QString size =
        tr("%1 × %2 m · %3 m²")
            .arg(figure(rectangle.width_m(), 1), figure(rectangle.height_m(), 1), figure(rectangle.area_m2(), 1));
    return range_m ? tr("%1 · heights %2 … %3 m").arg(size, figure(range_m->first, 2), figure(range_m->second, 2))
                   : tr("%1 · heights unknown").arg(size);
}

} // namespace usar::widgets
