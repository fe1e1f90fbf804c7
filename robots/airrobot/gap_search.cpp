#include "robots/airrobot/gap_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "robots/airrobot/lane_order.h"

namespace usar::airrobot {

namespace {

constexpr double view_within_m = 2.5; ///< Nothing that is farther from the robot counts as a gap that it can see.
constexpr double look_step_m = 0.5;
/// Smaller gaps are left alone: a flight costs more than they are worth, and so it does if all of them together are
/// less than this share of what was seen.
constexpr double least_gap_m2 = 1.5;
constexpr double least_share = 0.015;
constexpr int near_cells = 2;      ///< Cells so near to one another belong to one gap,
constexpr double longest_m = 6.0;  ///< but not if they are farther than this from its first one.
constexpr double shortest_m = 3.0; ///< A gap that is shorter has no direction of its own.
constexpr double past_m = 2.0;     ///< The robot flies so far past the middle of such a gap.
constexpr double sideways_m = 0.5;
constexpr double half_hidden = 0.5;
constexpr double cell_m2 = ScanLedger::cell_m * ScanLedger::cell_m;
/// What stands so near before a place that it hides a part of a cell would not hide a whole one.
constexpr double beyond_part_m = 0.75;

/// Places beside the origin, nearest first.
std::vector<Vec2> placesBeside() {
    std::vector<Vec2> places;
    for (double x_m = -view_within_m; x_m <= view_within_m; x_m += look_step_m)
        for (double y_m = -view_within_m; y_m <= view_within_m; y_m += look_step_m)
            if (std::hypot(x_m, y_m) <= view_within_m)
                places.emplace_back(x_m, y_m);
    std::ranges::sort(places, {}, [](const Vec2& place) { return place.norm(); });
    return places;
}

/// The middle of what no scan has hit of the cell around `cell_center_m`.
Vec2 hiddenCenter_m(const ScanLedger& ledger, const Vec2& cell_center_m) {
    Vec2 sum_m = Vec2::Zero();
    int count = 0;
    for (const double right : {-0.25, 0.25})
        for (const double up : {-0.25, 0.25})
            if (const Vec2 at_m = cell_center_m + ScanLedger::cell_m * Vec2(right, up); !ledger.isQuarterSeen(at_m)) {
                sum_m += at_m;
                ++count;
            }
    return count > 0 ? Vec2(sum_m / count) : cell_center_m;
}

/// A point from `middle_m` on along `along`, as far as a way leads, but not farther than `length_m`.
Vec2 farthestReached_m(const ReachablePlaces& reach, const Vec2& middle_m, const Vec2& along, double length_m) {
    while (length_m > 0.0 && !reach.contains(middle_m + length_m * along))
        length_m -= look_step_m;
    return middle_m + std::max(length_m, look_step_m) * along;
}

} // namespace

GapSearch::Gaps GapSearch::gapsIn(const ScanLedger& ledger, const Surroundings& surroundings) {
    static const std::vector<Vec2> beside = placesBeside();
    Gaps gaps;
    for (int row = 0; row < ledger.rows(); ++row)
        for (int column = 0; column < ledger.columns(); ++column) {
            if (ledger.at(column, row) != ScanLedger::Cell::Unknown)
                continue;
            const Vec2 center_m = ledger.centerOf_m(column, row);
            const auto place = std::ranges::find_if(beside, [&](const Vec2& offset_m) {
                const Vec2 view_m = center_m + offset_m;
                return ledger.isSeen(view_m) && surroundings.reach.knows(view_m) &&
                       surroundings.reach.contains(view_m) && surroundings.in_sight(view_m, center_m);
            });
            if (place != beside.end())
                gaps.push_back({column, row, center_m, center_m + *place, cell_m2});
        }
    return gaps;
}

GapSearch::Gaps GapSearch::partsIn(const ScanLedger& ledger, const Surroundings& surroundings) {
    static const std::vector<Vec2> beside = placesBeside();
    Gaps gaps;
    for (int row = 0; row < ledger.rows(); ++row)
        for (int column = 0; column < ledger.columns(); ++column) {
            const double hidden = ledger.hidden(column, row);
            if (ledger.at(column, row) != ScanLedger::Cell::Seen || hidden < half_hidden)
                continue;
            const Vec2 center_m = hiddenCenter_m(ledger, ledger.centerOf_m(column, row));
            const auto place = std::ranges::find_if(beside, [&](const Vec2& offset_m) {
                const Vec2 view_m = center_m + offset_m;
                const Vec2 past_it_m = center_m - beyond_part_m * offset_m.normalized();
                return ledger.isSeen(view_m) && surroundings.reach.knows(view_m) &&
                       surroundings.reach.contains(view_m) && surroundings.in_sight(view_m, past_it_m);
            });
            if (place != beside.end())
                gaps.push_back({column, row, center_m, center_m + *place, hidden * cell_m2});
        }
    return gaps;
}

namespace {

/// Takes the gaps that belong to the last one out of `gaps`.
template <class Gaps>
Gaps takeGroup(Gaps& gaps) {
    Gaps group{gaps.back()};
    gaps.pop_back();
    for (std::size_t next = 0; next < group.size(); ++next) {
        const auto one = group[next];
        const auto first = group.front();
        const auto belongs = [&](const auto& other) {
            return std::max(std::abs(other.column - one.column), std::abs(other.row - one.row)) <= near_cells &&
                   (other.center_m - first.center_m).norm() <= longest_m;
        };
        const auto rest = std::ranges::stable_partition(gaps, [&](const auto& other) { return !belongs(other); });
        group.insert(group.end(), rest.begin(), rest.end());
        gaps.erase(rest.begin(), rest.end());
    }
    return group;
}

template <class Gaps>
double areaOf_m2(const Gaps& gaps) {
    double sum_m2 = 0.0;
    for (const auto& gap : gaps)
        sum_m2 += gap.area_m2;
    return sum_m2;
}

/// A lane past all gaps of a group; `again`: a short one past their middle, because the first has not shown them.
template <class Gaps>
mapping::Lane lanePast(const Gaps& group, const ReachablePlaces& reach, bool again) {
    Vec2 mean_m = Vec2::Zero();
    Vec2 sight_m = Vec2::Zero();
    for (const auto& gap : group) {
        mean_m += gap.view_m / static_cast<double>(group.size());
        sight_m += (gap.center_m - gap.view_m) / static_cast<double>(group.size());
    }
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const auto& gap : group)
        spread += (gap.view_m - mean_m) * (gap.view_m - mean_m).transpose();
    Vec2 along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
    double low_m = 0.0;
    double high_m = 0.0;
    const Vec2 middle_m =
        std::ranges::min_element(group, {}, [&](const auto& gap) { return (gap.view_m - mean_m).norm(); })->view_m;
    for (const auto& gap : group) {
        low_m = std::min(low_m, along.dot(gap.view_m - middle_m));
        high_m = std::max(high_m, along.dot(gap.view_m - middle_m));
    }
    if (high_m - low_m < shortest_m || again) { // The scanner looks to the sides.
        if (sight_m.norm() > sideways_m)
            along = Vec2(-sight_m.y(), sight_m.x()).normalized();
        else if (again)
            along = Vec2(-along.y(), along.x());
        low_m = -past_m;
        high_m = past_m;
    }
    return {farthestReached_m(reach, middle_m, -along, -low_m), farthestReached_m(reach, middle_m, along, high_m), 0};
}

} // namespace

