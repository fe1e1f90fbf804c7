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
/// Fewer cells are left alone: a flight costs more than they are worth, and so it does if all of them together are less
/// than this share of what was seen.
constexpr std::size_t least_cells = 3;
constexpr double least_share = 0.015;
constexpr int near_cells = 2;      ///< Cells so near to one another belong to one gap,
constexpr double longest_m = 6.0;  ///< but not if they are farther than this from its first one.
constexpr double shortest_m = 3.0; ///< A gap that is shorter has no direction of its own.
constexpr double past_m = 2.0;     ///< The robot flies so far past the middle of such a gap.
constexpr double sideways_m = 0.5;

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

/// A point from `middle_m` on along `along`, as far as a way leads, but not farther than `length_m`.
Vec2 farthestReached_m(const ReachablePlaces& reach, const Vec2& middle_m, const Vec2& along, double length_m) {
    while (length_m > 0.0 && !reach.contains(middle_m + length_m * along))
        length_m -= look_step_m;
    return middle_m + std::max(length_m, look_step_m) * along;
}

} // namespace

GapSearch::Gaps GapSearch::gapsIn(const ScanLedger& ledger, const Surroundings& surroundings,
                                  const std::vector<bool>& tried) {
    static const std::vector<Vec2> beside = placesBeside();
    Gaps gaps;
    for (int row = 0; row < ledger.rows(); ++row)
        for (int column = 0; column < ledger.columns(); ++column) {
            const std::size_t index = std::size_t(row) * std::size_t(ledger.columns()) + std::size_t(column);
            if (tried[index] || ledger.at(column, row) != ScanLedger::Cell::Unknown)
                continue;
            const Vec2 center_m = ledger.centerOf_m(column, row);
            const auto place = std::ranges::find_if(beside, [&](const Vec2& offset_m) {
                const Vec2 view_m = center_m + offset_m;
                return ledger.isSeen(view_m) && surroundings.reach.knows(view_m) &&
                       surroundings.reach.contains(view_m) && surroundings.in_sight(view_m, center_m);
            });
            if (place != beside.end())
                gaps.push_back({column, row, center_m, center_m + *place});
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

/// A lane past all gaps of a group.
template <class Gaps>
mapping::Lane lanePast(const Gaps& group, const ReachablePlaces& reach) {
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
    if (high_m - low_m < shortest_m) { // The scanner looks to the sides.
        if (sight_m.norm() > sideways_m)
            along = Vec2(-sight_m.y(), sight_m.x()).normalized();
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
    Gaps found = gapsIn(ledger, surroundings, counted);
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
            found.push_back({column, row, center_m, center_m});
        }
    const double seen = ledger.seen() * static_cast<double>(counted.size());
    return found.empty() ? 0.0 : static_cast<double>(found.size()) / (seen + static_cast<double>(found.size()));
}

std::vector<mapping::Lane> GapSearch::lanes(const ScanLedger& ledger, const Surroundings& surroundings,
                                            const Vec2& from_m) {
    const std::size_t cells = std::size_t(ledger.columns()) * std::size_t(ledger.rows());
    tried_.resize(cells);
    Gaps gaps = gapsIn(ledger, surroundings, tried_);
    const double seen = ledger.seen() * static_cast<double>(cells);
    if (static_cast<double>(gaps.size()) < least_share * (seen + static_cast<double>(gaps.size())))
        return {};
    std::vector<mapping::Lane> lanes;
    while (!gaps.empty()) {
        const Gaps group = takeGroup(gaps);
        for (const Gap& gap : group)
            tried_[std::size_t(gap.row) * std::size_t(ledger.columns()) + std::size_t(gap.column)] = true;
        if (group.size() >= least_cells)
            lanes.push_back(lanePast(group, surroundings.reach));
    }
    orderFrom(from_m, lanes);
    return lanes;
}

} // namespace usar::airrobot
