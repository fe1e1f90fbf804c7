// Plans the sorties of a survey before the start, and what is left of them after each landing.
#pragma once

#include "core/mapping/coverage_path.h"
#include "robots/airrobot/scan_ledger.h"
#include "robots/airrobot/sorties.h"

namespace usar::airrobot {

/// The lanes of a survey.
struct SurveyPlan {
    mapping::CoveragePlan coverage;
    bool routed = false;         ///< the lanes are divided into sorties by the battery, instead of by quadrants
    double lane_spacing_m = 0.0; ///< for which it was planned
};

/// Plans lanes over the area, from the base on. A robot in no hurry flies quadrant by quadrant, as in the thesis (4.1).
/// For one in a hurry, lanes along either side of the area, in quadrants or not, are ordered and divided into sorties
/// (see sorties.h), and those are taken that need the shortest flight. By INS, no sortie of more than one lane is
/// planned to be longer than 1000 m and the way to the farthest lane and back, however long the battery lasts. Plans of
/// more than `few_lanes` lanes are not routed; if all have so many, or quadrants have twice as many, the area is
/// flown quadrant by quadrant, too. Lanes out of the battery's reach come last. Returns an error if no lane fits into
/// the area.
Result<SurveyPlan> planSurvey(const Rectangle& area_in_map, const Vec2& base_m, const Settings& settings);

/// Plans what is left of a survey after a landing. It leaves out the ends of lanes that the robot has shown on other
/// ways, where 5 % of their strips are hidden at most, or less than an added lane must show, and rests under 2.5 m,
/// even if they are hidden. It orders what remains and divides it into sorties. `detour`: the way that the robot has
/// flown so far for each meter of its lanes. The order is that of `lanes` if there are more than `few_lanes`.
std::vector<mapping::Lane> replanned(std::vector<mapping::Lane> lanes, const ScanLedger& ledger, const Vec2& base_m,
                                     const Settings& settings, double detour);

/// Returns the lane without the ends that `replanned` leaves out; nothing of its length is left if all was shown.
mapping::Lane withoutShownEnds(const mapping::Lane& lane, const ScanLedger& ledger, const Settings& settings);

} // namespace usar::airrobot
