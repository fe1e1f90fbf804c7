#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <QTest>

#include "core/base/random.h"
#include "robots/airrobot/lane_order.h"
#include "tests/suite/suite.h"

namespace tst_lane_order {

using namespace usar;
using namespace usar::airrobot;
using Lanes = std::vector<mapping::Lane>;

namespace {

Lanes randomLanes(Random& random, int count) {
    Lanes lanes;
    const auto place = [&] { return Vec2(uniform(random, -100.0, 100.0), uniform(random, -100.0, 100.0)); };
    for (int i = 0; i < count; ++i)
        lanes.push_back({place(), place(), 0});
    return lanes;
}

/// Both ends of each lane, whichever comes first, in a fixed order.
std::vector<std::array<double, 4>> ends(const Lanes& lanes) {
    std::vector<std::array<double, 4>> all;
    for (const mapping::Lane& lane : lanes) {
        std::array<double, 4> one{lane.start_m.x(), lane.start_m.y(), lane.end_m.x(), lane.end_m.y()};
        const std::array<double, 4> other{one[2], one[3], one[0], one[1]};
        all.push_back(std::min(one, other));
    }
    std::ranges::sort(all);
    return all;
}

/// The shortest of all orders and directions.
double shortest_m(const Vec2& from_m, const Lanes& lanes, const Vec2& to_m) {
    std::vector<std::size_t> order(lanes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double least_m = std::numeric_limits<double>::infinity();
    do
        for (unsigned turned = 0; turned < 1U << lanes.size(); ++turned) {
            Lanes tour;
            for (const std::size_t i : order) {
                tour.push_back(lanes[i]);
                if (turned >> i & 1U)
                    std::swap(tour.back().start_m, tour.back().end_m);
            }
            least_m = std::min(least_m, waysBetween_m(from_m, tour, to_m));
        }
    while (std::ranges::next_permutation(order).found);
    return least_m;
}

} // namespace

class tst_LaneOrder : public QObject {
    Q_OBJECT
private slots:
    void waysAreThoseWithoutTheLanes() {
        QCOMPARE(waysBetween_m({0, 0}, {{{0, 3}, {4, 3}, 0}, {{4, 5}, {0, 5}, 0}}, {0, 0}), 3.0 + 2.0 + 5.0);
        QCOMPARE(waysBetween_m({1, 0}, {}, {1, 7}), 7.0);
    }

    /// Where the nearest end comes first, the lane on the left is left for the end, and the way back is long.
    void aTourDoesNotLeaveTheFarthestForTheEnd() {
        const Lanes lanes{{{-30, 0}, {-30, 10}, 0}, {{10, 0}, {10, 10}, 0}, {{40, 10}, {40, 0}, 0}};
        Lanes nearest = lanes, tour = lanes;
        orderFrom({0, 0}, nearest);
        orderTour({0, 0}, tour, {60, 0});
        QCOMPARE(tour.front().start_m.x(), -30.0);
        QVERIFY(waysBetween_m({0, 0}, tour, {60, 0}) < 0.7 * waysBetween_m({0, 0}, nearest, {60, 0}));
    }

    void fewLanesAreNearlyInTheBestOrder_data() {
        QTest::addColumn<int>("count");
        for (const int count : {0, 1, 2, 3, 5})
            QTest::addRow("%d lanes", count) << count;
    }
    void fewLanesAreNearlyInTheBestOrder() {
        QFETCH(int, count);
        Random random = seeded(7, static_cast<std::uint64_t>(count));
        double all_m = 0.0, best_m = 0.0;
        for (int i = 0; i < 20; ++i) {
            Lanes lanes = randomLanes(random, count);
            const double least_m = shortest_m({0, 0}, lanes, {50, 0});
            orderTour({0, 0}, lanes, {50, 0});
            const double way_m = waysBetween_m({0, 0}, lanes, {50, 0});
            QVERIFY2(way_m < 1.25 * least_m + 1e-9, qPrintable(QString("%1 m, %2 m").arg(way_m).arg(least_m)));
            all_m += way_m;
            best_m += least_m;
        }
        QVERIFY(all_m < 1.05 * best_m + 1e-9);
    }

