#include "robots/airrobot/flight/obstacle_memory.h"

#include <algorithm>
#include <cmath>

#include "robots/airrobot/flight/hidden_top.h"

namespace usar::airrobot {

namespace {

/// A cell is seen again if it was not seen for so long, and that is remembered for so long. A robot that hovers over
/// its base sees nothing again, and has drifted no less.
constexpr Seconds another_pass{20.0};
constexpr Seconds remembered{4.0};
constexpr Seconds believed{30.0};
constexpr Seconds believed_of_tops{180.0};
constexpr std::size_t few_cells = 40;
/// Not every scan that reaches a cell hits something narrow in it, which is so much higher than what is around it. A
/// look around takes so long.
constexpr double narrow_m = 0.2;
constexpr Seconds recent{6.0};
/// So many beams may pass through the thin tip of a crown without an echo.
constexpr int tips_hide = 4;
/// A mast is higher by this than the ground 1 m beside it. Wires that lead from there may be as high, and some of the
/// ground may be hidden.
constexpr double mast_m = 5.5;
constexpr int beside_mast = 2; ///< cells
constexpr int most_as_high = 4;
constexpr int least_known = 8;
/// If a beam leaves less than this of an echo's height, the echo is dropped.
constexpr double certain_m = 0.1;

Vec2 unit(double bearing_rad) {
    return {std::cos(bearing_rad), std::sin(bearing_rad)};
}

bool inCorridor(const Vec2& offset_m, const Vec2& along, double half_width_m, double length_m) {
    const double forward_m = offset_m.dot(along);
    const double sideways_m = along.x() * offset_m.y() - along.y() * offset_m.x();
    return forward_m >= 0.0 && forward_m <= length_m && std::abs(sideways_m) <= half_width_m;
}

} // namespace

ObstacleMemory::ObstacleMemory() : cells_(std::size_t(side) * side) {}

void ObstacleMemory::clear() {
    std::ranges::fill(cells_, Cell{});
    echoes_.clear();
    seen_again_.clear();
    risen_ = {Seconds(-1e9), 0.0};
}

void ObstacleMemory::keepFresh(Seconds fresh) {
    for (Cell& cell : cells_) {
        if (now_.count() - cell.last_s > fresh.count()) {
            cell = {};
        } else {
            cell.top_m = cell.last_m;
            cell.time_s = cell.last_s;
        }
    }
    std::erase_if(echoes_, [&](const Echo& echo) { return now_ - echo.time > fresh; });
}

void ObstacleMemory::take(const Senses& senses, const MemorySpans& spans) {
    spans_ = spans;
    now_ = senses.now;
    std::erase_if(echoes_, [&](const Echo& echo) { return now_ - echo.time > spans_.sonar; });
    std::erase_if(seen_again_, [&](const SeenAgain& again) { return now_ - again.time > remembered; });
    if (senses.scan)
        takeScan(senses.scan->hits_in_map_m, senses.scan->scanner_in_map.position_m.z());
    noteRise();
    for (const SonarEcho& echo : senses.sonars)
        takeEcho(echo);
}

void ObstacleMemory::takeScan(std::span<const Vec3> hits_m, double scanner_m) {
    for (const Vec3& hit : hits_m) {
        if (hit.z() >= spans_.below_m)
            continue;
        const int column = cellOf(hit.x());
        const int row = cellOf(hit.y());
        const float top_m = static_cast<float>(hit.z());
        const auto now_s = static_cast<float>(now_.count());
        Cell& cell = cells_[slotOf<side>(column, row)];
        if (!known(column, row))
            cell = {column, row, top_m, now_s, top_m, now_s, top_m, now_s, /*goes_on=*/false};
        if (now_s - cell.last_s > another_pass.count())
            seen_again_.push_back({now_, hit.z() - double(cell.last_m)});
        const bool goes_on = mayGoOn(hit.z(), scanner_m);
        if (top_m >= cell.top_m) {
            cell.top_m = top_m;
            cell.time_s = now_s;
            cell.goes_on = goes_on;
        } else if (!goes_on && showsTop(hit.z(), cell.top_m)) {
            cell.goes_on = false; // It was seen from above.
        }
        if (top_m >= cell.recent_m || now_s - cell.recent_s > recent.count()) {
            cell.recent_m = top_m;
            cell.recent_s = now_s;
        }
        cell.last_m = cell.last_s == now_s ? std::max(cell.last_m, top_m) : top_m;
        cell.last_s = now_s;
    }
}

void ObstacleMemory::noteRise() {
    if (seen_again_.size() < few_cells)
        return;
    const auto middle = seen_again_.begin() + static_cast<std::ptrdiff_t>(seen_again_.size() / 2);
    std::ranges::nth_element(seen_again_, middle, {}, &SeenAgain::risen_m);
    risen_ = {now_, middle->risen_m};
}

double ObstacleMemory::risenWithin_m(Seconds span) const {
    return now_ - risen_.time <= span && !spans_.in_room ? risen_.risen_m : 0.0;
}

double ObstacleMemory::risen_m() const {
    return risenWithin_m(believed);
}

void ObstacleMemory::takeEcho(const SonarEcho& echo) {
    const Vec2 ray_m = (echo.center_in_map_m - echo.origin_in_map_m).head<2>();
    const double range_m = std::max(0.01, ray_m.norm());
    // The beam has passed through older echoes. Only the middle of the cone counts, because its edge may have passed
    // the obstacle on either side; and nearer to the sonar the cone is lower, so that an obstacle may still be below
    // it.
    const double slope = (echo.low_m - echo.origin_in_map_m.z()) / range_m;
    std::erase_if(echoes_, [&](Echo& old) {
        const Vec2 offset_m = old.at_m.head<2>() - echo.origin_in_map_m.head<2>();
        const double along_m = offset_m.dot(ray_m) / range_m;
        const double aside_m = (offset_m - ray_m / range_m * along_m).norm();
        if (along_m <= 0.0 || along_m >= range_m - 0.5 || aside_m >= 0.08 * along_m)
            return false;
        if (!spans_.lower_parts)
            return old.at_m.z() > echo.low_m;
        const double edge_m = echo.origin_in_map_m.z() + slope * along_m;
        if (edge_m >= old.at_m.z())
            return false; // All of it is below the beam.
        if (++old.passed < tips_hide)
            return false;
        old.at_m.z() = edge_m;
        return edge_m < old.low_m + certain_m;
    });
    // A sonar that leans looks below what is before it, which may reach as high as the robot all the same.
    const double top_m = std::max(echo.high_m, echo.origin_in_map_m.z());
    if (echo.hit)
        echoes_.push_back({Vec3(echo.center_in_map_m.x(), echo.center_in_map_m.y(), top_m), echo.low_m, now_});
}

const ObstacleMemory::Cell* ObstacleMemory::known(int column, int row) const {
    const Cell& cell = cells_[slotOf<side>(column, row)];
    const bool valid = cell.column == column && cell.row == row && now_.count() - cell.time_s <= spans_.scan.count();
    return valid ? &cell : nullptr;
}

/// A cell whose center lies on the circle to the last digit may count or not.
template <class Visit>
void ObstacleMemory::visitDisc(const Vec2& at_m, double radius_m, Visit&& visit) const {
    const int last_row = cellOf(at_m.y() + radius_m);
    const int last_column = cellOf(at_m.x() + radius_m);
    for (int row = cellOf(at_m.y() - radius_m); row <= last_row; ++row)
        for (int column = cellOf(at_m.x() - radius_m); column <= last_column; ++column)
            if (const Vec2 center_m = centerOf(column, row); (center_m - at_m).squaredNorm() <= radius_m * radius_m)
                visit(center_m, known(column, row));
}

std::vector<Obstacle> ObstacleMemory::near(const Vec2& at_m, double radius_m, double level_m) const {
    std::vector<Obstacle> found;
    visitDisc(at_m, radius_m, [&](const Vec2& center_m, const Cell* cell) {
        if (cell && cell->top_m > level_m)
            found.push_back({center_m, cell->top_m, true});
    });
    for (const Echo& echo : echoes_)
        if (echo.at_m.z() > level_m && (echo.at_m.head<2>() - at_m).norm() <= radius_m)
            found.push_back({echo.at_m.head<2>(), echo.at_m.z(), false});
    return found;
}

std::optional<double> ObstacleMemory::highest_m(const Vec2& at_m, double radius_m, double below_m) const {
    std::optional<double> highest;
    const auto raise = [&](double top_m) {
        if (top_m < below_m)
            highest = std::max(highest.value_or(top_m), top_m);
    };
    visitDisc(at_m, radius_m, [&](const Vec2&, const Cell* cell) {
        if (cell)
            raise(cell->top_m);
    });
    for (const Echo& echo : echoes_)
        if ((echo.at_m.head<2>() - at_m).norm() <= radius_m)
            raise(echo.at_m.z());
    return highest;
}

std::vector<Vec3> ObstacleMemory::tops_m(const Vec2& at_m, double radius_m) const {
    std::vector<Vec3> tops;
    visitDisc(at_m, radius_m, [&](const Vec2& center_m, const Cell* cell) {
        if (cell)
            tops.emplace_back(center_m.x(), center_m.y(), cell->top_m);
    });
    return tops;
}

std::vector<Vec3> ObstacleMemory::risenTops_m(const Vec2& at_m, double radius_m) const {
    const double risen_m = risenWithin_m(believed_of_tops);
    std::vector<Vec3> tops;
    visitDisc(at_m, radius_m, [&](const Vec2& center_m, const Cell* cell) {
        if (!cell)
            return;
        const bool old = now_.count() - cell->time_s > another_pass.count();
        tops.emplace_back(center_m.x(), center_m.y(), cell->top_m + (old ? risen_m : 0.0));
    });
    return tops;
}

std::vector<Vec3> ObstacleMemory::freshTops_m(const Vec2& at_m, double radius_m, Seconds fresh) const {
    std::vector<Vec3> tops;
    visitDisc(at_m, radius_m, [&](const Vec2& center_m, const Cell* cell) {
        if (cell && now_.count() - cell->last_s <= fresh.count())
            tops.emplace_back(center_m.x(), center_m.y(),
                              cell->recent_m > cell->last_m + narrow_m ? cell->recent_m : cell->last_m);
    });
    return tops;
}

bool ObstacleMemory::isMast(const Cell& cell) const {
    int seen = 0;
    int high = 0;
    for (int row = -beside_mast; row <= beside_mast; ++row)
        for (int column = -beside_mast; column <= beside_mast; ++column) {
            if (std::max(std::abs(row), std::abs(column)) < beside_mast)
                continue;
            const Cell* const beside = known(cell.column + column, cell.row + row);
            seen += beside ? 1 : 0;
            high += beside && beside->top_m > cell.top_m - mast_m ? 1 : 0;
        }
    return seen >= least_known && high <= most_as_high;
}

std::optional<double> ObstacleMemory::highestMast_m(const Vec2& at_m, double radius_m, double above_m,
                                                    double below_m) const {
    std::optional<double> highest;
    visitDisc(at_m, radius_m, [&](const Vec2&, const Cell* cell) {
        if (cell && cell->top_m > std::max(above_m, highest.value_or(above_m)) && cell->top_m < below_m &&
            isMast(*cell))
            highest = cell->top_m;
    });
    return highest;
}

std::optional<double> ObstacleMemory::lowest_m(const Vec2& at_m, double radius_m) const {
    std::optional<double> lowest;
    visitDisc(at_m, radius_m, [&](const Vec2&, const Cell* cell) {
        if (cell)
            lowest = std::min<double>(lowest.value_or(cell->top_m), cell->top_m);
    });
    return lowest;
}

std::optional<double> ObstacleMemory::highestAlong_m(const Vec2& from_m, double bearing_rad, double half_width_m,
                                                     double length_m) const {
    const Vec2 along = unit(bearing_rad);
    std::optional<double> highest;
    visitDisc(from_m + along * length_m / 2.0, length_m / 2.0 + half_width_m,
              [&](const Vec2& center_m, const Cell* cell) {
                  if (cell && inCorridor(center_m - from_m, along, half_width_m, length_m))
                      highest = std::max<double>(highest.value_or(cell->top_m), cell->top_m);
              });
    return highest;
}

double ObstacleMemory::knownAlong(const Vec2& from_m, double bearing_rad, double half_width_m, double length_m) const {
    const Vec2 along = unit(bearing_rad);
    int total = 0;
    int seen = 0;
    bool goes_on = false;
    visitDisc(from_m + along * length_m / 2.0, length_m / 2.0 + half_width_m,
              [&](const Vec2& center_m, const Cell* cell) {
                  if (!inCorridor(center_m - from_m, along, half_width_m, length_m))
                      return;
                  ++total;
                  seen += cell ? 1 : 0;
                  goes_on = goes_on || (cell && cell->goes_on);
              });
    return total == 0 || goes_on ? 0.0 : static_cast<double>(seen) / total;
}

double clearance_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double bearing_rad, double half_width_m,
                   double reach_m) {
    const Vec2 along = unit(bearing_rad);
    double free_m = reach_m;
    for (const Obstacle& obstacle : obstacles) {
        const Vec2 offset_m = obstacle.at_m - from_m;
        if (inCorridor(offset_m, along, half_width_m, free_m))
            free_m = std::min(free_m, offset_m.dot(along));
    }
    return free_m;
}

double nearest_m(std::span<const Obstacle> obstacles, const Vec2& from_m, double otherwise_m) {
    double nearest = otherwise_m;
    for (const Obstacle& obstacle : obstacles)
        nearest = std::min(nearest, (obstacle.at_m - from_m).norm());
    return nearest;
}

} // namespace usar::airrobot
