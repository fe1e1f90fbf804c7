// What a survey will probably show and take: how much ground obstacles hide from its lanes, what lanes are added for
// that, and the whole before the start.
#pragma once

#include <string>

#include "core/agent/robot_plugin.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// How cluttered the ground is: obstacles per area times their width times their height, without a unit. A view that
/// comes down steeply passes all of them with the probability exp(-clutter * tan(angle from straight down)), if they
/// stand at random.
namespace clutter {
inline constexpr double bare = 0.0; ///< Nothing stands there.
/// A meadow with a tree here and there: the presets' planned lanes showed 98.9 to 99.7 % of it (`quick_scan`).
inline constexpr double meadow = 0.1;
/// Between the two, where nothing is known.
inline constexpr double usual = 0.2;
/// Woods: they showed 92.8 to 99.0 % of `tall_test`.
inline constexpr double woods = 0.32;
} // namespace clutter

/// The area of all quadrants together, in square meters.
double areaOf_m2(const mapping::CoveragePlan& plan);
/// The share of the area that the lanes of a plan leave hidden, 0 to 1: of ground that d is aside of a lane, the lane
/// at height h shows the share exp(-clutter d / h), and what one lane misses the others may show.
double hiddenShare(const mapping::CoveragePlan& plan, const Settings& settings, double clutter);

/// The coarser ScanLedger has so much of that hidden: 3.8 % where it was 7.2 % (`tall_test`, *balanced*).
inline constexpr double ledger_share = 0.52;

/// Lanes that are added past hidden ground.
struct AddedLanes {
    double length_m = 0.0;
    double shown = 0.0; ///< share of the ledger that they show and that was hidden
};

/// What Leftovers will probably add if the planned lanes leave this share of the ledger hidden. Hidden ground is not
/// spread evenly: with an exponential distribution of the local share, exp(-x / hidden) of the area has more than x
/// hidden, the least for which a lane is worth its way, and lanes are added there.
AddedLanes addedLanes(double hidden, double area_m2, const Settings& settings);

/// What a survey will probably take and show.
struct Outlook {
    Seconds expected{0.0};    ///< the mean of those on bare ground and in woods
    agent::TaskOutlook range; ///< from bare ground to woods
};

/// The outlook of a survey that starts at its base. The settings must be as asked.
Outlook outlookOf(const Survey& survey, const Vec2& base_m, const Settings& settings);

/// "In the open, it will take 38:20 to 47:10 in 5 to 6 sorties, and show 93 to 99 % of the area."
std::string outlookWords(const agent::TaskOutlook& outlook);

} // namespace usar::airrobot
