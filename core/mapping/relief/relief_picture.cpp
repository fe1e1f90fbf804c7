#include "core/mapping/relief/relief_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace usar::mapping {

namespace {

using Point = Eigen::Vector3f;

constexpr float nearest_m = static_cast<float>(ReliefProjection::nearest_m);
constexpr std::int32_t per_px = DrawnCorner::per_px;

/// How far a point lies inside of the planes that cut off what has no place on the grid: in front of the camera, and
/// within the guard band on each side.
std::array<float, 5> insides(const Point& at, float slope) {
    return {at.z() - nearest_m, slope * at.z() - at.x(), slope * at.z() + at.x(), slope * at.z() - at.y(),
            slope * at.z() + at.y()};
}

bool allInside(const Point& at, float slope) {
    const auto all = insides(at, slope);
    return std::ranges::all_of(all, [](float inside) { return inside >= 0.0f; });
}

bool withinReach(const Point& at) {
    return at.allFinite() && at.cwiseAbs().maxCoeff() <= ReliefPen::farthest_m;
}

/// Cutting rounds by a part of how far away the cut ends are, so what was cut may lie beyond the planes: a bit does no
/// harm, but this is false for what has no place that a whole number could tell, and for NaN.
bool almostInside(const Point& at, float slope) {
    return at.z() >= nearest_m / 2.0f && std::abs(at.x()) <= 2.0f * slope * at.z() &&
           std::abs(at.y()) <= 2.0f * slope * at.z();
}

/// Where the plane cuts the way from a point inside to one outside. The order of the two makes triangles that share the
/// way share the point as well.
Point cut(const Point& inside, float in, const Point& outside, float out) {
    return inside + (outside - inside) * (in / (in - out));
}

/// A triangle with five corners cut off has eight corners.
struct Polygon {
    std::array<Point, 8> corners;
    std::size_t count = 0;
    void add(const Point& corner) {
        if (count < corners.size())
            corners[count++] = corner;
    }
};

Polygon clipped(const Polygon& polygon, std::size_t plane, float slope) {
    Polygon rest;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const Point& here = polygon.corners[i];
        const Point& next = polygon.corners[(i + 1) % polygon.count];
        const float in_here = insides(here, slope)[plane], in_next = insides(next, slope)[plane];
        if (in_here >= 0.0f)
            rest.add(here);
        if (in_here >= 0.0f && in_next < 0.0f)
            rest.add(cut(here, in_here, next, in_next));
        else if (in_here < 0.0f && in_next >= 0.0f)
            rest.add(cut(next, in_next, here, in_here));
    }
    return rest;
}

} // namespace

std::optional<Vec3> ReliefPicture::pick(int x_px, int y_px, const ReliefProjection& projection) const {
    if (x_px < 0 || y_px < 0 || x_px >= width_px || y_px >= height_px)
        return std::nullopt;
    const float nearness = nearness_per_m[indexOf(x_px, y_px)];
    if (nearness <= 0.0f)
        return std::nullopt;
    return projection.unproject({x_px + 0.5, y_px + 0.5, double(nearness)});
}

bool ReliefPen::hasPlace(const Point& point_m) const {
    return allInside(point_m, guard_px / focal_px_);
}

DrawnCorner ReliefPen::placed(float right_m, float up_m, float forward_m) const {
    // Truncation rounds down only what is positive, so the numbers are shifted before and back after it.
    constexpr std::int32_t shift = 1 << 19;
    constexpr auto positive = static_cast<float>(shift);
    const float nearness = 1.0f / forward_m;
    const float x_px = middle_x_px_ + focal_px_ * right_m * nearness;
    const float y_px = middle_y_px_ - focal_px_ * up_m * nearness;
    // The center of the upper left pixel, which is at 0.5, is the grid's origin; half a step rounds.
    constexpr float offset = positive - 0.5f * static_cast<float>(per_px) + 0.5f;
    return {static_cast<std::int32_t>(x_px * static_cast<float>(per_px) + offset) - shift,
            static_cast<std::int32_t>(y_px * static_cast<float>(per_px) + offset) - shift, nearness};
}

