#include <algorithm>
#include <limits>
#include <numeric>

#include <QTest>

#include "robots/airrobot/lane_order.h"
#include "tests/robots/random_lanes.h"
#include "tests/suite/suite.h"

namespace tst_lane_order {

using namespace usar;
using namespace usar::airrobot;

namespace {

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
