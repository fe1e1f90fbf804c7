// What the scans of a survey have shown of its area, so that a survey whose map has gaps does not call itself done.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// Keeps a coarse picture of the area: the cells of 1 m that scans for the map hit, and those above which they looked
/// so far down without an echo that no ground is within reach. It counts the scans on the lanes as well. Works in the
/// robot's own estimate of the map frame. Owned by one behavior.
class ScanLedger {
public:
    ScanLedger() = default;
    explicit ScanLedger(const Rectangle& area_in_map);

    /// Takes a tick; call it once per tick. `for_map`: the tick's scan is good enough for the map.
    void note(const Senses& senses, bool on_lane, bool for_map);

    /// The share of the time on the lanes in which the map got scans that show ground, 0 to 1; 1 before there was any.
    double mapped() const;
    /// The share of the area's cells that were hit, and of those without ground within reach, 0 to 1.
    double seen() const { return share(Cell::Seen); }
    double bottomless() const { return share(Cell::Bottomless); }
    /// The share of the seen cells that no scan has hit, in quarters, 0 to 1: crowns hide parts of them, and a map that
    /// is finer has holes there. Cells beside a void do not count, because the edge of the ground may divide them.
    double hiddenInSeen() const;

    /// The area of the rectangle (map frame) in square meters, without cells of which nothing is within reach, and how
    /// much of that no scan has hit. The area of those cells is told apart: from high up, there may be ground in them.
    struct Hidden {
        double area_m2 = 0.0;
        double hidden_m2 = 0.0;
        double bottomless_m2 = 0.0;
    };
    Hidden hiddenIn(const Rectangle& part_in_map) const;

    enum class Cell : std::uint8_t { Unknown, Bottomless, Seen };
    static constexpr double cell_m = 1.0;    ///< size of a cell
    int columns() const { return columns_; } ///< 0 if the area is too large to be watched
    int rows() const { return rows_; }
    /// The cell must be in the area.
    Cell at(int column, int row) const;
    /// The share of the cell that no scan has hit, in quarters, 0 to 1. It is 1 where beams met nothing, too: from high
    /// up, they end above ground that is there. The cell must be in the area.
    double hidden(int column, int row) const;
    Vec2 centerOf_m(int column, int row) const { return area_in_map_.min_m + cell_m * Vec2(column + 0.5, row + 0.5); }
    /// True if a scan hit something in the cell of this place; false outside the area.
    bool isSeen(const Vec2& at_m) const;

private:
    std::size_t indexOf(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    /// The index of the cell of this place; nullopt outside the area.
    std::optional<std::size_t> cellAt(const Vec2& at_m) const;
    /// Adds these bits to the cell of this place.
    void mark(const Vec2& at_m, std::uint8_t bits);
    double share(Cell what) const;
    bool isVoid(int column, int row) const; ///< the whole cell is bottomless; false outside the area

    Rectangle area_in_map_;
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint8_t> cells_; ///< row by row: a bit for each quarter that was hit, and one for bottomless
    Seconds last_tick_{-1.0};         ///< time of the last one on a lane
    long long lane_ticks_ = 0;
    long long mapped_ticks_ = 0;
};

} // namespace usar::airrobot
