#include "core/sim/world/free_space.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace usar::sim {

namespace {

constexpr double detour_m = 100.0; ///< the way to a part of the area may lead this far around it
/// The first search for ways leads this far around the area: it nearly always suffices, and costs a fraction.
constexpr double near_m = 10.0;
constexpr double lowest_m = 1.0; ///< least height over ground in flight
constexpr double half_height_m = 0.25;
constexpr double finest_m = 0.25;
constexpr double coarsest_m = 1.0; ///< a wall, widened by the body, must not fall between two columns
constexpr double most_columns = 4e6;
constexpr double largest_m2 = 1.6e7; ///< The air over a larger part of the world is not computed.
constexpr double endless_m = 1e9;

/// Square columns of air over a part of the world.
struct Columns {
    Vec2 low_m = Vec2::Zero();
    double step_m = finest_m;
    std::int32_t across = 0; ///< along x
    std::int32_t along = 0;  ///< along y

    static Columns over(const Rectangle& part_m) {
        const double step_m = std::clamp(std::sqrt(part_m.area_m2() / most_columns), finest_m, coarsest_m);
        return {part_m.min_m, step_m, static_cast<std::int32_t>(std::ceil(part_m.width_m() / step_m)),
                static_cast<std::int32_t>(std::ceil(part_m.height_m() / step_m))};
    }
    /// The columns over a part, which must be within these.
    Columns within(const Rectangle& part_m) const {
        const std::int32_t first_x = indexOn(0, part_m.min_m.x());
        const std::int32_t first_y = indexOn(1, part_m.min_m.y());
        return {low_m + step_m * Vec2(first_x, first_y), step_m, indexOn(0, part_m.max_m.x()) - first_x + 1,
                indexOn(1, part_m.max_m.y()) - first_y + 1};
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(across * along); }
    std::int32_t indexOn(int axis, double at_m) const {
        return std::clamp(static_cast<std::int32_t>(std::floor((at_m - low_m[axis]) / step_m)), 0,
                          (axis == 0 ? across : along) - 1);
    }
    std::uint32_t columnAt(const Vec2& point_m) const {
        return static_cast<std::uint32_t>(indexOn(1, point_m.y()) * across + indexOn(0, point_m.x()));
    }
    Vec2 center_m(std::int32_t x, std::int32_t y) const { return low_m + step_m * Vec2(x + 0.5, y + 0.5); }
};

/// A range of heights in a column, map frame.
struct Span {
    float low_m = 0.0f;
    float high_m = 0.0f;
    bool meets(const Span& other) const { return low_m <= other.high_m && other.low_m <= high_m; }
};

/// The heights at which a vertical line passes through the box; nullopt if it misses it.
std::optional<Span> crossing(const Eigen::Matrix3d& map_in_box, const Vec3& half_size_m, const Vec3& from_center_m) {
    const Vec3 origin_m = map_in_box * from_center_m;
    const Vec3 up = map_in_box.col(2);
    double low_m = -endless_m;
    double high_m = endless_m;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(up[axis]) < 1e-9) {
            if (std::abs(origin_m[axis]) > half_size_m[axis])
                return std::nullopt;
            continue;
        }
        const double one_m = (-half_size_m[axis] - origin_m[axis]) / up[axis];
        const double other_m = (half_size_m[axis] - origin_m[axis]) / up[axis];
        low_m = std::max(low_m, std::min(one_m, other_m));
        high_m = std::min(high_m, std::max(one_m, other_m));
    }
    if (low_m > high_m)
        return std::nullopt;
    return Span{static_cast<float>(low_m), static_cast<float>(high_m)};
}

/// A range of heights of one column that a box takes.
struct Taken {
    std::uint32_t column = 0;
    Span span;
};

