#include "robots/airrobot/outlook.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/time_range.h"
#include "core/protocol/usual_values.h"
#include "robots/airrobot/flight/time_estimate.h"

namespace usar::airrobot {

namespace {

constexpr int samples_per_gap = 16; ///< between two lanes
constexpr double same_lane_m = 0.1; ///< Two lanes that are nearer to each other are pieces of one.
/// The least local share that is hidden, times the width of a lane's strip, for each least gain: fitted to what
/// *balanced* added in `tall_test`, 508 to 792 m (measured.md).
constexpr double worth_a_lane = 1.05;
constexpr double woods_pace = 1.1;      ///< What is usual takes so many times as long in woods, because of evasion.
constexpr double nine_of_ten = 1.64;    ///< deviations within which so many normally distributed values lie
constexpr double surveyed_reach = 0.95; ///< of the scanner's greatest range: ground is not quite level

/// The lanes of a quadrant are parallel and as long as it, so only the place across them matters.
double hiddenShare(const Rectangle& quadrant, std::span<const mapping::Lane> lanes, const Settings& settings,
                   double clutter) {
    const Vec2 way = lanes[0].end_m - lanes[0].start_m;
    const int across = std::abs(way.x()) >= std::abs(way.y()) ? 1 : 0;
    const double width_m = quadrant.max_m[across] - quadrant.min_m[across];
    const double range_m = surveyed_reach * protocol::usual_scanner_maximum_m;
    const double height_m = settings.scan_altitude_m;
    const double reach_m = std::sqrt(std::max(0.0, range_m * range_m - height_m * height_m));
    std::vector<double> lanes_m; // across them; a lane that was broken off is in two pieces, and counts once
    for (const mapping::Lane& lane : lanes)
        if (std::ranges::none_of(lanes_m,
                                 [&](double at_m) { return std::abs(at_m - lane.start_m[across]) < same_lane_m; }))
            lanes_m.push_back(lane.start_m[across]);
    const auto samples = static_cast<int>(lanes_m.size()) * samples_per_gap;
    double hidden = 0.0;
    for (int i = 0; i < samples; ++i) {
        const double at_m = quadrant.min_m[across] + (i + 0.5) * width_m / samples;
        double missed = 1.0;
        for (const double lane_m : lanes_m)
            if (const double aside_m = std::abs(at_m - lane_m); aside_m <= reach_m)
                missed *= 1.0 - std::exp(-clutter * aside_m / height_m);
        hidden += missed / samples;
    }
    return hidden;
}

} // namespace

double areaOf_m2(const mapping::CoveragePlan& plan) {
    double sum_m2 = 0.0;
    for (const Rectangle& quadrant : plan.quadrants)
        sum_m2 += quadrant.width_m() * quadrant.height_m();
    return sum_m2;
}

double hiddenShare(const mapping::CoveragePlan& plan, const Settings& settings, double clutter) {
    double hidden_m2 = 0.0;
    std::vector<std::vector<mapping::Lane>> by_quadrant(plan.quadrants.size());
    for (const mapping::Lane& lane : plan.lanes)
        by_quadrant[static_cast<std::size_t>(lane.quadrant)].push_back(lane);
    for (std::size_t i = 0; i < by_quadrant.size(); ++i) {
        if (by_quadrant[i].empty())
            continue; // All of it was shown on other ways.
        const Rectangle& quadrant = plan.quadrants[i];
        hidden_m2 +=
            quadrant.width_m() * quadrant.height_m() * hiddenShare(quadrant, by_quadrant[i], settings, clutter);
    }
    const double all_m2 = areaOf_m2(plan);
    return all_m2 > 0.0 ? hidden_m2 / all_m2 : 0.0;
}

AddedLanes addedLanes(double hidden, double area_m2, const Settings& settings) {
    if (!(hidden > 0.0))
        return {};
    const double least = worth_a_lane * settings.least_gain_m / settings.lane_spacing_m;
    const double share = std::exp(-least / hidden);
    return {share * area_m2 / settings.lane_spacing_m, share * (least + hidden)};
}

std::string outlookWords(const agent::TaskOutlook& outlook) {
    const std::string sorties =
        outlook.least_sorties == outlook.most_sorties
            ? std::to_string(outlook.least_sorties)
            : std::to_string(outlook.least_sorties) + " to " + std::to_string(outlook.most_sorties);
    return "In the open, it will take " + countdownText(outlook.duration.least) + " to " +
           countdownText(outlook.duration.most) + " in " + sorties +
           (outlook.most_sorties == 1 ? " sortie" : " sorties") + ", and show " +
           fixed(std::floor(outlook.least_coverage_pct), 0) + " to " + fixed(std::ceil(outlook.most_coverage_pct), 0) +
           " % of the area.";
}

Outlook outlookOf(const Survey& survey, const Vec2& base_m, const Settings& settings) {
    struct End {
        WholeFlight flight;
        double coverage_pct;
    };
    const auto in = [&](double clutter) {
        const double hidden = hiddenShare(survey.plan(), settings, clutter);
        const AddedLanes added = addedLanes(ledger_share * hidden, areaOf_m2(survey.plan()), settings);
        return End{TimeEstimate().whole(survey, base_m, added.length_m, settings),
                   100.0 * (1.0 - hidden + added.shown / ledger_share)};
    };
    const End bare = in(clutter::bare);
    const End woods = in(clutter::woods);
    Outlook outlook;
    outlook.expected = Seconds(0.5 * (bare.flight.time.mean + woods.flight.time.mean));
    outlook.range.duration.least =
        Seconds(std::max(0.0, bare.flight.time.mean - nine_of_ten * bare.flight.time.deviation()));
    outlook.range.duration.most =
        Seconds(woods_pace * woods.flight.time.mean + nine_of_ten * woods.flight.time.deviation());
    outlook.range.least_sorties = 1 + static_cast<int>(std::floor(bare.flight.charges));
    outlook.range.most_sorties = 1 + static_cast<int>(std::ceil(woods_pace * woods.flight.charges));
    outlook.range.least_coverage_pct = woods.coverage_pct;
    outlook.range.most_coverage_pct = bare.coverage_pct;
    return outlook;
}

} // namespace usar::airrobot