template <class Wide>
void ReliefPen::fill(const DrawnCorner& a, const DrawnCorner& b, const DrawnCorner& c, std::uint32_t color) {
    // The grid's y goes down, so the corners that go around counterclockwise are a, c, b there.
    const Wide ac_x = Wide(c.x) - a.x, ac_y = Wide(c.y) - a.y;
    const Wide cb_x = Wide(b.x) - c.x, cb_y = Wide(b.y) - c.y;
    const Wide ba_x = Wide(a.x) - b.x, ba_y = Wide(a.y) - b.y;
    const Wide area = ac_y * ba_x - ac_x * ba_y;
    if (area <= 0)
        return;
    const int left = std::max((std::min({a.x, b.x, c.x}) + per_px - 1) >> 4, band_.first_px);
    const int right = std::min(std::max({a.x, b.x, c.x}) >> 4, band_.end_px - 1);
    const int top = std::max((std::min({a.y, b.y, c.y}) + per_px - 1) >> 4, 0);
    const int bottom = std::min(std::max({a.y, b.y, c.y}) >> 4, picture_.height_px - 1);
    if (left > right || top > bottom)
        return;
    const Wide x = Wide(left) * per_px, y = Wide(top) * per_px;
    // Each is twice the area between an edge and the pixel, and positive on the inner side.
    Wide ac_row = ac_x * (y - a.y) - ac_y * (x - a.x);
    Wide cb_row = cb_x * (y - c.y) - cb_y * (x - c.x);
    Wide ba_row = ba_x * (y - b.y) - ba_y * (x - b.x);
    const float by_area = 1.0f / static_cast<float>(area);
    const float to_c = (c.nearness_per_m - a.nearness_per_m) * by_area;
    const float to_b = (b.nearness_per_m - a.nearness_per_m) * by_area;
    for (int row = top; row <= bottom; ++row) {
        Wide ac = ac_row, cb = cb_row, ba = ba_row;
        const std::size_t line = picture_.indexOf(0, row);
        for (int column = left; column <= right; ++column) {
            if ((ac | cb | ba) >= 0) { // None has a sign.
                const float nearness = a.nearness_per_m + to_c * static_cast<float>(ba) + to_b * static_cast<float>(ac);
                const std::size_t pixel = line + static_cast<std::size_t>(column);
                if (nearness > picture_.nearness_per_m[pixel]) {
                    picture_.nearness_per_m[pixel] = nearness;
                    picture_.argb[pixel] = color;
                }
            }
            ac -= ac_y * per_px;
            cb -= cb_y * per_px;
            ba -= ba_y * per_px;
        }
        ac_row += ac_x * per_px;
        cb_row += cb_x * per_px;
        ba_row += ba_x * per_px;
    }
}

void ReliefPen::triangle(const DrawnCorner& a, const DrawnCorner& b, const DrawnCorner& c, std::uint32_t color) {
    constexpr std::int32_t narrow = 512 * per_px; // Products of smaller distances fit into 32 bits.
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    if (right - left < narrow && bottom - top < narrow)
        fill<std::int32_t>(a, b, c, color);
    else
        fill<std::int64_t>(a, b, c, color);
}

void ReliefPen::clippedTriangle(const std::array<Point, 3>& corners_m, std::uint32_t color, bool two_sided) {
    const float slope = guard_px / focal_px_;
    Polygon rest;
    for (const Point& corner : corners_m)
        rest.add(corner);
    if (!std::ranges::all_of(corners_m, [slope](const Point& corner) { return allInside(corner, slope); }))
        for (std::size_t plane = 0; plane < 5; ++plane)
            rest = clipped(rest, plane, slope);
    if (!std::all_of(rest.corners.begin(), rest.corners.begin() + static_cast<std::ptrdiff_t>(rest.count),
                     [slope](const Point& corner) { return almostInside(corner, slope); }))
        return;
    std::array<DrawnCorner, 8> drawn;
    for (std::size_t i = 0; i < rest.count; ++i)
        drawn[i] = placed(rest.corners[i].x(), rest.corners[i].y(), rest.corners[i].z());
    for (std::size_t i = 2; i < rest.count; ++i) {
        triangle(drawn[0], drawn[i - 1], drawn[i], color);
        if (two_sided)
            triangle(drawn[0], drawn[i], drawn[i - 1], color);
    }
}

