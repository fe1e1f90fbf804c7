#include "core/mapping/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

constexpr double most_contours = 20.0;
constexpr double least_interval_m = 0.01;
constexpr int point_decimals = 4;
constexpr int height_decimals = 2; ///< as many as the least interval has

/// A square has its corners at the centers of four cells; (column, row) is that of its upper left corner.
struct Square {
    std::int64_t column = 0;
    std::int64_t row = 0;
};

/// Sides of a square, clockwise from the top. Opposite ones differ by 2.
enum Side : int { Top = 0, Right = 1, Bottom = 2, Left = 3, None = 4 };

/// A line enters a square through one side and leaves it through another.
struct Segment {
    Side from = None;
    Side to = None;
};

/// Follows the contours of one height.
class Tracer {
public:
    Tracer(const Raster& raster, double height_m)
        : raster_(raster)
        , height_m_(height_m)
        , seen_(raster.heights_m.size(), 0) {}

    std::vector<ContourLine> lines() {
        std::vector<ContourLine> lines;
        for (std::int64_t row = 0; row + 1 < raster_.rows; ++row)
            for (std::int64_t column = 0; column + 1 < raster_.columns; ++column)
                for (const Segment& segment : segmentsIn({column, row}))
                    if (segment.from != None && !seen({column, row}, segment))
                        if (ContourLine line = lineThrough({column, row}, segment); line.points_m.size() > 1)
                            lines.push_back(std::move(line));
        return lines;
    }

private:
    double heightAt(std::int64_t column, std::int64_t row) const {
        return double(raster_.heights_m[static_cast<std::size_t>(row * raster_.columns + column)]);
    }

    /// Corners clockwise from the upper left one, so that side i is between the corners i and i + 1.
    std::array<double, 4> corners(const Square& square) const {
        const auto& [column, row] = square;
        return {heightAt(column, row), heightAt(column + 1, row), heightAt(column + 1, row + 1),
                heightAt(column, row + 1)};
    }

    bool inRaster(const Square& square) const {
        return square.column >= 0 && square.row >= 0 && square.column + 1 < raster_.columns &&
               square.row + 1 < raster_.rows;
    }

    /// At most two; those that are not there have no sides. A corner at exactly the height counts as above.
    std::array<Segment, 2> segmentsIn(const Square& square) const {
        const std::array<double, 4> heights_m = corners(square);
        std::array<Side, 4> crossed{None, None, None, None};
        std::size_t count = 0;
        for (int side = 0; side < 4; ++side)
            if (above(heights_m[std::size_t(side)]) != above(heights_m[std::size_t(side + 1) % 4]))
                crossed[count++] = Side(side);
        const double sum_m = heights_m[0] + heights_m[1] + heights_m[2] + heights_m[3];
        if (count == 0 || std::isnan(sum_m))
            return {};
        if (count == 2)
            return {Segment{crossed[0], crossed[1]}, Segment{}};
        // A saddle: the middle joins either the corners 0 and 2 or the others, and the lines cut off the rest.
        if (above(heights_m[0]) == above(sum_m / 4.0))
            return {Segment{Top, Right}, Segment{Bottom, Left}};
        return {Segment{Left, Top}, Segment{Right, Bottom}};
    }

    bool above(double height_m) const { return height_m >= height_m_; }

    /// A bit for each side by which a segment of the square is known.
    std::uint8_t& marksOf(const Square& square) {
        return seen_[static_cast<std::size_t>(square.row * raster_.columns + square.column)];
    }
    bool seen(const Square& square, const Segment& segment) { return marksOf(square) >> segment.from & 1; }

