#include "robots/airrobot/flight/route_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace usar::airrobot {

namespace {

constexpr double clear_m = 1.5; ///< free space on each side of a way
constexpr double least_clear_m = 1.0;
/// With less space than this, sonars report risks, so such a way costs more.
constexpr double safe_m = 1.75;
constexpr double comfortable_m = 2.75;
constexpr double narrowest_cost = 16.0; ///< factors; this one keeps it in the middle of a door
constexpr double unsafe_cost = 8.0;
constexpr double narrow_cost = 3.0;
constexpr double surest_echo_m = 4.0;   ///< a sonar does not say from where in its cone a farther echo came
constexpr double lowest_known_m = -1e8; ///< Cells that nothing was seen of are lower.
constexpr int least_ground = 8;         ///< cells, which are 2 square meters
constexpr double no_room_m = 10.0;      ///< so much farther a place may be that has room around it
constexpr double passed_m = 0.7;
/// So near to its place, the robot may pass over what ends below its belly, because it is above it already.
constexpr double near_start_m = 3.0;
constexpr double belly_m = 0.4;
constexpr double hides_not_m = 0.75; ///< What stands so near to a place hides nothing of it.
constexpr double brushing_m = 0.75;  ///< free space there, where the robot may be near something already

constexpr int reach_cells = static_cast<int>(comfortable_m / grid_cell_m);
constexpr double no_way = std::numeric_limits<double>::infinity();

/// A cell near another one.
struct Neighbor {
    int columns = 0;
    int rows = 0;
    double away_m = 0.0;
};

/// The cells around one that matter, the nearest first.
const std::vector<Neighbor>& neighbors() {
    static const std::vector<Neighbor> all = [] {
        std::vector<Neighbor> found;
        for (int rows = -reach_cells; rows <= reach_cells; ++rows)
            for (int columns = -reach_cells; columns <= reach_cells; ++columns)
                if (const double away_m = std::hypot(columns, rows) * grid_cell_m; away_m <= comfortable_m)
                    found.push_back({columns, rows, away_m});
        std::ranges::sort(found, {}, &Neighbor::away_m);
        return found;
    }();
    return all;
}

/// Adds one. Both numbers of a pair are halved where one gets too large.
void addOne(std::uint8_t& one, std::uint8_t& other) {
    if (one == std::numeric_limits<std::uint8_t>::max()) {
        one /= 2;
        other /= 2;
    }
    ++one;
}

/// How dear a place is: `no_way` where the robot does not fit, 1 where nothing is within `matters_m`. `blocked` is
/// asked about cells.
template <class Blocked>
double costAt(const Blocked& blocked, int column, int row, double needed_m = clear_m,
              double matters_m = comfortable_m) {
    for (const Neighbor& neighbor : neighbors()) {
        if (neighbor.away_m > matters_m)
            break;
        if (!blocked(column + neighbor.columns, row + neighbor.rows))
            continue;
        return neighbor.away_m < needed_m  ? no_way
               : neighbor.away_m < clear_m ? narrowest_cost
               : neighbor.away_m < safe_m  ? unsafe_cost
                                           : narrow_cost;
    }
    return 1.0;
}

/// A* over the cells of a square around the start. Cells are counted from its corner.
template <class Blocked>
class Search {
public:
    /// `matters_m`: things that are farther away cost nothing.
    Search(const Blocked& blocked, const Vec2& from_m, const Vec2& goal_m, double within_m, double needed_m = clear_m,
           double matters_m = comfortable_m)
        : blocked_(blocked)
        , needed_m_(needed_m)
        , matters_m_(matters_m)
        , corner_column_(cellOf(from_m.x()) - half)
        , corner_row_(cellOf(from_m.y()) - half)
        , from_m_(from_m)
        , goal_m_(goal_m)
        , within_m_(within_m)
        , visits_(std::size_t(RouteMap::side) * RouteMap::side) {}

