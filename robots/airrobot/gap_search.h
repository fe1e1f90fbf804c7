// Finds what the lanes of a survey have not shown of its area although the robot can get to it.
#pragma once

#include <functional>
#include <vector>

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/flight/route_map.h"
#include "robots/airrobot/scan_ledger.h"

namespace usar::airrobot {

/// Lanes are straight and as far apart as the scanner sees over open ground. Behind a shelf, beside a wall or among
/// houses they leave gaps. A gap is a cell that no scan has hit, with a place beside it that the robot can reach, from
/// which nothing known hides it, and below which scans have shown something: what lies beyond a wall is no gap. Works
/// in the robot's estimate of the map frame. Owned by one behavior.
class GapSearch {
public:
    /// What the robot knows of its surroundings at its present height.
    struct Surroundings {
        ReachablePlaces reach;
        std::function<bool(const Vec2& from_m, const Vec2& to_m)> in_sight;
    };

    /// True if all that was not seen is too little to matter.
    static bool isNeedless(const ScanLedger& ledger);
    /// The share of the ground within the robot's reach that no scan has shown: gaps, and what lies in sight beyond
    /// them.
    static double missed(const ScanLedger& ledger, const Surroundings& surroundings);
    /// Returns short lanes past the gaps, each of which is nearest to the end of the one before, from `from_m` on; none
    /// if the gaps are too small to matter. Each gap is tried once.
    std::vector<mapping::Lane> lanes(const ScanLedger& ledger, const Surroundings& surroundings, const Vec2& from_m);

private:
    struct Gap {
        int column = 0;
        int row = 0;
        Vec2 center_m = Vec2::Zero();
        Vec2 view_m = Vec2::Zero(); ///< place of the robot from which it is seen
    };
    using Gaps = std::vector<Gap>;

    /// `tried`: cells that are no gaps any more.
    static Gaps gapsIn(const ScanLedger& ledger, const Surroundings& surroundings, const std::vector<bool>& tried);

    std::vector<bool> tried_; ///< by cell of the ledger, row by row
};

} // namespace usar::airrobot