/// Adds what the box takes of the columns if it is widened by `wider_m` to all sides and upward and downward by
/// `taller_m`, which is how the room for a body becomes the room for its center.
void take(const Box& box, const Columns& columns, double wider_m, double taller_m, std::vector<Taken>& taken) {
    const Eigen::Matrix3d box_in_map = box.center_in_map.rotation().toRotationMatrix();
    // The room is added along the axes of the box: for a box that stands upright, up and down are its own.
    const Vec3 up = box_in_map.row(2).cwiseAbs().transpose();
    const Vec3 half_size_m = box.size_m / 2.0 + Vec3::Constant(wider_m) + up * (taller_m - wider_m);
    const Vec3 reach_m = box_in_map.cwiseAbs() * half_size_m;
    const Vec3 center_m = box.center_in_map.position_m;
    const Vec2 far_m = columns.low_m + columns.step_m * Vec2(columns.across, columns.along);
    if (((center_m + reach_m).head<2>().array() < columns.low_m.array()).any() ||
        ((center_m - reach_m).head<2>().array() > far_m.array()).any())
        return;
    const Eigen::Matrix3d map_in_box = box_in_map.transpose();
    for (std::int32_t y = columns.indexOn(1, center_m.y() - reach_m.y());
         y <= columns.indexOn(1, center_m.y() + reach_m.y()); ++y)
        for (std::int32_t x = columns.indexOn(0, center_m.x() - reach_m.x());
             x <= columns.indexOn(0, center_m.x() + reach_m.x()); ++x) {
            const Vec2 at_m = columns.center_m(x, y);
            const Vec3 line_m(at_m.x() - center_m.x(), at_m.y() - center_m.y(), -center_m.z());
            if (const auto span = crossing(map_in_box, half_size_m, line_m))
                taken.push_back({columns.columnAt(at_m), *span});
        }
}

/// The free air of the columns: spans from below, column by column.
struct Air {
    std::vector<std::uint32_t> first; ///< index of the first span of each column, and one past the last
    std::vector<Span> spans;
    std::vector<bool> open; ///< by column: no box takes anything of it

    /// `whole`: for each column, the heights of the flight.
    Air(const std::vector<Span>& whole, std::vector<Taken> taken) {
        std::ranges::sort(taken, [](const Taken& a, const Taken& b) {
            return a.column != b.column ? a.column < b.column : a.span.low_m < b.span.low_m;
        });
        first.reserve(whole.size() + 1);
        spans.reserve(whole.size());
        open.reserve(whole.size());
        auto next = taken.begin();
        for (std::size_t column = 0; column < whole.size(); ++column) {
            first.push_back(static_cast<std::uint32_t>(spans.size()));
            float free_from_m = whole[column].low_m;
            bool is_open = true;
            for (; next != taken.end() && next->column == column; ++next) {
                if (!next->span.meets(whole[column]))
                    continue;
                is_open = false;
                if (next->span.low_m > free_from_m)
                    spans.push_back({free_from_m, next->span.low_m});
                free_from_m = std::max(free_from_m, next->span.high_m);
            }
            if (free_from_m < whole[column].high_m)
                spans.push_back({free_from_m, whole[column].high_m});
            open.push_back(is_open);
        }
        first.push_back(static_cast<std::uint32_t>(spans.size()));
    }
};

/// A span, and its column.
struct Place {
    std::uint32_t column = 0;
    std::uint32_t span = 0;
};

/// Marks the spans that can be reached from `seeds` in at most `steps` steps from column to column. Between columns
/// without boxes there is always a way: the robot follows the ground, however steep.
std::vector<bool> flood(const Air& air, const Columns& columns, std::vector<Place> seeds, int steps) {
    std::vector<bool> reached(air.spans.size());
    for (const Place& seed : seeds)
        reached[seed.span] = true;
    std::vector<Place> next;
    const auto spread = [&](const Place& from, std::uint32_t to) {
        for (std::uint32_t span = air.first[to]; span < air.first[to + 1]; ++span)
            if (!reached[span] &&
                ((air.open[from.column] && air.open[to]) || air.spans[span].meets(air.spans[from.span]))) {
                reached[span] = true;
                next.push_back({to, span});
            }
    };
    const auto across = static_cast<std::uint32_t>(columns.across);
    for (; !seeds.empty() && steps > 0; --steps) {
        next.clear();
        for (const Place& place : seeds) {
            const std::uint32_t x = place.column % across;
            if (x > 0)
                spread(place, place.column - 1);
            if (x + 1 < across)
                spread(place, place.column + 1);
            if (place.column >= across)
                spread(place, place.column - across);
            if (place.column + across < columns.count())
                spread(place, place.column + across);
        }
        std::swap(seeds, next);
    }
    return reached;
}

