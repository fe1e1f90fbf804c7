// Finds straight lanes across an open area that show most of what the lanes before them have left hidden.
#pragma once

#include <vector>

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/scan_ledger.h"
#include "robots/airrobot/sorties.h"

namespace usar::airrobot {

/// The worth of a lane that is added to a survey.
struct LaneTerms {
    /// New area per length of lane and of the way to it, in square meters per meter; less in an area below 5900 m².
    double least_gain_m;
    double most_m;             ///< length of all lanes together
    double resolution_m = 0.5; ///< distance of the map's points; no lanes are added to a coarse map
    Endurance endurance{};
    /// Lanes along x or y that were flown past hidden ground: what they have left hidden will not be shown either.
    std::vector<mapping::Lane> flown{};
};

/// Crowns hide the ground behind them, each lane's on its far side. A lane along x or y looks there from another side
/// and ties the strips together if it crosses the first ones, and looks there from nearer if it runs between them. A
/// square of 21 m of which nothing was seen is no shadow: the robot did not get there before, and is not sent there
/// again. Lanes are chosen one by one: each is the piece of a line along x or y that shows the most for its length,
/// given those before it; those that are not worth their way are dropped. Whether anything stands in the way is not
/// asked, because the robot flies around and over what it meets; use GapSearch where it cannot. Returns the lanes in
/// the order of short sorties from `from_m` on, numbered from 0, each of which ends at `home_m`; none if no lane is
/// worth it. Works in the robot's estimate of the map frame.
std::vector<mapping::Lane> crossLanes(const ScanLedger& ledger, const LaneTerms& terms, const Vec2& from_m,
                                      const Vec2& home_m);

} // namespace usar::airrobot