void ReliefPen::dab(int x_px, int y_px, float nearness_per_m, std::uint32_t color, int width_px) {
    const int before = (width_px - 1) / 2;
    for (int y = std::max(y_px - before, 0); y < std::min(y_px - before + width_px, picture_.height_px); ++y)
        for (int x = std::max(x_px - before, band_.first_px); x < std::min(x_px - before + width_px, band_.end_px);
             ++x) {
            const std::size_t pixel = picture_.indexOf(x, y);
            if (nearness_per_m < picture_.nearness_per_m[pixel])
                continue;
            picture_.argb[pixel] = color;
            picture_.nearness_per_m[pixel] = nearness_per_m;
        }
}

std::optional<DrawnLine> ReliefPen::placedLine(Point from_m, Point to_m, int width_px) const {
    if (!withinReach(from_m) || !withinReach(to_m))
        return std::nullopt;
    // A line is cut at the picture's own edges, because each of its pixels costs time.
    const float slope_x = (middle_x_px_ + static_cast<float>(width_px)) / focal_px_;
    const float slope_y = (middle_y_px_ + static_cast<float>(width_px)) / focal_px_;
    const auto inside = [=](const Point& at, int plane) {
        switch (plane) {
        case 0:
            return at.z() - nearest_m;
        case 1:
            return slope_x * at.z() - at.x();
        case 2:
            return slope_x * at.z() + at.x();
        case 3:
            return slope_y * at.z() - at.y();
        default:
            return slope_y * at.z() + at.y();
        }
    };
    for (int plane = 0; plane < 5; ++plane) {
        const float in_from = inside(from_m, plane), in_to = inside(to_m, plane);
        if (!(in_from >= 0.0f) && !(in_to >= 0.0f)) // This is also true for NaN.
            return std::nullopt;
        if (in_from < 0.0f)
            from_m = cut(to_m, in_to, from_m, in_from);
        else if (in_to < 0.0f)
            to_m = cut(from_m, in_from, to_m, in_to);
    }
    const float guard = guard_px / focal_px_;
    if (!almostInside(from_m, guard) || !almostInside(to_m, guard))
        return std::nullopt;
    return DrawnLine{placed(from_m.x(), from_m.y(), from_m.z()), placed(to_m.x(), to_m.y(), to_m.z())};
}

void ReliefPen::line(const DrawnLine& piece, std::uint32_t color, int width_px, float how_near) {
    const DrawnCorner &from = piece.from, &to = piece.to;
    // A pixel more on each side makes up for rounding.
    const int left = (band_.first_px - width_px - 1) * per_px, right = (band_.end_px + width_px + 1) * per_px;
    if (std::max(from.x, to.x) < left || std::min(from.x, to.x) > right)
        return;
    const int steps = std::max({std::abs(to.x - from.x), std::abs(to.y - from.y), 1}) / per_px + 1;
    int first = 0, last = steps;
    if (from.x != to.x) {
        const double steps_per_x = double(steps) / double(to.x - from.x);
        const auto [enters, leaves] =
            std::minmax({double(left - from.x) * steps_per_x, double(right - from.x) * steps_per_x});
        first = static_cast<int>(std::clamp(std::floor(enters), 0.0, double(steps)));
        last = static_cast<int>(std::clamp(std::ceil(leaves), 0.0, double(steps)));
    }
    for (int step = first; step <= last; ++step) {
        const float part = static_cast<float>(step) / static_cast<float>(steps);
        const auto between = [part](float a, float b) { return a + (b - a) * part; };
        dab(static_cast<int>(std::lround(between(float(from.x), float(to.x)) / float(per_px))),
            static_cast<int>(std::lround(between(float(from.y), float(to.y)) / float(per_px))),
            how_near * between(from.nearness_per_m, to.nearness_per_m), color, width_px);
    }
}

} // namespace usar::mapping