/// The air into which the robot takes off: at its start or, since that may be closer to a wall than the body is wide,
/// beside it. Empty if something solid is above the start before the height of the flight.
std::vector<Place> startIn(const Air& air, const Columns& columns, const FlightLimits& flight,
                           const std::vector<Span>& whole) {
    const auto start_z_m = static_cast<float>(flight.start_in_map_m.z());
    const Vec2 start_m = flight.start_in_map_m.head<2>();
    const double beside_m = flight.body_radius_m + columns.step_m;
    std::optional<Place> best;
    double best_m = std::numeric_limits<double>::infinity();
    for (std::int32_t y = columns.indexOn(1, start_m.y() - beside_m); y <= columns.indexOn(1, start_m.y() + beside_m);
         ++y)
        for (std::int32_t x = columns.indexOn(0, start_m.x() - beside_m);
             x <= columns.indexOn(0, start_m.x() + beside_m); ++x) {
            const Vec2 at_m = columns.center_m(x, y);
            const std::uint32_t column = columns.columnAt(at_m);
            std::uint32_t span = air.first[column];
            while (span < air.first[column + 1] && air.spans[span].high_m < start_z_m)
                ++span;
            if (span == air.first[column + 1] || (at_m - start_m).norm() >= best_m ||
                air.spans[span].low_m > std::max(start_z_m, whole[column].low_m))
                continue;
            best_m = (at_m - start_m).norm();
            best = Place{column, span};
        }
    return best ? std::vector<Place>{*best} : std::vector<Place>{};
}

/// The part of the world that is at most `detour` away from start and area.
Rectangle surroundings(const World& world, const FlightLimits& flight, const Rectangle& area_in_map, double detour) {
    const Vec2 start_m = flight.start_in_map_m.head<2>();
    const Vec2 around_m = Vec2::Constant(detour);
    const Rectangle extent = extentOf(world);
    return {(area_in_map.min_m.cwiseMin(start_m) - around_m).cwiseMax(extent.min_m),
            (area_in_map.max_m.cwiseMax(start_m) + around_m).cwiseMin(extent.max_m)};
}

/// The result of filling the air: it says which columns a flight reaches.
struct Filled {
    Rectangle extent;
    Columns columns;
    std::vector<bool> water;   ///< the ground is so deep under water that a flight at the scan altitude would get wet
    std::vector<bool> reached; ///< empty: all are
    bool has_start = true;     ///< there is air at the start

    /// Nothing in this part of the columns is shut off.
    bool reachesAll(const Rectangle& part_m) const {
        const Columns part = columns.within(part_m);
        for (std::int32_t y = 0; y < part.along && !reached.empty(); ++y)
            for (std::int32_t x = 0; x < part.across; ++x)
                if (!reached[columns.columnAt(part.center_m(x, y))])
                    return false;
        return true;
    }
    Reach at(const Vec2& point_m) const {
        if (!extent.contains(point_m))
            return Reach::OutsideWorld;
        const std::uint32_t column = columns.columnAt(point_m);
        if (!reached.empty() && !reached[column])
            return Reach::ShutOff;
        return water[column] ? Reach::OverWater : Reach::Scanned;
    }
};

/// The heights of the flight in each column, and which ones have deep water.
std::vector<Span> heightsOfFlight(const World& world, const FlightLimits& flight, const Columns& columns,
                                  std::vector<bool>& water) {
    const double level_m = world.water ? world.water->surface_z_m : -endless_m;
    const double floor_m = flight.start_in_map_m.z();
    std::vector<Span> whole;
    whole.reserve(columns.count());
    water.reserve(columns.count());
    for (std::int32_t y = 0; y < columns.along; ++y)
        for (std::int32_t x = 0; x < columns.across; ++x) {
            const double ground_m = world.terrain.empty() ? floor_m : world.terrain.height_m(columns.center_m(x, y));
            const double low_m = std::max(ground_m, level_m);
            water.push_back(level_m + lowest_m > ground_m + flight.scan_altitude_m);
            whole.push_back(
                {static_cast<float>(low_m + lowest_m),
                 static_cast<float>(low_m + std::max({flight.maximum_height_m, flight.scan_altitude_m, lowest_m}))});
        }
    return whole;
}

