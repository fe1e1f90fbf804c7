#include "robots/airrobot/lane_order.h"

#include <algorithm>
#include <utility>

namespace usar::airrobot {

namespace {

using Lanes = std::vector<mapping::Lane>;

constexpr double worth_a_change_m = 1e-6; ///< A smaller gain may be one of rounding, and the search would not end.

mapping::Lane turned(mapping::Lane lane) {
    std::swap(lane.start_m, lane.end_m);
    return lane;
}

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

constexpr double turns_m = 5.0;       ///< What a robot could fly while it turns at both ends of a lane.
constexpr double least_piece_m = 1.0; ///< A full battery that lasts for less of a lane is no help.

/// A flight in thought that goes home whenever it must.
class BatteryFlight {
public:
    BatteryFlight(const Vec2& from_m, const Vec2& home_m, const Endurance& endurance)
        : here_m_(from_m)
        , home_m_(home_m)
        , endurance_(endurance)
        , left_m_(endurance.left_m) {}

    void flyTo(const Vec2& place_m) {
        if (left_m_ < (place_m - here_m_).norm() + (home_m_ - place_m).norm())
            charge();
        go(place_m);
    }

    void scanTo(const Vec2& end_m) {
        bool charged = false;
        while (left_m_ < (end_m - here_m_).norm() + (home_m_ - end_m).norm()) {
            const double piece_m = pieceTo_m(end_m);
            if (charged && piece_m < least_piece_m)
                break; // It is out of reach anyway.
            const Vec2 break_m = here_m_ + piece_m * (end_m - here_m_).normalized();
            go(break_m);
            charge();
            go(break_m);
            charged = true;
        }
        go(end_m);
    }

    double land() {
        go(home_m_);
        return flown_m_;
    }
    void turn() { flown_m_ += turns_m; }

private:
    void go(const Vec2& place_m) {
        const double way_m = (place_m - here_m_).norm();
        flown_m_ += way_m;
        left_m_ -= way_m;
        here_m_ = place_m;
    }
    void charge() {
        go(home_m_);
        flown_m_ += endurance_.charge_m;
        left_m_ = endurance_.full_m;
    }
    /// How far it gets on the way to `end_m` before it must go home: left - s = |here + s along - home|.
    double pieceTo_m(const Vec2& end_m) const {
        const Vec2 off_m = here_m_ - home_m_;
        const double per_m = left_m_ + off_m.dot((end_m - here_m_).normalized());
        return per_m > 0.0 ? std::max(0.0, (left_m_ * left_m_ - off_m.squaredNorm()) / (2.0 * per_m)) : 0.0;
    }

    Vec2 here_m_;
    Vec2 home_m_;
    Endurance endurance_;
    double left_m_;
    double flown_m_ = 0.0;
};

/// Changes the order for as long as that makes the flight shorter.
class FlightSearch {
public:
    FlightSearch(const Vec2& from_m, Lanes& lanes, const Vec2& home_m, const Endurance& endurance)
        : from_m_(from_m)
        , lanes_(lanes)
        , home_m_(home_m)
        , endurance_(endurance)
        , least_m_(length_m(lanes)) {}

    bool turnPieces() {
        bool shortened = false;
        for (std::size_t first = 0; first < lanes_.size(); ++first)
            for (std::size_t last = first; last < lanes_.size(); ++last) {
                Lanes other = lanes_;
                const auto begin = other.begin() + static_cast<std::ptrdiff_t>(first);
                const auto end = other.begin() + static_cast<std::ptrdiff_t>(last) + 1;
                std::reverse(begin, end);
                std::transform(begin, end, begin, turned);
                shortened = take(other) || shortened;
            }
        return shortened;
    }

    bool moveLanes() {
        bool shortened = false;
        for (std::size_t i = 0; i < lanes_.size(); ++i)
            for (std::size_t place = 0; place < lanes_.size(); ++place)
                for (const bool turn : {false, true}) {
                    Lanes other = lanes_;
                    const mapping::Lane lane = turn ? turned(other[i]) : other[i];
                    other.erase(other.begin() + static_cast<std::ptrdiff_t>(i));
                    other.insert(other.begin() + static_cast<std::ptrdiff_t>(place), lane);
                    shortened = take(other) || shortened;
                }
        return shortened;
    }

private:
    double length_m(const Lanes& lanes) const { return flight_m(from_m_, lanes, home_m_, endurance_); }
    /// Takes an order that is shorter than the present one.
    bool take(const Lanes& other) {
        const double other_m = length_m(other);
        if (other_m > least_m_ - worth_a_change_m)
            return false;
        least_m_ = other_m;
        lanes_ = other;
        return true;
    }

    Vec2 from_m_;
    Lanes& lanes_;
    Vec2 home_m_;
    Endurance endurance_;
    double least_m_;
};

} // namespace

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

double flight_m(const Vec2& from_m, const Lanes& lanes, const Vec2& home_m, const Endurance& endurance) {
    BatteryFlight flight(from_m, home_m, endurance);
    for (const mapping::Lane& lane : lanes) {
        flight.flyTo(lane.start_m);
        flight.scanTo(lane.end_m);
        flight.turn();
    }
    return flight.land();
}

void orderFlights(const Vec2& from_m, Lanes& lanes, const Vec2& home_m, const Endurance& endurance) {
    orderTour(from_m, lanes, home_m);
    improveFlights(from_m, lanes, home_m, endurance);
}

void improveFlights(const Vec2& from_m, Lanes& lanes, const Vec2& home_m, const Endurance& endurance) {
    if (lanes.size() > few_lanes)
        return;
    FlightSearch search(from_m, lanes, home_m, endurance);
    bool shortened = true;
    while (shortened) {
        shortened = search.turnPieces();
        shortened = search.moveLanes() || shortened;
    }
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
