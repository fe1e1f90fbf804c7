// The heights that the belly scanner has seen, on this flight and on those before it.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// The obstacle memory ends with a flight, because places have drifted by then. What stood on a way still stands there,
/// within that drift, so a robot that flies there again can climb over it in time. Good for that only: nothing is
/// avoided for what this class knows. The scanner does not see what is higher than itself, so a top at its own height
/// is taken to go on above. A grid of 1 m that moves along with the robot keeps the highest hit of each cell and the
/// last flight that saw it. Owned by one robot.
class HeightAtlas {
public:
    /// So much higher is what reached up to the scanner, as a rule: crowns of trees end there.
    static constexpr double hidden_top_m = 2.0;

    /// Adds the scan of a tick; hits above `below_m` (map z) are on a ceiling. What earlier flights saw of a cell is
    /// forgotten then.
    void take(const Senses& senses, double below_m);
    /// Makes past what was seen so far; call it when the pose estimate jumps.
    void endFlight() { ++flight_; }
    void clear() { cells_.clear(); }

    /// A corridor that begins `start_m` ahead of `from_m` along the bearing (map frame).
    struct Corridor {
        Vec2 from_m = Vec2::Zero();
        double bearing_rad = 0.0;
        double start_m = 0.0;
        double length_m = 1.0;
    };
    /// Returns the height (map z) of the highest thing in the corridor; nullopt if none is known there. What earlier
    /// flights saw may have drifted, so it counts farther to the sides.
    std::optional<double> highest_m(const Corridor& corridor) const;
    /// Returns the share of the corridor that was seen, on whichever flight, 0 to 1.
    double seenShare(const Corridor& corridor) const;

private:
    static constexpr int side = 512; ///< cells per side of the grid, which is 512 m

    struct Cell {
        int column = 0;
        int row = 0;
        float top_m = 0.0f;
        bool goes_on = false; ///< The top is hidden, because it was as high as the scanner.
        int flight = 0;       ///< the last one that saw it; 0: none
    };
    /// Calls `visit(cell, aside_m)` for each cell with its center along the corridor and so near to its middle that it
    /// may be in it; `cell` is nullptr if it was never seen.
    template <class Visit>
    void visitAlong(const Corridor& corridor, Visit&& visit) const;

    std::vector<Cell> cells_; ///< empty before the first scan
    int flight_ = 1;
};

} // namespace usar::airrobot