    /// nullopt if there is no way.
    std::optional<std::vector<Vec2>> run() {
        const std::uint32_t start = numberOf(half, half);
        visits_[start].cost = 0.0;
        open_.push({beeline(half, half), start});
        while (!open_.empty()) {
            const std::uint32_t number = open_.top().number;
            open_.pop();
            if (std::exchange(visits_[number].closed, true))
                continue;
            const int column = columnOf(number);
            const int row = rowOf(number);
            if (beeline(column, row) * grid_cell_m <= within_m_)
                return wayTo(number, start);
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (isInside(column + dx) && isInside(row + dy))
                        visit(number, column + dx, row + dy, std::hypot(dx, dy));
        }
        return std::nullopt;
    }

private:
    static constexpr int half = RouteMap::side / 2;

    struct Open {
        double estimate = 0.0; ///< cost so far and the beeline
        std::uint32_t number = 0;
        bool operator<(const Open& other) const { return estimate > other.estimate; }
    };
    struct Visit {
        double cost = no_way; ///< of the best way there
        double here = -1.0;   ///< costAt(), negative before it was asked for
        std::uint32_t from = 0;
        bool closed = false;
    };

    static std::uint32_t numberOf(int column, int row) {
        return static_cast<std::uint32_t>(row) * RouteMap::side + static_cast<std::uint32_t>(column);
    }
    static int columnOf(std::uint32_t number) { return static_cast<int>(number) % RouteMap::side; }
    static int rowOf(std::uint32_t number) { return static_cast<int>(number) / RouteMap::side; }
    static bool isInside(int at) { return at >= 0 && at < RouteMap::side; }
    Vec2 placeOf_m(int column, int row) const { return centerOf(corner_column_ + column, corner_row_ + row); }
    double beeline(int column, int row) const { return (placeOf_m(column, row) - goal_m_).norm() / grid_cell_m; }

    double costOf(int column, int row) const {
        const double cost = costAt(blocked_, corner_column_ + column, corner_row_ + row, needed_m_, matters_m_);
        const bool leaves = (placeOf_m(column, row) - from_m_).norm() < near_start_m;
        return leaves && !blocked_(corner_column_ + column, corner_row_ + row, belly_m) ? std::min(cost, narrow_cost)
                                                                                        : cost;
    }

    void visit(std::uint32_t from, int column, int row, double length) {
        const std::uint32_t number = numberOf(column, row);
        Visit& next = visits_[number];
        if (next.closed)
            return;
        if (next.here < 0.0)
            next.here = costOf(column, row);
        const double cost = visits_[from].cost + next.here * length;
        if (cost >= next.cost)
            return;
        next.cost = cost;
        next.from = from;
        open_.push({cost + beeline(column, row), number});
    }

    std::vector<Vec2> wayTo(std::uint32_t end, std::uint32_t start) const {
        std::vector<Vec2> way;
        for (std::uint32_t number = end; number != start; number = visits_[number].from)
            way.push_back(placeOf_m(columnOf(number), rowOf(number)));
        std::ranges::reverse(way);
        return way;
    }

    const Blocked& blocked_;
    double needed_m_; ///< free space on each side
    double matters_m_;
    int corner_column_;
    int corner_row_;
    Vec2 from_m_;
    Vec2 goal_m_;
    double within_m_;
    std::vector<Visit> visits_;
    std::priority_queue<Open> open_;
};

} // namespace

bool ReachablePlaces::knows(const Vec2& at_m) const {
    const int column = cellOf(at_m.x()) - column_;
    const int row = cellOf(at_m.y()) - row_;
    return !inside_.empty() && column >= 0 && row >= 0 && column < RouteMap::side && row < RouteMap::side;
}

