#include <cmath>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/obstacle_memory.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_obstacle_memory {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_ObstacleMemory : public QObject {
    Q_OBJECT

    const MemorySpans spans{Seconds(100.0), Seconds(10.0)};

private slots:
    void keepsTheHighestHitOfACell() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(3.1, 0.1, 2.0), Vec3(3.2, 0.2, 4.0), Vec3(3.3, 0.3, 1.0)}};
        memory.take(senses, spans);
        QCOMPARE(*memory.highest_m({3.25, 0.25}, 0.3), 4.0);
    }

    void reportsWhatReachesTheLevel() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(3, 0, 5.5), Vec3(0, 3, 2.0), Vec3(0, 30, 9.0)}};
        memory.take(senses, spans);
        const auto near = memory.near({0, 0}, 8.0, 4.8);
        QCOMPARE(near.size(), std::size_t(1));
        QVERIFY(near[0].top_known);
        QVERIFY((near[0].at_m - Vec2(3.25, 0.25)).norm() < 1e-9);
    }

    /// Level ground is flown over at 0 s, and again later, when the estimate of the height is another one.
    void tellsHowFarTheHeightHasDrifted_data() {
        QTest::addColumn<double>("again_s");
        QTest::addColumn<double>("risen_m");
        QTest::addColumn<double>("half_size_m"); // of the ground that is seen again
        QTest::addColumn<double>("asked_s");
        QTest::addColumn<double>("told_m");
        QTest::newRow("up") << 60.0 << 1.8 << 3.0 << 60.0 << 1.8;
        QTest::newRow("down") << 60.0 << -0.7 << 3.0 << 60.0 << -0.7;
        QTest::newRow("on the same flight") << 10.0 << 1.8 << 3.0 << 10.0 << 0.0;
        QTest::newRow("seen of a few cells only") << 60.0 << 1.8 << 1.0 << 60.0 << 0.0;
        QTest::newRow("seconds ago") << 60.0 << 1.8 << 3.0 << 89.0 << 1.8;
        QTest::newRow("elsewhere by now") << 60.0 << 1.8 << 3.0 << 91.0 << 0.0;
    }
    void tellsHowFarTheHeightHasDrifted() {
        QFETCH(double, again_s);
        QFETCH(double, risen_m);
        QFETCH(double, half_size_m);
        QFETCH(double, asked_s);
        QFETCH(double, told_m);
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 0.0);
        setFlatScan(senses, {0, 0}, 4.0, 1.0);
        memory.take(senses, spans);
        senses = sensesAt({0, 0, 6}, 0.0, again_s);
        setFlatScan(senses, {0, 0}, half_size_m, 1.0 + risen_m);
        // Crowns that were not seen before, on less than half of it.
        for (std::size_t i = 0; i < senses.scan->hits_in_map_m.size(); i += 3)
            senses.scan->hits_in_map_m[i].z() += 5.0;
        memory.take(senses, spans);
        if (asked_s > again_s)
            memory.take(sensesAt({0, 0, 6}, 0.0, asked_s), spans);
        QVERIFY2(std::abs(memory.risen_m() - told_m) < 0.01, qPrintable(QString::number(memory.risen_m())));
        const auto tops_m = memory.risenTops_m({3.75, 3.75}, 0.2); // a cell that is not seen again
        QCOMPARE(tops_m.size(), std::size_t(1));
        const bool long_ago =
            asked_s - again_s > 30.0; // A robot that lands there hovers longer than it believes its way.
        QVERIFY(std::abs(tops_m[0].z() - 1.0 - (long_ago ? risen_m : told_m)) < 0.01);
        MemorySpans room = spans;
        room.in_room = true;
        memory.take(sensesAt({0, 0, 6}, 0.0, asked_s), room);
        QCOMPARE(memory.risen_m(), 0.0);
        memory.clear();
        QCOMPARE(memory.risen_m(), 0.0);
    }

    void forgetsAfterItsTime() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 100.0);
        setFlatScan(senses, {0, 0}, 2.0, 3.0);
        setSonars(senses, {{"M0", 3.0}});
        memory.take(senses, spans);
        QCOMPARE(memory.near({0, 0}, 8.0, 5.0).size(), std::size_t(1));
        memory.take(sensesAt({0, 0, 6}, 0.0, 115.0), spans);
        QVERIFY(memory.near({0, 0}, 8.0, 5.0).empty()); // the echo went first
        QVERIFY(memory.highest_m({0, 0}, 1.0));
        memory.take(sensesAt({0, 0, 6}, 0.0, 201.0), spans);
        QVERIFY(!memory.highest_m({0, 0}, 1.0));
    }

    /// A scan that was placed wrong, from far aside, and another one of the same ground and of some more.
    void keepsOnlyWhatIsFresh() {
        ObstacleMemory memory;
        Senses wrong = sensesAt({0, 0, 6}, 0.0, 100.0);
        setFlatScan(wrong, {0, 0}, 3.0, 1.5);
        setSonars(wrong, {{"M0", 3.0}});
        memory.take(wrong, {});
        Senses right = sensesAt({0, 0, 3}, 0.0, 115.0);
        setFlatScan(right, {0, 0}, 1.0, 0.1);
        memory.take(right, {});
        QCOMPARE(*memory.highest_m({0, 0}, 0.5), 1.5);
        memory.keepFresh(Seconds(10.0));
        QVERIFY(std::abs(*memory.highest_m({0, 0}, 0.5) - 0.1) < 1e-6);
        QVERIFY(!memory.highest_m({2.5, 0}, 0.2));
        QVERIFY(memory.near({0, 0}, 8.0, 5.0).empty()); // the echo
    }

    void replacesWhatIsForgottenByWhatIsLower() {
        ObstacleMemory memory;
        Senses high = sensesAt({0, 0, 6}, 0.0, 0.0);
        setFlatScan(high, {0, 0}, 1.0, 5.0);
        memory.take(high, spans);
        Senses low = sensesAt({0, 0, 6}, 0.0, 150.0);
        setFlatScan(low, {0, 0}, 1.0, 1.0);
        memory.take(low, spans);
        QCOMPARE(*memory.highest_m({0, 0}, 0.5), 1.0);
    }

    void rollsWithTheRobot() {
        ObstacleMemory memory;
        const double far_m = ObstacleMemory::cell_m * ObstacleMemory::side;
        Senses senses = sensesAt({0, 0, 6});
        setFlatScan(senses, {0, 0}, 1.0, 5.0);
        memory.take(senses, spans);
        setFlatScan(senses, {far_m, 0}, 1.0, 2.0);
        memory.take(senses, spans);
        QVERIFY(!memory.highest_m({0, 0}, 0.5)); // overwritten, not confused
        QCOMPARE(*memory.highest_m({far_m, 0}, 0.5), 2.0);
    }

    void dropsAnEchoThatALaterBeamPassesThrough() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 100.0);
        setSonars(senses, {{"M0", 2.0}});
        memory.take(senses, spans);
        QCOMPARE(memory.near({0, 0}, 8.0, 5.0).size(), std::size_t(1));
        senses.now = Seconds(100.2);
        setSonars(senses, {{"M0", 4.5}});
        memory.take(senses, spans);
        const auto near = memory.near({0, 0}, 8.0, 5.0);
        QCOMPARE(near.size(), std::size_t(1));
        QVERIFY(near[0].at_m.x() > 4.5);
    }

    /// A robot that flies against the wind leans forward, and its beams end below what is before it (survey 131616).
    void takesWhatALeaningRobotHearsForAsHighAsTheRobot() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.base_in_map.pitch_rad = 0.3;
        setSonars(senses, {{"M0", 4.0}});
        QVERIFY(senses.sonars.at(4).hit && senses.sonars.at(4).high_m < 5.5);
        memory.take(senses, spans);
        QCOMPARE(memory.near({0, 0}, 8.0, 5.5).size(), std::size_t(1));
        QCOMPARE(memory.near({0, 0}, 8.0, 6.5).size(), std::size_t(0));
    }

    /// As flown in `tall_test` at 2 m/s: a crown's top was heard 3.8 m ahead, and a beam from 1.5 m passed over it.
    void keepsWhatANearerBeamPassesOver_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("z_m");
        QTest::addColumn<bool>("lower_parts");
        QTest::addColumn<bool>("kept");
        QTest::newRow("as high, as far: the beam was there") << 0.2 << 6.0 << true << false;
        QTest::newRow("as high, nearer") << 2.5 << 6.0 << true << true;
        QTest::newRow("lower, nearer: the beam was there") << 2.5 << 5.6 << true << false;
        QTest::newRow("higher, nearer") << 2.5 << 6.3 << true << true;
        QTest::newRow("as high, nearer, where things have no tips") << 2.5 << 6.0 << false << false;
    }
    void keepsWhatANearerBeamPassesOver() {
        QFETCH(double, x_m);
        QFETCH(double, z_m);
        QFETCH(bool, lower_parts);
        QFETCH(bool, kept);
        ObstacleMemory memory;
        MemorySpans here = spans;
        here.lower_parts = lower_parts;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 100.0);
        setSonars(senses, {{"M0", 3.8}});
        memory.take(senses, here);
        Senses later = sensesAt({x_m, 0, z_m}, 0.0, 102.0);
        setSonars(later, {});
        for (int beam = 0; beam < 4; ++beam)
            memory.take(later, here);
        const auto near = memory.near({x_m, 0}, 8.0, 4.5);
        QCOMPARE(!near.empty(), kept);
        if (kept) // It is no higher than the beam's lower edge there.
            QVERIFY(near[0].top_m < z_m && near[0].top_m > z_m - 0.6);
    }

    /// The tip of a crown, of which a sonar heard one echo, overturned a robot that had then looked past it twice
    /// (`square_kilometer`, seed 1, by C++).
    void takesTwoSilentBeamsForNoProofThatATipIsGone_data() {
        QTest::addColumn<bool>("lower_parts");
        QTest::newRow("a crown") << true;
        QTest::newRow("a rack") << false;
    }
    void takesTwoSilentBeamsForNoProofThatATipIsGone() {
        QFETCH(bool, lower_parts);
        ObstacleMemory memory;
        MemorySpans here = spans;
        here.lower_parts = lower_parts;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 100.0);
        setSonars(senses, {{"M0", 2.5}});
        memory.take(senses, here);
        for (const double now_s : {100.2, 100.4}) {
            Senses silent = sensesAt({0, 0, 6}, 0.0, now_s);
            setSonars(silent, {});
            memory.take(silent, here);
        }
        QCOMPARE(!memory.near({0, 0}, 8.0, 5.9).empty(), lower_parts);
    }

    void rememberWhatIsBehind() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6}, 0.0, 100.0);
        setSonars(senses, {{"M0", 2.0}});
        memory.take(senses, spans);
        Senses turned = sensesAt({0, 0, 6}, pi, 102.0); // the tree is at the back now, where no sonar looks
        setSonars(turned, {});
        memory.take(turned, spans);
        const auto near = memory.near({0, 0}, 8.0, 5.0);
        QVERIFY(clearance_m(near, {0, 0}, 0.0, 0.8, 5.0) < 3.0);
        QCOMPARE(clearance_m(near, {0, 0}, pi, 0.8, 5.0), 5.0);
    }

    void findsTheHighestAlongACorridorOnly() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        senses.scan = PlacedScan{{1}, {}, {}, {Vec3(5, 0, 3.0), Vec3(5, 4, 9.0), Vec3(-5, 0, 8.0), Vec3(20, 0, 7.0)}};
        memory.take(senses, spans);
        QCOMPARE(*memory.highestAlong_m({0, 0}, 0.0, 1.5, 10.0), 3.0);
        QVERIFY(!memory.highestAlong_m({0, 0}, -pi / 2.0, 1.5, 10.0));
    }

    void saysHowMuchOfAWayIsKnown() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        setFlatScan(senses, {3, 0}, 3.0, 0.0);
        memory.take(senses, spans);
        QVERIFY(memory.knownAlong({0, 0}, 0.0, 1.0, 5.0) > 0.95);
        QVERIFY(memory.knownAlong({0, 0}, pi, 1.0, 5.0) < 0.1);
        const double half = memory.knownAlong({0, 0}, 0.0, 1.0, 12.0);
        QVERIFY(half > 0.4 && half < 0.6);
    }

    /// From a lower lane, the scanner saw a tree up to its own height, and the robot sank into the rest of it on the
    /// next lane (`tall_test`, seed 12).
    void doesNotKnowAWayWithAThingWhoseTopWasHidden_data() {
        QTest::addColumn<double>("scanner_m");
        QTest::addColumn<double>("again_m");
        QTest::addColumn<bool>("is_known");
        QTest::newRow("from its height") << 3.2 << 0.0 << false;
        QTest::newRow("from above") << 5.0 << 0.0 << true;
        QTest::newRow("from its height, then from above, as high") << 3.2 << 3.0 << true;
        QTest::newRow("from its height, then its side from above") << 3.2 << 1.0 << false;
        QTest::newRow("from its height, then more of it from above") << 3.2 << 4.5 << true;
    }
    void doesNotKnowAWayWithAThingWhoseTopWasHidden() {
        QFETCH(double, scanner_m);
        QFETCH(double, again_m);
        QFETCH(bool, is_known);
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, scanner_m}, 0.0, 100.0);
        setFlatScan(senses, {3, 0}, 4.0, 0.0);
        senses.scan->hits_in_map_m.emplace_back(3.1, 0.1, 3.0);
        memory.take(senses, spans);
        if (again_m > 0.0) {
            Senses later = sensesAt({0, 0, 9}, 0.0, 200.0);
            setFlatScan(later, {3, 0}, 4.0, 0.0);
            later.scan->hits_in_map_m.emplace_back(3.1, 0.1, again_m);
            memory.take(later, spans);
        }
        QCOMPARE(memory.knownAlong({0, 0}, 0.0, 1.5, 5.0) > 0.9, is_known);
    }

    void isEmptyAfterAClear() {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        setFlatScan(senses, {0, 0}, 1.0, 5.0);
        setSonars(senses, {{"M0", 2.0}});
        memory.take(senses, spans);
        memory.clear();
        QVERIFY(memory.near({0, 0}, 8.0, 0.0).empty());
        QVERIFY(!memory.lowest_m({0, 0}, 1.0));
    }

    void measuresFreeWays_data() {
        QTest::addColumn<double>("bearing_deg");
        QTest::addColumn<double>("half_width_m");
        QTest::addColumn<double>("free_m");
        QTest::newRow("at it") << 0.0 << 0.5 << 4.0;
        QTest::newRow("past it, narrow") << 30.0 << 0.5 << 10.0;
        QTest::newRow("past it, wide") << 30.0 << 2.5 << 4.0 * std::cos(radians(30.0));
        QTest::newRow("away from it") << 180.0 << 2.5 << 10.0;
    }
    void measuresFreeWays() {
        QFETCH(double, bearing_deg);
        QFETCH(double, half_width_m);
        QFETCH(double, free_m);
        const std::vector<Obstacle> obstacles{wallAt(4, 0)};
        QVERIFY(std::abs(clearance_m(obstacles, {0, 0}, radians(bearing_deg), half_width_m, 10.0) - free_m) < 1e-9);
    }

    void findsTheNearest() {
        const std::vector<Obstacle> obstacles{wallAt(4, 0), wallAt(0, -3)};
        QCOMPARE(nearest_m(obstacles, {0, 0}, 9.0), 3.0);
        QCOMPARE(nearest_m({}, {0, 0}, 9.0), 9.0);
    }
};

USAR_TEST(tst_ObstacleMemory)

} // namespace tst_obstacle_memory

#include "tst_obstacle_memory.moc"