/// The spans of `to` that share heights with marked spans of `from`, and what is at most `steps` columns around them.
std::vector<bool> grow(const Air& from, const std::vector<bool>& marked, const Air& to, const Columns& columns,
                       int steps) {
    std::vector<Place> seeds;
    for (std::uint32_t column = 0; column < columns.count(); ++column)
        for (std::uint32_t span = to.first[column]; span < to.first[column + 1]; ++span)
            for (std::uint32_t other = from.first[column]; other < from.first[column + 1]; ++other)
                if (marked[other] && to.spans[span].meets(from.spans[other])) {
                    seeds.push_back({column, span});
                    break;
                }
    return flood(to, columns, std::move(seeds), steps);
}

/// Returns the parts of the columns that the boxes take if they are widened like this.
std::vector<Taken> takenBy(const std::vector<Box>& boxes, const Columns& columns, double wider_m, double taller_m) {
    std::vector<Taken> taken;
    for (const Box& box : boxes)
        take(box, columns, wider_m, taller_m, taken);
    return taken;
}

/// By column: the body gets there, or so near that nothing solid is in between. Empty: it gets nowhere. `taken`: by the
/// boxes, widened for the body.
std::vector<bool> reachedColumns(const World& world, const FlightLimits& flight, const Columns& columns,
                                 const std::vector<Span>& whole, std::vector<Taken> taken) {
    const auto airFor = [&](double wider_m, double taller_m) {
        return Air(whole, takenBy(world.boxes, columns, wider_m, taller_m));
    };
    Air air(whole, std::move(taken)); // At most two at a time, because they are large.
    std::vector<Place> start = startIn(air, columns, flight, whole);
    if (start.empty())
        return {};
    std::vector<bool> known = flood(air, columns, std::move(start), std::numeric_limits<int>::max());
    const auto growInto = [&](Air wider, int steps) {
        known = grow(air, known, wider, columns, steps);
        air = std::move(wider);
    };
    // The sight must not pass through thin walls, so they are widened until they take a closed row of columns, also
    // where they run diagonally. A last step takes in the columns that only this widening took.
    const int into_corners = static_cast<int>(std::ceil(2.0 * flight.body_radius_m / columns.step_m)) + 1;
    growInto(airFor(0.75 * columns.step_m, 0.0), into_corners);
    growInto(airFor(0.0, 0.0), 1);
    std::vector<bool> reached(columns.count());
    for (std::uint32_t column = 0; column < columns.count(); ++column)
        for (std::uint32_t span = air.first[column]; span < air.first[column + 1]; ++span)
            reached[column] = reached[column] || known[span];
    return reached;
}

Filled fill(const World& world, const FlightLimits& flight, const Rectangle& part_m, const Columns& columns) {
    Filled filled{.extent = part_m, .columns = columns, .water = {}, .reached = {}};
    const std::vector<Span> whole = heightsOfFlight(world, flight, columns, filled.water);
    std::vector<Taken> taken = takenBy(world.boxes, columns, flight.body_radius_m, half_height_m);
    if (!taken.empty()) { // Otherwise there is a way from each column to each other, as in a world without boxes.
        filled.reached = reachedColumns(world, flight, columns, whole, std::move(taken));
        filled.has_start = !filled.reached.empty();
    }
    return filled;
}

} // namespace

ReachMap reachFrom(const World& world, const FlightLimits& flight, const Rectangle& area_in_map) {
    const Rectangle part_m = surroundings(world, flight, area_in_map, detour_m);
    if (part_m.empty() || part_m.area_m2() > largest_m2 || !part_m.contains(Vec2(flight.start_in_map_m.head<2>())))
        return {};
    const Columns columns = Columns::over(part_m);
    const Rectangle near_part_m = surroundings(world, flight, area_in_map, near_m);
    auto filled = std::make_shared<Filled>(fill(world, flight, near_part_m, columns.within(near_part_m)));
    if (filled->has_start && !filled->reachesAll(area_in_map))
        *filled = fill(world, flight, part_m, columns);
    if (!filled->has_start)
        return {};
    return [filled = std::shared_ptr<const Filled>(std::move(filled))](const Vec2& point_m) {
        return filled->at(point_m);
    };
}

} // namespace usar::sim