bool ReachablePlaces::leadsNear(const Vec2& at_m, double within_m) const {
    for (double x_m = -within_m; x_m <= within_m; x_m += grid_cell_m)
        for (double y_m = -within_m; y_m <= within_m; y_m += grid_cell_m)
            if (std::hypot(x_m, y_m) <= within_m && contains(at_m + Vec2(x_m, y_m)))
                return true;
    return false;
}

bool ReachablePlaces::contains(const Vec2& at_m) const {
    if (!knows(at_m))
        return true;
    const int column = cellOf(at_m.x()) - column_;
    const int row = cellOf(at_m.y()) - row_;
    return inside_[static_cast<std::size_t>(row) * RouteMap::side + static_cast<std::size_t>(column)];
}

RouteMap::RouteMap() : cells_(std::size_t(side) * side) {}

void RouteMap::clear() {
    std::ranges::fill(cells_, Cell{});
}

RouteMap::Cell& RouteMap::at(int column, int row) {
    Cell& cell = cells_[slotOf<side>(column, row)];
    if (cell.column != column || cell.row != row)
        cell = {static_cast<std::int16_t>(column), static_cast<std::int16_t>(row)};
    return cell;
}

auto RouteMap::blockedAt(double z_m) const {
    return [this, z_m](int column, int row, std::optional<double> below_m = {}) {
        return blocked(column, row, z_m - below_m.value_or(passes_below_m_));
    };
}

bool RouteMap::blocked(int column, int row, double level_m) const {
    const Cell& cell = cells_[slotOf<side>(column, row)];
    return cell.column == column && cell.row == row && cell.height_m() > level_m;
}

void RouteMap::take(const Senses& senses, double below_m) {
    const Vec2 here_m = senses.position2_m();
    for (int row = cellOf(here_m.y() - brushing_m); row <= cellOf(here_m.y() + brushing_m); ++row)
        for (int column = cellOf(here_m.x() - brushing_m); column <= cellOf(here_m.x() + brushing_m); ++column)
            at(column, row).flown = true;
    if (senses.scan)
        takeScan(*senses.scan, below_m);
    for (const SonarEcho& echo : senses.sonars)
        takeEcho(echo);
}

void RouteMap::takeScan(const PlacedScan& scan, double below_m) {
    for (const Vec3& hit : scan.hits_in_map_m)
        if (hit.z() < below_m) {
            Cell& cell = at(cellOf(hit.x()), cellOf(hit.y()));
            cell.top_m = std::max(cell.top_m, static_cast<float>(hit.z()));
            cell.passed = 0; // The robot is at this height now, and near.
        }
}

void RouteMap::takeBand(const PlacedScan& scan, const HeightBand& band) {
    const Vec3& from_m = scan.scanner_in_map.position_m;
    for (const Vec3& hit : scan.hits_in_map_m) {
        passThrough(from_m, hit, band);
        if (hit.z() > band.high_m)
            continue;
        Cell& cell = at(cellOf(hit.x()), cellOf(hit.y()));
        cell.top_m = std::max(cell.top_m, static_cast<float>(hit.z()));
        if (hit.z() > band.low_m)
            addOne(cell.ended, cell.passed);
    }
    for (const Vec3& end : scan.misses_in_map_m)
        passThrough(from_m, end, band);
}

void RouteMap::passThrough(const Vec3& from_m, const Vec3& to_m, const HeightBand& band) {
    const Vec3 beam_m = to_m - from_m;
    const double fall_m = -beam_m.z();
    if (fall_m <= 0.0 || from_m.z() < band.high_m || to_m.z() > band.high_m)
        return;
    const double length_m = beam_m.head<2>().norm();
    const double first = (from_m.z() - band.high_m) / fall_m;
    const double last =
        std::min((from_m.z() - band.low_m) / fall_m, 1.0 - grid_cell_m / std::max(grid_cell_m, length_m));
    const double step = grid_cell_m / std::max(grid_cell_m, length_m);
    for (double share = first; share <= last; share += step) {
        const Vec3 at_m = from_m + share * beam_m;
        Cell& cell = at(cellOf(at_m.x()), cellOf(at_m.y()));
        addOne(cell.passed, cell.ended);
    }
}

