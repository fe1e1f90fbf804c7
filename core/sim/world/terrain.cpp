#include "core/sim/world/terrain.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace usar::sim {

Terrain::Terrain(std::size_t columns, std::size_t rows, double step_m, Vec2 origin_m, std::vector<float> heights_m)
    : columns_(columns)
    , rows_(rows)
    , step_m_(step_m)
    , origin_m_(origin_m)
    , heights_m_(std::move(heights_m)) {
    assert(columns_ >= 2 && rows_ >= 2 && step_m_ > 0.0 && heights_m_.size() == columns_ * rows_);
    const auto [lowest, highest] = std::minmax_element(heights_m_.begin(), heights_m_.end());
    minimum_m_ = *lowest;
    maximum_m_ = *highest;
}

std::optional<Terrain> Terrain::level(const Rectangle& extent, double z_m) {
    constexpr double most_cells = 4096.0;
    if (extent.empty())
        return std::nullopt;
    const double shorter_m = std::min(extent.width_m(), extent.height_m());
    const double longer_m = std::max(extent.width_m(), extent.height_m());
    for (double cells = 1.0; cells * longer_m / shorter_m <= most_cells; cells += 1.0) {
        const double step_m = shorter_m / cells;
        const double along = longer_m / step_m;
        if (std::abs(along - std::round(along)) > 1e-9 * along)
            continue;
        const auto posts = [&](double side_m) { return static_cast<std::size_t>(std::lround(side_m / step_m)) + 1; };
        const std::size_t columns = posts(extent.width_m());
        const std::size_t rows = posts(extent.height_m());
        return Terrain(columns, rows, step_m, extent.min_m,
                       std::vector<float>(columns * rows, static_cast<float>(z_m)));
    }
    return std::nullopt;
}

Rectangle Terrain::extent() const {
    if (empty())
        return {};
    const Vec2 size_m{static_cast<double>(columns_ - 1) * step_m_, static_cast<double>(rows_ - 1) * step_m_};
    return {origin_m_, origin_m_ + size_m};
}

double Terrain::height_m(const Vec2& point_m) const {
    if (empty())
        return 0.0;
    const double x = std::clamp((point_m.x() - origin_m_.x()) / step_m_, 0.0, static_cast<double>(columns_ - 1));
    const double y = std::clamp((point_m.y() - origin_m_.y()) / step_m_, 0.0, static_cast<double>(rows_ - 1));
    const std::size_t column = std::min(static_cast<std::size_t>(x), columns_ - 2);
    const std::size_t row = std::min(static_cast<std::size_t>(y), rows_ - 2);
    const double u = x - static_cast<double>(column);
    const double v = y - static_cast<double>(row);
    const double low = post_m(column, row);
    const double high = post_m(column + 1, row + 1);
    if (u >= v) {
        const double right = post_m(column + 1, row);
        return low + u * (right - low) + v * (high - right);
    }
    const double left = post_m(column, row + 1);
    return low + v * (left - low) + u * (high - left);
}

} // namespace usar::sim
