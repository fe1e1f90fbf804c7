#include "robots/airrobot/sorties.h"

#include <algorithm>
#include <utility>

#include "robots/airrobot/flight/battery_model.h"

namespace usar::airrobot {

namespace {

using Lanes = std::vector<mapping::Lane>;

constexpr double least_gain_m = 1e-6; ///< A smaller gain may be one of rounding, and the search would not end.
constexpr double least_piece_m = 1.0; ///< A full battery that lasts for less of a lane is no help.
constexpr double landing_and_take_off_s = 45.0;
constexpr double out_of_reach_m = 1e6;
/// The search ends after so many orders: 40 lanes take 25 us each, and a behavior may not think for long.
constexpr int most_orders = 8000;
/// A sortie that breaks off more lanes than this is hardly shorter than one that went home between lanes.
constexpr int most_breaks = 2;

/// A flight in thought that goes home whenever it must.
class BatteryFlight {
public:
    BatteryFlight(const Vec2& from_m, const Vec2& home_m, const Endurance& endurance)
        : here_m_(from_m)
        , home_m_(home_m)
        , endurance_(endurance)
        , left_m_(endurance.left_m) {}

    void fly(const mapping::Lane& lane) {
        flyTo(lane.start_m);
        scanTo(lane.end_m);
        flown_m_ += turns_m;
    }
    double landed_m() const { return flown_m_ + (home_m_ - here_m_).norm(); } ///< if it goes home now
    int charges() const { return charges_; }
    /// Whether it gets there without a charge.
    bool reaches(const Vec2& place_m) const {
        return left_m_ >= (place_m - here_m_).norm() + (home_m_ - place_m).norm();
    }

private:
    void flyTo(const Vec2& place_m) {
        if (!reaches(place_m))
            charge();
        go(place_m);
    }
    void scanTo(const Vec2& end_m) {
        bool charged = false;
        while (!reaches(end_m)) {
            const double piece_m = pieceTo_m(end_m);
            if (charged && piece_m < least_piece_m) {
                flown_m_ += out_of_reach_m;
                break;
            }
            const Vec2 break_m = here_m_ + piece_m * (end_m - here_m_).normalized();
            go(break_m);
            charge();
            go(break_m);
            charged = true;
        }
        go(end_m);
    }
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
        ++charges_;
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
    int charges_ = 0;
};

/// The best division of lanes into sorties: the shortest path from lane to lane, in which each step is a sortie.
class Division {
public:
    Division(const Vec2& from_m, const Vec2& home_m, const Endurance& endurance)
        : from_m_(from_m)
        , home_m_(home_m)
        , endurance_(endurance)
        , fresh_{endurance.full_m, endurance.full_m, endurance.charge_m, endurance.breaks_off} {}

    /// Divides the lanes in this order; returns the length of all.
    double divide(const Lanes& lanes) {
        constexpr double never_m = std::numeric_limits<double>::infinity();
        stops_.assign(lanes.size() + 1, {never_m, none});
        addSorties(lanes, 0, BatteryFlight(from_m_, home_m_, endurance_), 0.0, none);
        if (whole_ || lanes.empty())
            return stops_.back().flown_m;
        offer(stops_.front(), (home_m_ - from_m_).norm() + endurance_.charge_m, none);
        for (std::size_t first = 0; first < lanes.size(); ++first)
            addSorties(lanes, first, BatteryFlight(home_m_, home_m_, fresh_), stops_[first].flown_m, first);
        return stops_.back().flown_m;
    }
    /// The first lanes of the sorties after the first one, in ascending order.
    std::vector<std::size_t> beginnings() const {
        std::vector<std::size_t> firsts;
        for (std::size_t at = stops_.back().first; at != none; at = stops_[at].first)
            firsts.push_back(at);
        std::ranges::reverse(firsts);
        return firsts;
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    /// After so many lanes as its index, the robot is home and charged; after the last one, it has landed for good.
    struct Stop {
        double flown_m;
        std::size_t first; ///< lane of the sortie that ends here; `none` if that began at `from_m_`
    };

    static void offer(Stop& stop, double flown_m, std::size_t first) {
        if (flown_m < stop.flown_m)
            stop = {flown_m, first};
    }
    void addSorties(const Lanes& lanes, std::size_t first, BatteryFlight flight, double before_m,
                    std::size_t beginning) {
        std::size_t last = first;
        for (; last < lanes.size() && flight.charges() <= most_breaks; ++last) {
            if (last > first && !flight.reaches(lanes[last].start_m))
                break; // It has to go home before this lane.
            BatteryFlight on = flight;
            on.fly(lanes[last]);
            if (last > first && !endurance_.breaks_off && on.charges() > flight.charges())
                break;
            flight = on;
            const double charge_m = last + 1 < lanes.size() ? endurance_.charge_m : 0.0;
            offer(stops_[last + 1], before_m + flight.landed_m() + charge_m, beginning);
        }
        whole_ = beginning == none && last == lanes.size() && flight.charges() == 0;
    }

    Vec2 from_m_;
    Vec2 home_m_;
    Endurance endurance_;
    Endurance fresh_; ///< after a charge
    std::vector<Stop> stops_;
    bool whole_ = false; ///< One battery lasts for all, and a charge would only cost.
};

/// Changes the order for as long as that makes the flight shorter.
class FlightSearch {
public:
    FlightSearch(const Vec2& from_m, Lanes& lanes, const Vec2& home_m, const Endurance& endurance)
        : lanes_(lanes)
        , division_(from_m, home_m, endurance)
        , least_m_(division_.divide(lanes)) {}

    /// Turns around pieces (2-opt). Returns whether that shortened the flight; so does `moveLanes`.
    bool turnPieces() {
        bool shortened = false;
        for (std::size_t first = 0; first < lanes_.size() && orders_ < most_orders; ++first)
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

    /// Moves single lanes to other places (relocation), in either direction.
    bool moveLanes() {
        bool shortened = false;
        for (std::size_t i = 0; i < lanes_.size() && orders_ < most_orders; ++i)
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
    /// Takes an order that is shorter than the present one.
    bool take(const Lanes& other) {
        ++orders_;
        const double other_m = division_.divide(other);
        if (other_m > least_m_ - least_gain_m)
            return false;
        least_m_ = other_m;
        lanes_ = other;
        return true;
    }

    Lanes& lanes_;
    Division division_;
    double least_m_;
    int orders_ = 0; ///< that were tried
};

} // namespace

Endurance enduranceOf(const Settings& settings, double since_charge_m, double detour) {
    const double full_m = usableRange_m(settings);
    return {(full_m - since_charge_m) / detour, full_m / detour,
            settings.transit_speed_m_s * (settings.recharge_time_s + landing_and_take_off_s)};
}

double flight_m(const Vec2& from_m, const Lanes& lanes, const Vec2& home_m, const Endurance& endurance) {
    return lanes.empty() ? (home_m - from_m).norm() : Division(from_m, home_m, endurance).divide(lanes);
}

double divideIntoSorties(const Vec2& from_m, Lanes& lanes, const Vec2& home_m, const Endurance& endurance) {
    if (lanes.empty())
        return (home_m - from_m).norm();
    Division division(from_m, home_m, endurance);
    const double all_m = division.divide(lanes);
    const std::vector<std::size_t> beginnings = division.beginnings();
    for (std::size_t i = 0; i < lanes.size(); ++i)
        lanes[i].sortie = static_cast<int>(std::ranges::upper_bound(beginnings, i) - beginnings.begin());
    return all_m;
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

} // namespace usar::airrobot