void RouteMap::takeEcho(const SonarEcho& echo) {
    const Vec2 from_m = echo.origin_in_map_m.head<2>();
    const Vec2 ray_m = echo.center_in_map_m.head<2>() - from_m;
    const double range_m = std::max(0.01, ray_m.norm());
    if (!echo.hit)
        return; // A smooth wall that is met at a flat angle gives no echo, so this says nothing.
    for (double along_m = 0.5; along_m < range_m - passed_m; along_m += grid_cell_m / 2.0) {
        const Vec2 passed = from_m + ray_m * (along_m / range_m);
        at(cellOf(passed.x()), cellOf(passed.y())).echo_m = -1e9f;
    }
    const Vec3& center_m = echo.center_in_map_m;
    if (range_m < surest_echo_m)
        at(cellOf(center_m.x()), cellOf(center_m.y())).echo_m = static_cast<float>(center_m.z());
}

void RouteMap::block(const Vec2& at_m, double z_m) {
    Cell& cell = at(cellOf(at_m.x()), cellOf(at_m.y()));
    cell.top_m = static_cast<float>(z_m);
    cell.passed = 0;
}

bool RouteMap::wasFlown(const Vec2& at_m) const {
    const int column = cellOf(at_m.x());
    const int row = cellOf(at_m.y());
    const Cell& cell = cells_[slotOf<side>(column, row)];
    return cell.column == column && cell.row == row && cell.flown;
}

bool RouteMap::isStraightWayFree(const Vec2& from_m, const Vec2& to_m, double z_m) const {
    const auto is_blocked = blockedAt(z_m);
    const Vec2 way_m = to_m - from_m;
    const double length_m = way_m.norm();
    for (double along_m = 0.0; along_m <= length_m; along_m += grid_cell_m) {
        const Vec2 at_m = from_m + way_m * (length_m > 0.0 ? along_m / length_m : 0.0);
        const double needed_m = along_m < near_start_m ? brushing_m : clear_m;
        if (std::isinf(costAt(is_blocked, cellOf(at_m.x()), cellOf(at_m.y()), needed_m)))
            return false;
    }
    return true;
}

bool RouteMap::isInSight(const Vec2& from_m, const Vec2& to_m, double z_m) const {
    const Vec2 way_m = to_m - from_m;
    const double length_m = way_m.norm();
    for (double along_m = 0.0; along_m < length_m - hides_not_m; along_m += grid_cell_m / 2.0) {
        const Vec2 at_m = from_m + way_m * (along_m / length_m);
        if (blocked(cellOf(at_m.x()), cellOf(at_m.y()), z_m))
            return false;
    }
    return true;
}

std::optional<std::vector<Vec2>> RouteMap::route(const Vec2& from_m, const Vec2& to_m, double z_m, double within_m,
                                                 Width width) const {
    const auto is_blocked = blockedAt(z_m);
    const Vec2 reach_m = Vec2::Constant((side / 2 - reach_cells - 2) * grid_cell_m);
    const Vec2 goal_m = to_m.cwiseMax(from_m - reach_m).cwiseMin(from_m + reach_m);
    const double needed_m = width == Width::Least ? least_clear_m : clear_m;
    return Search(is_blocked, from_m, goal_m, std::max(within_m, grid_cell_m), needed_m).run();
}