bool GapSearch::isNeedless(const ScanLedger& ledger) {
    const double seen = ledger.seen();
    const double unknown = 1.0 - seen - ledger.bottomless();
    return unknown < least_share * (seen + unknown);
}

double GapSearch::missed(const ScanLedger& ledger, const Surroundings& surroundings) {
    const auto indexOf = [&](int column, int row) {
        return std::size_t(row) * std::size_t(ledger.columns()) + std::size_t(column);
    };
    std::vector<bool> counted(std::size_t(ledger.columns()) * std::size_t(ledger.rows()));
    Gaps found = gapsIn(ledger, surroundings);
    for (const Gap& gap : found)
        counted[indexOf(gap.column, gap.row)] = true;
    for (std::size_t next = 0; next < found.size(); ++next) // What lies beyond a gap is found from there.
        for (const auto& [right, up] : {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
            const Gap from = found[next];
            const int column = from.column + right;
            const int row = from.row + up;
            if (column < 0 || row < 0 || column >= ledger.columns() || row >= ledger.rows() ||
                counted[indexOf(column, row)] || ledger.at(column, row) != ScanLedger::Cell::Unknown)
                continue;
            const Vec2 center_m = ledger.centerOf_m(column, row);
            if (!surroundings.reach.knows(center_m) || !surroundings.reach.contains(center_m) ||
                !surroundings.in_sight(from.center_m, center_m))
                continue;
            counted[indexOf(column, row)] = true;
            found.push_back({column, row, center_m, center_m, cell_m2});
        }
    const double seen = ledger.seen() * static_cast<double>(counted.size());
    return found.empty() ? 0.0 : static_cast<double>(found.size()) / (seen + static_cast<double>(found.size()));
}

std::vector<mapping::Lane> GapSearch::lanes(const ScanLedger& ledger, const Surroundings& surroundings,
                                            const Vec2& from_m) {
    const std::size_t cells = std::size_t(ledger.columns()) * std::size_t(ledger.rows());
    tries_.resize(cells);
    const auto triesOf = [&](const Gap& gap) -> std::uint8_t& {
        return tries_[std::size_t(gap.row) * std::size_t(ledger.columns()) + std::size_t(gap.column)];
    };
    Gaps gaps = gapsIn(ledger, surroundings);
    const Gaps parts = partsIn(ledger, surroundings);
    gaps.insert(gaps.end(), parts.begin(), parts.end());
    std::erase_if(gaps, [&](const Gap& gap) { return triesOf(gap) >= most_tries; });
    const double seen_m2 = ledger.seen() * static_cast<double>(cells) * cell_m2;
    if (const double gaps_m2 = areaOf_m2(gaps); gaps_m2 < least_share * (seen_m2 + gaps_m2))
        return {};
    std::vector<mapping::Lane> lanes;
    while (!gaps.empty()) {
        const Gaps group = takeGroup(gaps);
        const bool again = std::ranges::any_of(group, [&](const Gap& gap) { return triesOf(gap) > 0; });
        for (const Gap& gap : group)
            ++triesOf(gap);
        if (areaOf_m2(group) >= least_gap_m2)
            lanes.push_back(lanePast(group, surroundings.reach, again));
    }
    orderFrom(from_m, lanes);
    return lanes;
}

} // namespace usar::airrobot
