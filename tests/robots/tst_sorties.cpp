#include <cmath>

#include <QTest>

#include "robots/airrobot/sorties.h"
#include "tests/robots/random_lanes.h"
#include "tests/suite/suite.h"

namespace tst_sorties {

using namespace usar;
using namespace usar::airrobot;

class tst_Sorties : public QObject {
    Q_OBJECT
private slots:
    /// Lanes 30 m long and 20 m apart, from 10 m beside the base on. Turns count 5 m for each lane.
    void aFlightGoesHomeForCharges_data() {
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("full_m");
        QTest::addColumn<double>("way_m"); // of two lanes up and down: 10 + 30 + 20 + 30 + 30
        QTest::newRow("not at all") << 1000.0 << 1000.0 << 120.0 + 10.0;
        QTest::newRow("just not") << 120.1 << 1000.0 << 120.0 + 10.0;
        QTest::newRow("first of all, though it lasts for one lane") << 100.0 << 1000.0 << 200.0 + 120.0 + 10.0;
        QTest::newRow("first of all") << 5.0 << 1000.0 << 200.0 + 120.0 + 10.0;
        QTest::newRow("before the second lane")
            << 105.0 << 105.0
            << 10.0 + 30.0 + std::hypot(10.0, 30.0) + 200.0 + std::hypot(30.0, 30.0) + 30.0 + 30.0 + 10.0;
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
        else
            QVERIFY(flown_m > 1e6 && flown_m < 1e7); // No plan with a lane that is out of reach is short.
    }

    /// It breaks off a lane where the battery lasts just for the way home, and resumes it there: at (100, y), where
    /// 1100 m are the ways to the start, from there to this place, and home.
    void aLaneIsBrokenOff() {
        const Lanes lanes{{{100, -400}, {100, 400}, 0}};
        const double flown_m = flight_m({0, 0}, lanes, {0, 0}, {1100.0, 1100.0, 10.0});
        const double to_start_m = std::hypot(100.0, 400.0), left_m = 1100.0 - to_start_m;
        const double along_m = (left_m * left_m - to_start_m * to_start_m) / (2.0 * (left_m - 400.0));
        const double home_m = left_m - along_m;
        const double all_m = to_start_m + 800.0 + to_start_m + 2.0 * home_m + 10.0 + 5.0;
        QVERIFY2(std::abs(flown_m - all_m) < 0.01, qPrintable(QString("%1, not %2").arg(flown_m).arg(all_m)));
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

    /// A lane beside the base, one far away, and one at the base again: the battery would last for half of the far one.
    void goesHomeBetweenLanesIfThatIsShorter() {
        Lanes lanes{{{5, 0}, {5, 40}}, {{5, 45}, {5, 1}}, {{100, 0}, {160, 0}}};
        const Endurance endurance{350.0, 350.0, 10.0};
        const double all_m = divideIntoSorties({0, 0}, lanes, {0, 0}, endurance);
        QCOMPARE(lanes[0].sortie, 0);
        QCOMPARE(lanes[1].sortie, 0);
        QCOMPARE(lanes[2].sortie, 1);
        QVERIFY2(std::abs(all_m - (5.0 + 40.0 + 5.0 + 44.0 + std::hypot(5.0, 1.0) + 10.0 + 320.0 + 15.0)) < 0.01,
                 qPrintable(QString::number(all_m)));
    }

    /// It does not set out for a lane that it cannot reach.
    void aSortieEndsBeforeALaneOutOfReach() {
        Lanes lanes{{{10, 0}, {10, 30}}, {{30, 30}, {30, 0}}};
        divideIntoSorties({0, 0}, lanes, {0, 0}, {85.0, 105.0, 200.0});
        QCOMPARE(lanes[0].sortie, 0);
        QCOMPARE(lanes[1].sortie, 1);
    }

    void chargesFirstIfTheBatteryIsNearlyEmpty() {
        Lanes lanes{{{30, 0}, {30, 40}}, {{50, 40}, {50, 0}}};
        divideIntoSorties({10, 0}, lanes, {0, 0}, {70.0, 500.0, 10.0});
        QCOMPARE(lanes[0].sortie, 1);
        QCOMPARE(lanes[1].sortie, 1);
    }

    void noDivisionByHandIsShorter() {
        Random random = seeded(11, 0);
        const Endurance fresh{500.0, 500.0, 80.0};
        int divided = 0;
        for (int trial = 0; trial < 200; ++trial) {
            const auto count = static_cast<std::size_t>(1 + trial % 6);
            Lanes lanes = randomLanes(random, static_cast<int>(count));
            const double least_m = divideIntoSorties({0, 0}, lanes, {0, 0}, fresh);
            divided += lanes.back().sortie > 0 ? 1 : 0;
            QVERIFY(std::abs(least_m - flight_m({0, 0}, lanes, {0, 0}, fresh)) < 1e-9);
            for (unsigned homes = 0; homes < 1U << (count - 1); ++homes) {
                double by_hand_m = 0.0;
                Lanes sortie;
                for (std::size_t i = 0; i < count; ++i) {
                    sortie.push_back(lanes[i]);
                    const bool last = i + 1 == count;
                    if (!last && !(homes >> i & 1U))
                        continue;
                    by_hand_m += flight_m({0, 0}, sortie, {0, 0}, fresh) + (last ? 0.0 : fresh.charge_m);
                    sortie.clear();
                }
                QVERIFY(least_m <= by_hand_m + 1e-9);
            }
        }
        QVERIFY2(divided > 50, qPrintable(QString::number(divided)));
    }

    void aGreaterBatteryNeverMakesTheFlightLonger() {
        Random random = seeded(12, 0);
        for (int trial = 0; trial < 50; ++trial) {
            const Lanes lanes = randomLanes(random, 8);
            double before_m = std::numeric_limits<double>::infinity();
            for (const double full_m : {450.0, 600.0, 900.0, 5000.0}) {
                const double all_m = flight_m({0, 0}, lanes, {0, 0}, {full_m, full_m, 100.0});
                QVERIFY2(all_m < before_m + 1e-9, qPrintable(QString("%1 m: %2").arg(full_m).arg(all_m)));
                before_m = all_m;
            }
            double lanes_m = 0.0;
            for (const mapping::Lane& lane : lanes)
                lanes_m += (lane.end_m - lane.start_m).norm() + turns_m;
            QVERIFY(std::abs(before_m - lanes_m - waysBetween_m({0, 0}, lanes, {0, 0})) < 1e-6);
        }
    }
};

USAR_TEST(tst_Sorties)

} // namespace tst_sorties

#include "tst_sorties.moc"
