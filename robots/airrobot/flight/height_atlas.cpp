#include "robots/airrobot/flight/height_atlas.h"

#include <algorithm>
#include <cmath>

#include "robots/airrobot/flight/hidden_top.h"
#include "robots/airrobot/flight/moving_grid.h"

namespace usar::airrobot {

namespace {

constexpr double atlas_cell_m = 1.0;
constexpr double corridor_half_width_m = 1.5;
constexpr double past_half_width_m = 2.5;

int atlasCellOf(double coordinate_m) {
    return static_cast<int>(std::floor(coordinate_m / atlas_cell_m));
}

} // namespace

void HeightAtlas::take(const Senses& senses, double below_m) {
    if (!senses.scan)
        return;
    if (cells_.empty())
        cells_.resize(std::size_t(side) * side);
    for (const Vec3& hit : senses.scan->hits_in_map_m) {
        if (hit.z() >= below_m)
            continue;
        const int column = atlasCellOf(hit.x());
        const int row = atlasCellOf(hit.y());
        const auto top_m = static_cast<float>(hit.z());
        const bool goes_on = mayGoOn(hit.z(), senses.scan->scanner_in_map.position_m.z());
        Cell& cell = cells_[slotOf<side>(column, row)];
        if (cell.column != column || cell.row != row || cell.flight != flight_ || top_m > cell.top_m)
            cell = {column, row, top_m, goes_on, flight_};
        else if (!goes_on && showsTop(hit.z(), cell.top_m))
            cell.goes_on = false;
    }
}

template <class Visit>
void HeightAtlas::visitAlong(const Corridor& corridor, Visit&& visit) const {
    const Vec2 along(std::cos(corridor.bearing_rad), std::sin(corridor.bearing_rad));
    const double half_length_m = corridor.length_m / 2.0;
    const Vec2 middle_m = corridor.from_m + along * (corridor.start_m + half_length_m);
    const double reach_m = half_length_m + past_half_width_m;
    if (cells_.empty())
        return;
    for (int row = atlasCellOf(middle_m.y() - reach_m); row <= atlasCellOf(middle_m.y() + reach_m); ++row)
        for (int column = atlasCellOf(middle_m.x() - reach_m); column <= atlasCellOf(middle_m.x() + reach_m);
             ++column) {
            const Cell& cell = cells_[slotOf<side>(column, row)];
            const Vec2 offset_m = Vec2(column + 0.5, row + 0.5) * atlas_cell_m - middle_m;
            const double aside_m = std::abs(along.x() * offset_m.y() - along.y() * offset_m.x());
            const bool seen = cell.column == column && cell.row == row && cell.flight != 0;
            if (std::abs(offset_m.dot(along)) <= half_length_m)
                visit(seen ? &cell : nullptr, aside_m);
        }
}

std::optional<double> HeightAtlas::highest_m(const Corridor& corridor) const {
    std::optional<double> highest;
    visitAlong(corridor, [&](const Cell* cell, double aside_m) {
        if (!cell || aside_m > (cell->flight == flight_ ? corridor_half_width_m : past_half_width_m))
            return;
        const double top_m = static_cast<double>(cell->top_m) + (cell->goes_on ? hidden_top_m : 0.0);
        highest = std::max(highest.value_or(top_m), top_m);
    });
    return highest;
}

double HeightAtlas::seenShare(const Corridor& corridor) const {
    int all = 0;
    int seen = 0;
    visitAlong(corridor, [&](const Cell* cell, double aside_m) {
        all += aside_m <= corridor_half_width_m ? 1 : 0;
        seen += cell && aside_m <= corridor_half_width_m ? 1 : 0;
    });
    return all == 0 ? 0.0 : static_cast<double>(seen) / all;
}

} // namespace usar::airrobot