std::vector<bool> RouteMap::closedAround(const Vec2& from_m, double z_m, double needed_m) const {
    const int first_column = cellOf(from_m.x()) - side / 2;
    const int first_row = cellOf(from_m.y()) - side / 2;
    std::vector<bool> closed(cells_.size());
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row - first_row) * side + static_cast<std::size_t>(column - first_column);
    };
    const auto isInside = [&](int column, int row) {
        return column >= first_column && row >= first_row && column < first_column + side && row < first_row + side;
    };
    for (const Cell& cell : cells_) {
        if (cell.height_m() <= z_m - passes_below_m_)
            continue;
        for (int dy = -reach_cells; dy <= reach_cells; ++dy)
            for (int dx = -reach_cells; dx <= reach_cells; ++dx)
                if (std::hypot(dx, dy) * grid_cell_m < needed_m && isInside(cell.column + dx, cell.row + dy))
                    closed[at(cell.column + dx, cell.row + dy)] = true;
    }
    const auto near_cells = static_cast<int>(near_start_m / grid_cell_m) + 1;
    for (int row = cellOf(from_m.y()) - near_cells; row <= cellOf(from_m.y()) + near_cells; ++row)
        for (int column = cellOf(from_m.x()) - near_cells; column <= cellOf(from_m.x()) + near_cells; ++column)
            if ((centerOf(column, row) - from_m).norm() < near_start_m && !blocked(column, row, z_m - belly_m))
                closed[at(column, row)] = false;
    return closed;
}

ReachablePlaces RouteMap::reach(const Vec2& from_m, double z_m, Width width) const {
    const std::vector<bool> closed = closedAround(from_m, z_m, width == Width::Least ? least_clear_m : clear_m);
    std::vector<bool> inside(closed.size());
    std::vector<std::size_t> open{std::size_t(side / 2) * side + side / 2};
    inside[open.front()] = true;
    while (!open.empty()) {
        const auto column = static_cast<int>(open.back() % side);
        const auto row = static_cast<int>(open.back() / side);
        open.pop_back();
        for (int y = std::max(0, row - 1); y <= std::min(side - 1, row + 1); ++y)
            for (int x = std::max(0, column - 1); x <= std::min(side - 1, column + 1); ++x) {
                const std::size_t next = static_cast<std::size_t>(y) * side + static_cast<std::size_t>(x);
                if (closed[next] || inside[next])
                    continue;
                inside[next] = true;
                open.push_back(next);
            }
    }
    return {cellOf(from_m.x()) - side / 2, cellOf(from_m.y()) - side / 2, std::move(inside)};
}

bool RouteMap::hasRoom(const Vec2& at_m, double z_m, double radius_m) const {
    return !std::isinf(costAt(blockedAt(z_m), cellOf(at_m.x()), cellOf(at_m.y()), radius_m, radius_m));
}

bool RouteMap::isOpenGround(const Vec2& at_m, double radius_m, double floor_m) const {
    const auto is_no_ground = [&](int column, int row) {
        const Cell& cell = cells_[slotOf<side>(column, row)];
        return cell.column != column || cell.row != row || cell.top_m < lowest_known_m || cell.height_m() > floor_m;
    };
    return !std::isinf(costAt(is_no_ground, cellOf(at_m.x()), cellOf(at_m.y()), radius_m, radius_m));
}

std::optional<Vec2> RouteMap::groundBeyond_m(const Vec2& from_m, double z_m, double floor_m,
                                             const ReachablePlaces& other, double beyond_m) const {
    const ReachablePlaces here = reach(from_m, z_m, Width::Least);
    std::optional<Vec2> nearest;
    const auto costTo = [&](const Vec2& at_m) {
        return (at_m - from_m).norm() + (hasRoom(at_m, z_m, clear_m) ? 0.0 : no_room_m);
    };
    int count = 0;
    for (const Cell& cell : cells_) {
        const Vec2 at_m = centerOf(cell.column, cell.row);
        if (cell.top_m < lowest_known_m || cell.top_m > floor_m || !here.knows(at_m) || !here.contains(at_m) ||
            other.leadsNear(at_m, beyond_m))
            continue;
        ++count;
        if (!nearest || costTo(at_m) < costTo(*nearest))
            nearest = at_m;
    }
    return count >= least_ground ? nearest : std::nullopt;
}

} // namespace usar::airrobot