    Vec2 crossing(const Square& square, Side side) const {
        static constexpr std::array<std::pair<int, int>, 4> places{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
        const std::array<double, 4> heights_m = corners(square);
        auto low = std::size_t(side), high = std::size_t(side + 1) % 4;
        if (heights_m[low] > heights_m[high]) // So that both squares at this side find the very same point.
            std::swap(low, high);
        const auto placeOf = [&](std::size_t corner) {
            return Vec2(double(square.column + places[corner].first), -double(square.row + places[corner].second));
        };
        const double part = (height_m_ - heights_m[low]) / (heights_m[high] - heights_m[low]);
        const Vec2 place = placeOf(low) + part * (placeOf(high) - placeOf(low));
        return raster_.upper_left_center_m + place * raster_.cell_size_m;
    }

    static Square beyond(const Square& square, Side side) {
        static constexpr std::array<std::pair<int, int>, 4> steps{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
        return {square.column + steps[side].first, square.row + steps[side].second};
    }

    /// The segment of a square that enters or leaves through this side, turned so that it enters there.
    std::optional<Segment> segmentThrough(const Square& square, Side side) const {
        for (const Segment& segment : segmentsIn(square)) {
            if (segment.from == side)
                return segment;
            if (segment.to == side)
                return Segment{segment.to, segment.from};
        }
        return std::nullopt;
    }

    /// Adds what comes after leaving `square` through `side`; true if it comes back to where it began.
    bool follow(Square square, Side side, std::vector<Vec2>& points_m) {
        for (;;) {
            square = beyond(square, side);
            if (!inRaster(square))
                return false;
            const auto segment = segmentThrough(square, Side((side + 2) % 4));
            if (!segment)
                return false; // A corner is unknown.
            if (seen(square, *segment))
                return true;
            mark(square, *segment);
            side = segment->to;
            add(crossing(square, side), points_m);
        }
    }

    void mark(const Square& square, const Segment& segment) {
        marksOf(square) |= std::uint8_t(1 << segment.from | 1 << segment.to);
    }

    static void add(const Vec2& point_m, std::vector<Vec2>& points_m) {
        if (points_m.empty() || points_m.back() != point_m)
            points_m.push_back(point_m);
    }

    ContourLine lineThrough(const Square& square, const Segment& segment) {
        ContourLine line{height_m_, {}};
        mark(square, segment);
        add(crossing(square, segment.from), line.points_m);
        add(crossing(square, segment.to), line.points_m);
        if (follow(square, segment.to, line.points_m))
            return line;
        std::vector<Vec2> before_m{line.points_m.front()};
        follow(square, segment.from, before_m);
        line.points_m.insert(line.points_m.begin(), before_m.rbegin(), before_m.rend() - 1);
        return line;
    }

    const Raster& raster_;
    const double height_m_;
    std::vector<std::uint8_t> seen_; ///< by square
};

std::string featureOf(const ContourLine& line) {
    // With decimals even where there are none, so that every reader takes it for a real number.
    std::string text = R"({"type":"Feature","properties":{"elevation_m":)" + fixed(line.height_m, height_decimals) +
                       R"(},"geometry":{"type":"LineString","coordinates":[)";
    for (const Vec2& point_m : line.points_m)
        text += '[' + fixed(point_m.x(), point_decimals) + ',' + fixed(point_m.y(), point_decimals) + "],";
    text.back() = ']';
    return text + "}}";
}

} // namespace

std::vector<ContourLine> contoursAt(const Raster& raster, double height_m) {
    return Tracer(raster, height_m).lines();
}

std::optional<double> contourInterval_m(const Raster& raster) {
    const auto range = raster.range();
    if (!range)
        return std::nullopt;
    const double least_m = std::max((double(range->maximum_m) - double(range->minimum_m)) / most_contours, 1e-9);
    const double power_m = std::pow(10.0, std::floor(std::log10(least_m)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power_m >= least_m)
            return std::max(step * power_m, least_interval_m);
    return std::max(10.0 * power_m, least_interval_m);
}

bool writeContours(const Raster& raster, const ByteSink& sink) {
    const auto send = [&sink](const std::string& text) { return sink(text.data(), text.size()); };
    const auto range = raster.range();
    const double interval_m = contourInterval_m(raster).value_or(1.0);
    // Without a coordinate system the coordinates would count as degrees. GDAL and what is built on it reads this one.
    if (!send(R"({"type":"FeatureCollection","name":"contours","crs":{"type":"name","properties":{"name":)"
              R"("LOCAL_CS[\"map frame\",UNIT[\"metre\",1]]"}},"interval_m":)" +
              shortest(interval_m) + ",\"features\":["))
        return false;
    std::string between = "\n";
    const double lowest_m = range ? double(range->minimum_m) : 0.0, highest_m = range ? double(range->maximum_m) : 0.0;
    for (double number = std::floor(lowest_m / interval_m) + 1.0; number * interval_m < highest_m; ++number)
        for (const ContourLine& line : contoursAt(raster, number * interval_m))
            if (!send(std::exchange(between, ",\n") + featureOf(line)))
                return false;
    return send("\n]}\n");
}

} // namespace usar::mapping