    /// Lanes 30 m long and 20 m apart, from 10 m beside the base on. Turns count 5 m for each lane.
    void aFlightGoesHomeForCharges_data() {
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("full_m");
        QTest::addColumn<double>("way_m"); // of two lanes up and down: 10 + 30 + 20 + 30 + 30
        QTest::newRow("not at all") << 1000.0 << 1000.0 << 120.0 + 10.0;
        QTest::newRow("just not") << 120.1 << 1000.0 << 120.0 + 10.0;
        QTest::newRow("before the second lane")
            << 100.0 << 1000.0 << 10.0 + 30.0 + std::hypot(10.0, 30.0) + 200.0 + std::hypot(30.0, 30.0) + 60.0 + 10.0;
        QTest::newRow("first of all") << 5.0 << 1000.0 << 200.0 + 120.0 + 10.0;
        QTest::newRow("never, because a full battery does not last either") << 5.0 << 6.0 << 0.0;
        QTest::newRow("never, and its length is no round number") << 5.0 << 38.095 / 5.0 << 0.0;
    }
    void aFlightGoesHomeForCharges() {
        QFETCH(double, left_m);
        QFETCH(double, full_m);
        QFETCH(double, way_m);
        const Lanes lanes{{{10, 0}, {10, 30}, 0}, {{30, 30}, {30, 0}, 0}};
        const double flown_m = flight_m({0, 0}, lanes, {0, 0}, {left_m, full_m, 200.0});
        if (way_m > 0.0)
            QVERIFY2(std::abs(flown_m - way_m) < 0.01, qPrintable(QString::number(flown_m)));
        QVERIFY(flown_m < 2000.0);
    }

    /// It breaks off a lane where the battery lasts just for the way home, and resumes it there.
    void aLaneIsBrokenOff() {
        const Lanes lanes{{{0, 0}, {100, 0}, 0}};
        const double flown_m = flight_m({0, 0}, lanes, {0, 0}, {100.0, 1000.0, 0.0});
        QVERIFY2(std::abs(flown_m - (50.0 + 50.0 + 50.0 + 50.0 + 100.0 + 5.0)) < 0.01,
                 qPrintable(QString::number(flown_m)));
    }

    void flightsAreOrderedByTheirBattery() {
        Random random = seeded(9, 0);
        const Endurance endurance{150.0, 500.0, 140.0};
        double tours_m = 0.0, flights_m = 0.0;
        for (int count = 1; count <= 16; ++count) {
            const Lanes lanes = randomLanes(random, count);
            Lanes tour = lanes, flight = lanes;
            orderTour({0, 0}, tour, {0, 0});
            orderFlights({0, 0}, flight, {0, 0}, endurance);
            QCOMPARE(ends(flight), ends(lanes));
            const double tour_m = flight_m({0, 0}, tour, {0, 0}, endurance);
            const double way_m = flight_m({0, 0}, flight, {0, 0}, endurance);
            QVERIFY(way_m <= tour_m + 1e-9);
            tours_m += tour_m;
            flights_m += way_m;
        }
        QVERIFY2(flights_m < 0.99 * tours_m, qPrintable(QString::number(flights_m / tours_m)));
    }

    void noLaneIsLostAndNoTourIsLonger() {
        Random random = seeded(8, 0);
        double nearest_m = 0.0, tour_m = 0.0;
        for (int count = 1; count <= 60; ++count) {
            const Lanes lanes = randomLanes(random, count);
            Lanes nearest = lanes, tour = lanes;
            orderFrom({0, 0}, nearest);
            orderTour({0, 0}, tour, {0, 0});
            QCOMPARE(ends(tour), ends(lanes));
            QCOMPARE(ends(nearest), ends(lanes));
            const double before_m = waysBetween_m({0, 0}, nearest, {0, 0});
            const double after_m = waysBetween_m({0, 0}, tour, {0, 0});
            QVERIFY(after_m <= before_m + 1e-9);
            nearest_m += before_m;
            tour_m += after_m;
        }
        QVERIFY2(tour_m < 0.9 * nearest_m, qPrintable(QString::number(tour_m / nearest_m)));
    }
};

USAR_TEST(tst_LaneOrder)

} // namespace tst_lane_order

#include "tst_lane_order.moc"
