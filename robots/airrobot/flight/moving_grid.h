// The cells of a grid that moves along with the robot: it wraps around, so a cell is a new one after a whole side.
#pragma once

#include <cstddef>

#include "core/base/geometry.h"
#include "core/base/whole_number.h"

namespace usar::airrobot {

inline constexpr double grid_cell_m = 0.5;

inline int cellOf(double coordinate_m) {
    return static_cast<int>(wholeBelow(coordinate_m / grid_cell_m));
}

inline Vec2 centerOf(int column, int row) {
    return Vec2(column + 0.5, row + 0.5) * grid_cell_m;
}

/// Index of a cell in a grid of `side` x `side` cells.
template <int side>
std::size_t slotOf(int column, int row) {
    static_assert((side & (side - 1)) == 0, "wrapping needs a power of two");
    constexpr int mask = side - 1;
    return static_cast<std::size_t>(row & mask) * side + static_cast<std::size_t>(column & mask);
}

} // namespace usar::airrobot
