#include "robots/airrobot/lane_order.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace usar::airrobot {

namespace {

using Lanes = std::vector<mapping::Lane>;

constexpr double worth_a_change_m = 1e-6; ///< A smaller gain may be one of rounding, and the search would not end.

/// The ways that a lane between two places costs, less the way that it saves.
double waysTo_m(const Vec2& before_m, const mapping::Lane& lane, const Vec2& after_m) {
    return (lane.start_m - before_m).norm() + (after_m - lane.end_m).norm() - (after_m - before_m).norm();
}

/// A tour of lanes from one place to another.
class Tour {
public:
    Tour(const Vec2& from_m, Lanes& lanes, const Vec2& to_m) : from_m_(from_m), lanes_(lanes), to_m_(to_m) {}

    /// Turns around every piece whose turning shortens the tour. Returns whether any was turned.
    bool turnPieces() {
        bool shortened = false;
        for (std::size_t first = 0; first < lanes_.size(); ++first)
            for (std::size_t last = first; last < lanes_.size(); ++last) {
                const Vec2 &start_m = lanes_[first].start_m, &end_m = lanes_[last].end_m;
                const double now_m = (before_m(first) - start_m).norm() + (end_m - after_m(last)).norm();
                const double then_m = (before_m(first) - end_m).norm() + (start_m - after_m(last)).norm();
                if (then_m < now_m - worth_a_change_m) {
                    turn(first, last);
                    shortened = true;
                }
            }
        return shortened;
    }

    /// Moves each lane to the place where it costs least, if that is another one. Returns whether any was moved.
    bool moveLanes() {
        bool shortened = false;
        for (std::size_t i = 0; i < lanes_.size(); ++i) {
            const mapping::Lane lane = lanes_[i];
            const double here_m = waysTo_m(before_m(i), lane, after_m(i));
            lanes_.erase(lanes_.begin() + static_cast<std::ptrdiff_t>(i));
            std::size_t best = i;
            mapping::Lane best_lane = lane;
            double least_m = here_m - worth_a_change_m;
            for (std::size_t place = 0; place <= lanes_.size(); ++place)
                for (const mapping::Lane& way : {lane, turned(lane)})
                    if (const double cost_m = waysTo_m(before_m(place), way, startAt_m(place)); cost_m < least_m) {
                        least_m = cost_m;
                        best = place;
                        best_lane = way;
                        shortened = true;
                    }
            lanes_.insert(lanes_.begin() + static_cast<std::ptrdiff_t>(best), best_lane);
        }
        return shortened;
    }

private:
    Vec2 before_m(std::size_t i) const { return i == 0 ? from_m_ : lanes_[i - 1].end_m; }
    Vec2 startAt_m(std::size_t i) const { return i == lanes_.size() ? to_m_ : lanes_[i].start_m; }
    Vec2 after_m(std::size_t i) const { return startAt_m(i + 1); }

    void turn(std::size_t first, std::size_t last) {
        const auto begin = lanes_.begin() + static_cast<std::ptrdiff_t>(first);
        const auto end = lanes_.begin() + static_cast<std::ptrdiff_t>(last) + 1;
        std::reverse(begin, end);
        std::transform(begin, end, begin, turned);
    }

    Vec2 from_m_;
    Lanes& lanes_;
    Vec2 to_m_;
};

} // namespace

mapping::Lane turned(mapping::Lane lane) {
    std::swap(lane.start_m, lane.end_m);
    return lane;
}

double detour_m(const Vec2& from_m, const Lanes& lanes, const Vec2& to_m, const mapping::Lane& lane) {
    double least_m = std::numeric_limits<double>::infinity();
    Vec2 before_m = from_m;
    for (std::size_t place = 0; place <= lanes.size(); ++place) {
        const Vec2& after_m = place < lanes.size() ? lanes[place].start_m : to_m;
        least_m = std::min({least_m, waysTo_m(before_m, lane, after_m), waysTo_m(before_m, turned(lane), after_m)});
        before_m = place < lanes.size() ? lanes[place].end_m : to_m;
    }
    return least_m + turns_m;
}

void orderFrom(Vec2 from_m, Lanes& lanes) {
    for (auto next = lanes.begin(); next != lanes.end(); ++next) {
        const auto away_m = [&](const mapping::Lane& lane) {
            return std::min((lane.start_m - from_m).norm(), (lane.end_m - from_m).norm());
        };
        std::iter_swap(next, std::ranges::min_element(next, lanes.end(), {}, away_m));
        if ((next->end_m - from_m).norm() < (next->start_m - from_m).norm())
            std::swap(next->start_m, next->end_m);
        from_m = next->end_m;
    }
}

double lengthOf_m(const std::vector<mapping::Lane>& lanes) {
    return std::accumulate(lanes.begin(), lanes.end(), 0.0, [](double sum_m, const mapping::Lane& lane) {
        return sum_m + (lane.end_m - lane.start_m).norm();
    });
}

double waysBetween_m(const Vec2& from_m, const Lanes& lanes, const Vec2& to_m) {
    double way_m = 0.0;
    Vec2 here_m = from_m;
    for (const mapping::Lane& lane : lanes) {
        way_m += (lane.start_m - here_m).norm();
        here_m = lane.end_m;
    }
    return way_m + (to_m - here_m).norm();
}

void orderTour(const Vec2& from_m, Lanes& lanes, const Vec2& to_m) {
    orderFrom(from_m, lanes);
    Tour tour(from_m, lanes, to_m);
    bool shortened = true;
    while (shortened) {
        shortened = tour.turnPieces();
        shortened = tour.moveLanes() || shortened;
    }
}

} // namespace usar::airrobot
