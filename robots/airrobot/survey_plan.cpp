#include "robots/airrobot/survey_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robots/airrobot/flight/battery_model.h"

namespace usar::airrobot {

namespace {

/// By INS, a sortie is no longer than this and the way to the farthest lane and back, which is about what a quadrant
/// takes: the error of the map grows with the way since the INS was set.
constexpr double longest_by_ins_m = 1000.0;
/// Another order than to and fro must save so much: with that one, strips that overlap are scanned shortly after each
/// other, while the INS has hardly drifted.
constexpr double worth_an_order = 0.99;
/// Over a larger area, long lanes would be scanned too long after their neighbors.
constexpr std::size_t most_lanes = 2 * few_lanes;
constexpr double slice_m = 5.0;        ///< pieces of a strip that are looked at
constexpr double nothing_left_m = 2.5; ///< A shorter rest of a lane is not worth a flight.
/// A strip is shown if at most this share of it is hidden, or what an added lane would have to show, if that is less.
constexpr double hidden_share = 0.05;

Endurance sortieOf(const std::vector<mapping::Lane>& lanes, const Vec2& base_m, const Settings& settings,
                   double detour) {
    Endurance endurance = enduranceOf(settings, 0.0, detour);
    double farthest_m = 0.0;
    for (const mapping::Lane& lane : lanes)
        farthest_m = std::max({farthest_m, (lane.start_m - base_m).norm(), (lane.end_m - base_m).norm()});
    const double by_ins_m = longest_by_ins_m + 2.0 * farthest_m;
    if (!settings.navigate_by_truth && by_ins_m < endurance.full_m) {
        endurance.full_m = by_ins_m;
        endurance.breaks_off = false; // Nothing ends a sortie there but its plan.
    }
    endurance.left_m = endurance.full_m;
    return endurance;
}

/// Puts the lanes that a full battery does not reach behind the others, because the survey ends with the first of them.
void putLast(std::vector<mapping::Lane>& lanes, const Vec2& base_m, const Endurance& endurance) {
    std::ranges::stable_partition(lanes, [&](const mapping::Lane& lane) {
        return 2.0 * std::max((lane.start_m - base_m).norm(), (lane.end_m - base_m).norm()) < endurance.full_m;
    });
}

/// Orders the lanes anew if that is worth it, and divides them into sorties. Returns the length of the flight.
double route(std::vector<mapping::Lane>& lanes, const Vec2& base_m, const Endurance& endurance) {
    if (lanes.size() <= few_lanes) {
        std::vector<mapping::Lane> other = lanes, as_tour = lanes;
        orderTour(base_m, as_tour, base_m);
        improveFlights(base_m, other, base_m, endurance);
        improveFlights(base_m, as_tour, base_m, endurance);
        if (flight_m(base_m, as_tour, base_m, endurance) < flight_m(base_m, other, base_m, endurance))
            other = std::move(as_tour);
        if (flight_m(base_m, other, base_m, endurance) < worth_an_order * flight_m(base_m, lanes, base_m, endurance))
            lanes = std::move(other);
    }
    putLast(lanes, base_m, endurance);
    return divideIntoSorties(base_m, lanes, base_m, endurance);
}

/// The ways between the lanes, from the base and back to it, with the flights home between sorties.
double ways_m(const std::vector<mapping::Lane>& lanes, const Vec2& base_m) {
    double ways_m = 0.0;
    for (auto first = lanes.begin(); first != lanes.end();) {
        const auto last =
            std::find_if(first, lanes.end(), [&](const mapping::Lane& lane) { return lane.sortie != first->sortie; });
        ways_m += waysBetween_m(base_m, {first, last}, base_m);
        first = last;
    }
    return ways_m;
}

/// How much of the strip beside a slice of a lane is hidden, in square meters. Where beams met nothing is hidden, too,
/// because there may be ground.
double hidden_m2(const Vec2& from_m, const Vec2& to_m, const ScanLedger& ledger, double width_m) {
    const Vec2 along = (to_m - from_m).normalized();
    const Vec2 aside_m = width_m / 2.0 * Vec2(-along.y(), along.x());
    const Vec2 least_m =
        (from_m - aside_m).cwiseMin(to_m - aside_m).cwiseMin(from_m + aside_m).cwiseMin(to_m + aside_m);
    const Vec2 most_m = (from_m - aside_m).cwiseMax(to_m - aside_m).cwiseMax(from_m + aside_m).cwiseMax(to_m + aside_m);
    const ScanLedger::Hidden strip = ledger.hiddenIn({least_m, most_m});
    return strip.hidden_m2 + strip.bottomless_m2;
}

/// How much of a lane is shown from its start on.
double shown_m(const mapping::Lane& lane, const ScanLedger& ledger, const Settings& settings) {
    const double length_m = (lane.end_m - lane.start_m).norm();
    const Vec2 along = length_m > 0.0 ? Vec2((lane.end_m - lane.start_m) / length_m) : Vec2(Vec2::Zero());
    const double least_m2_m = std::min(settings.least_gain_m, hidden_share * settings.lane_spacing_m);
    double shown_m = 0.0;
    while (shown_m < length_m) {
        const double to_m = std::min(shown_m + slice_m, length_m);
        const double hidden =
            hidden_m2(lane.start_m + shown_m * along, lane.start_m + to_m * along, ledger, settings.lane_spacing_m);
        if (hidden > least_m2_m * (to_m - shown_m))
            break;
        shown_m = to_m;
    }
    return shown_m;
}

bool haveSameEnds(const std::vector<mapping::Lane>& some, const std::vector<mapping::Lane>& others) {
    return std::ranges::equal(some, others, [](const mapping::Lane& one, const mapping::Lane& other) {
        return one.start_m == other.start_m && one.end_m == other.end_m;
    });
}

Result<SurveyPlan> planByQuadrants(const Rectangle& area_in_map, const Vec2& base_m, const Settings& settings) {
    mapping::CoverageOptions options{settings.lane_spacing_m, settings.quadrant_limit_m};
    auto plan = mapping::planCoverage(area_in_map, base_m, options);
    if (!plan)
        return tl::unexpected(plan.error());
    const double quadrant_m = plan->lane_length_m / static_cast<double>(plan->quadrants.size());
    options.returns =
        settings.hurried() && isWorthACharge(quadrant_m, settings) && quadrant_m < usableRange_m(settings);
    if (options.returns)
        plan = mapping::planCoverage(area_in_map, base_m, options);
    return SurveyPlan{std::move(*plan), false, settings.lane_spacing_m};
}

} // namespace

Result<SurveyPlan> planSurvey(const Rectangle& area_in_map, const Vec2& base_m, const Settings& settings) {
    auto best = planByQuadrants(area_in_map, base_m, settings);
    if (!best || !settings.hurried() || best->coverage.lanes.size() > most_lanes)
        return best;
    const Endurance endurance = sortieOf(best->coverage.lanes, base_m, settings, usual_detour);
    best->routed = best->coverage.lanes.size() <= few_lanes;
    double least_m = best->routed ? route(best->coverage.lanes, base_m, endurance)
                                  : flight_m(base_m, best->coverage.lanes, base_m, endurance);
    std::vector<mapping::Lane> tried;
    for (const double limit_m : {settings.quadrant_limit_m, std::numeric_limits<double>::infinity()})
        for (const bool crosswise : {false, true}) {
            auto other =
                mapping::planCoverage(area_in_map, base_m, {settings.lane_spacing_m, limit_m, false, crosswise});
            if (!other || other->lanes.size() > few_lanes || haveSameEnds(other->lanes, tried))
                continue;
            tried = other->lanes;
            const double other_m = route(other->lanes, base_m, endurance);
            if (other_m < worth_an_order * least_m) {
                least_m = other_m;
                *best = {std::move(*other), true, settings.lane_spacing_m};
            }
        }
    if (best->routed)
        best->coverage.transit_length_m = ways_m(best->coverage.lanes, base_m);
    return best;
}

mapping::Lane withoutShownEnds(const mapping::Lane& lane, const ScanLedger& ledger, const Settings& settings) {
    const Vec2 along = (lane.end_m - lane.start_m).normalized();
    mapping::Lane rest = lane;
    rest.start_m += shown_m(lane, ledger, settings) * along;
    rest.end_m -= std::min((rest.end_m - rest.start_m).norm(), shown_m(turned(rest), ledger, settings)) * along;
    return rest;
}

std::vector<mapping::Lane> replanned(std::vector<mapping::Lane> lanes, const ScanLedger& ledger, const Vec2& base_m,
                                     const Settings& settings, double detour) {
    if (ledger.columns() > 0) // Otherwise, the area is too large to be watched.
        for (mapping::Lane& lane : lanes)
            lane = withoutShownEnds(lane, ledger, settings);
    std::erase_if(lanes, [](const mapping::Lane& lane) { return (lane.end_m - lane.start_m).norm() < nothing_left_m; });
    route(lanes, base_m, sortieOf(lanes, base_m, settings, detour));
    return lanes;
}

} // namespace usar::airrobot
