#include <array>
#include <cmath>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/ascent.h"
#include "robots/airrobot/flight/column.h"
#include "robots/airrobot/flight/crash_watch.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_overhead {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

namespace {

constexpr double reach_m = 20.0;

/// Returns the scan to the left of a robot that rolls by `roll_rad` under a level ceiling, with a wall at `wall_m`.
PlacedScan scanBelow(double ceiling_m, double wall_m, double roll_rad, const Vec3& from_m) {
    PlacedScan scan;
    scan.base_in_map = {from_m, roll_rad, 0.0, 0.0};
    for (double up_rad = roll_rad; up_rad > 0.0; up_rad -= radians(1.0)) {
        const double range_m =
            std::min({reach_m, wall_m / std::cos(up_rad), (ceiling_m - from_m.z()) / std::sin(up_rad)});
        const Vec3 end_m = from_m + range_m * Vec3(0.0, std::cos(up_rad), std::sin(up_rad));
        scan.highest_m = std::max(scan.highest_m, end_m.z());
        if (range_m < reach_m)
            scan.hits_in_map_m.push_back(end_m);
    }
    return scan;
}

Senses sensesWith(const PlacedScan& scan) {
    Senses senses = sensesAt(scan.base_in_map.position_m);
    senses.scan = scan;
    return senses;
}

/// 1.7 m above the robot.
void seeCeiling(Overhead& overhead) {
    overhead.observe(sensesWith(scanBelow(6.0, 12.0, radians(14.0), {0.0, 0.0, 4.3})),
                     {.climb_m_s = 0.0, .ascending = true});
}

/// The last hits below a ceiling, so many of them.
Senses glimpseOf(double ceiling_m, std::size_t hits) {
    Senses senses = sensesWith(scanBelow(ceiling_m, 100.0, radians(14.0), {0.0, 0.0, 4.3}));
    auto& hits_m = senses.scan->hits_in_map_m;
    hits_m.erase(hits_m.begin(), hits_m.end() - static_cast<std::ptrdiff_t>(hits));
    return senses;
}

} // namespace

class tst_Overhead : public QObject {
    Q_OBJECT

    const Settings settings;

private slots:
    /// Beams that were steeper than those on the flat underside of a crown met the side of that, or nothing
    /// (`tst_random_surveys_campaign`, number 118160).
    void takesNoUndersideThatSteeperBeamsPassForACeiling_data() {
        QTest::addColumn<double>("steeper_up_rad");
        QTest::addColumn<double>("steeper_range_m");
        QTest::addColumn<bool>("hits");
        QTest::addColumn<bool>("seen");
        QTest::newRow("nothing is steeper") << 0.0 << 0.0 << false << true;
        QTest::newRow("a steeper beam meets the side of the crown") << radians(16.0) << 9.0 << true << false;
        QTest::newRow("a steeper beam meets nothing") << radians(16.0) << reach_m << false << false;
        QTest::newRow("a steeper beam meets the ceiling")
            << radians(16.0) << 1.7 / std::sin(radians(16.0)) << true << true;
        QTest::newRow("a beam on the other side meets nothing") << radians(164.0) << reach_m << false << true;
    }
    void takesNoUndersideThatSteeperBeamsPassForACeiling() {
        QFETCH(double, steeper_up_rad);
        QFETCH(double, steeper_range_m);
        QFETCH(bool, hits);
        QFETCH(bool, seen);
        const Vec3 from_m(0.0, 0.0, 4.3);
        Senses senses = sensesWith(scanBelow(6.0, 12.0, radians(14.0), from_m));
        const Vec3 end_m = from_m + steeper_range_m * Vec3(0.0, std::cos(steeper_up_rad), std::sin(steeper_up_rad));
        auto& ends_m = hits ? senses.scan->hits_in_map_m : senses.scan->misses_in_map_m;
        if (steeper_range_m > 0.0)
            ends_m.insert(ends_m.begin(), end_m);
        Overhead overhead;
        overhead.observe(senses, {.climb_m_s = 0.0, .ascending = true});
        QCOMPARE(overhead.hasCeiling(), seen);
    }

    void seesACeilingAndNothingElse_data() {
        QTest::addColumn<double>("ceiling_m");
        QTest::addColumn<double>("wall_m");
        QTest::addColumn<bool>("seen");
        QTest::newRow("a hall") << 6.0 << 12.0 << true;
        QTest::newRow("a low hall") << 5.0 << 8.0 << true;
        QTest::newRow("a wall under the sky") << 100.0 << 6.0 << false;
        QTest::newRow("the sky") << 100.0 << 100.0 << false;
    }
    void seesACeilingAndNothingElse() {
        QFETCH(double, ceiling_m);
        QFETCH(double, wall_m);
        QFETCH(bool, seen);
        Overhead overhead;
        const Senses senses = sensesWith(scanBelow(ceiling_m, wall_m, radians(14.0), {0.0, 0.0, 4.3}));
        overhead.observe(senses, {.climb_m_s = 0.0, .ascending = true});
        QCOMPARE(overhead.found().has_value(), seen);
        QCOMPARE(overhead.ceiling_m({3.0, 0.0}).has_value(), seen);
        if (seen) {
            QVERIFY(std::abs(*overhead.ceiling_m({3.0, 0.0}) - ceiling_m) < 0.13);
            QVERIFY(!overhead.found()->touched);
            QCOMPARE(overhead.limit_m({0.0, 0.0}), *overhead.ceiling_m({0.0, 0.0}) - Overhead::margin_m);
        }
        overhead.observe(senses, {.climb_m_s = 0.0, .ascending = true});
        QVERIFY(!overhead.found()); // It is told once.
    }

    /// A crown of `quick_scan`, seed 4145, under which it flew for 20 minutes.
    void fewHitsAreACeilingIfASecondScanShowsIt_data() {
        QTest::addColumn<int>("hits");
        QTest::addColumn<double>("second_ceiling_m");
        QTest::addColumn<double>("later_s");
        QTest::addColumn<bool>("at_once");
        QTest::addColumn<bool>("in_the_end");
        QTest::newRow("many") << 5 << 6.0 << 0.2 << true << true;
        QTest::newRow("few, again") << 4 << 6.0 << 0.2 << false << true;
        QTest::newRow("nearly as high, as a robot that rolls tells it") << 4 << 6.25 << 0.8 << false << true;
        QTest::newRow("at another height") << 4 << 6.6 << 0.2 << false << false;
        QTest::newRow("in another look") << 4 << 6.0 << 3.0 << false << false;
    }
    void fewHitsAreACeilingIfASecondScanShowsIt() {
        QFETCH(int, hits);
        QFETCH(double, second_ceiling_m);
        QFETCH(double, later_s);
        QFETCH(bool, at_once);
        QFETCH(bool, in_the_end);
        Overhead overhead;
        overhead.observe(glimpseOf(6.0, static_cast<std::size_t>(hits)), {0.0, true});
        QCOMPARE(overhead.hasCeiling(), at_once);
        Senses senses = glimpseOf(second_ceiling_m, static_cast<std::size_t>(hits));
        senses.now += Seconds(later_s);
        overhead.observe(senses, {0.0, true});
        QCOMPARE(overhead.hasCeiling(), in_the_end);
        if (in_the_end)
            QVERIFY(*overhead.ceiling_m({0.0, 0.0}) < 6.1);
    }

    void aSmallCeilingEndsNotFarFromItsFind() {
        Overhead overhead;
        seeCeiling(overhead);
        overhead.takeForSmall(true, 4.3);
        QVERIFY(overhead.ceiling_m({1.0, 0.0}));
        QVERIFY(!overhead.ceiling_m({3.0, 0.0}));
        QCOMPARE(overhead.nearestFind_m({3.0, 0.0}, 4.0), 3.0);
        QCOMPARE(overhead.nearestFind_m({0.0, 9.0}, 4.0), 4.0);
        overhead.takeForSmall(false, 8.0); // It is above it elsewhere, so this is a small one.
        QVERIFY(!overhead.ceiling_m({3.0, 0.0}));
        overhead.takeForSmall(false, 4.3);
        QVERIFY(overhead.ceiling_m({30.0, 0.0}));
    }

    void anotherPlaceForAClimbIsAwayFromTheCeilingAndHasRoom() {
        Overhead overhead;
        seeCeiling(overhead);
        const std::vector<Obstacle> rack{wallAt(0.0, 5.0), wallAt(2.0, 5.0), wallAt(-2.0, 5.0)};
        const Vec2 first_m = otherColumn_m(rack, {0.0, 0.0}, overhead, {});
        QVERIFY(overhead.nearestFind_m(first_m, 9.0) >= 3.5);
        QVERIFY(nearest_m(rack, first_m, 9.0) >= room_to_climb_m);
        const Vec2 second_m = otherColumn_m(rack, {0.0, 0.0}, overhead, std::array{first_m});
        QVERIFY((second_m - first_m).norm() >= 2.0);
        const std::vector<Obstacle> all_around = [] {
            std::vector<Obstacle> ring;
            for (double bearing_rad = -pi; bearing_rad < pi; bearing_rad += 0.2)
                ring.push_back(wallAt(1.3 * std::cos(bearing_rad), 1.3 * std::sin(bearing_rad)));
            return ring;
        }();
        QCOMPARE(otherColumn_m(all_around, {0.0, 0.0}, overhead, {}), Vec2(0.0, 0.0));
    }

    void aCrownBesideARobotUnderWayIsNoCeiling() {
        Overhead overhead;
        overhead.observe(sensesWith(scanBelow(6.0, 12.0, radians(14.0), {0.0, 0.0, 4.3})), {});
        QVERIFY(!overhead.ceiling_m({0.0, 0.0}));
    }

    void aClimbThatDoesNotClimbHasMetSomething() {
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 3.0});
        for (int tick = 0; tick < 20; ++tick) { // Free: it climbs as it is told.
            overhead.observe(senses, {.climb_m_s = 0.4});
            QVERIFY(!overhead.found());
            senses.now += Seconds(0.2);
            senses.base_in_map.position_m.z() += 0.08;
        }
        bool found = false;
        for (int tick = 0; tick < 10 && !found; ++tick) {
            overhead.observe(senses, {.climb_m_s = 0.4});
            found = overhead.found().has_value();
            senses.now += Seconds(0.2);
        }
        QVERIFY(found && overhead.found()->touched);
        QVERIFY(std::abs(*overhead.ceiling_m({1.0, 2.0}) - senses.position_m().z()) < 0.01);
        QCOMPARE(overhead.allowed_m_s(senses, 1.0, 1.0), 0.0);
        QCOMPARE(overhead.allowed_m_s(senses, -0.5, 0.3), -0.5);
    }

    /// Its climbs are gentler than what counts as a push otherwise.
    void aRobotThatObeysLateFeelsARoof() {
        Overhead overhead;
        for (int tick = 0; tick < 60; ++tick) {
            Senses senses = sensesAt({0.0, 0.0, 5.0}, 0.0, 100.0 + 0.2 * tick);
            senses.late = Seconds(1.6);
            overhead.observe(senses, {.climb_m_s = 0.3 * senses.steadyShare(), .ascending = false});
        }
        QVERIFY(overhead.hasCeiling());
    }

    void whatARobotThatObeysLateHasTouchedMayBeNothing() {
        for (const bool late : {false, true}) {
            Overhead overhead;
            for (int tick = 0; tick < 11; ++tick) { // 2 s and a tick, in which it does not climb yet
                Senses senses = sensesAt({0.0, 0.0, 5.0}, 0.0, 100.0 + 0.2 * tick);
                senses.late = Seconds(late ? 1.6 : 0.0);
                overhead.observe(senses, {.climb_m_s = 0.4, .ascending = false});
            }
            QCOMPARE(overhead.hasCeiling(), !late);
            overhead.forgetTouches();
            QVERIFY(!overhead.hasCeiling());
        }
        Overhead overhead;
        seeCeiling(overhead);
        overhead.forgetTouches();
        QVERIFY(overhead.hasCeiling()); // It was seen.
    }

    /// As flown in `tall_test` with seed 16: it sank after its lane, and the climb over a crown took a second to begin.
    void aClimbThatBeginsWhileItSinksHasMetNothing() {
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 14.3});
        for (const double z_m : {14.42, 14.3, 14.23, 14.19, 14.19, 14.21, 14.25, 14.29, 14.36, 14.45, 14.6}) {
            senses.base_in_map.position_m.z() = z_m;
            overhead.observe(senses, {.climb_m_s = 0.5});
            senses.now += Seconds(0.2);
        }
        QVERIFY(!overhead.hasCeiling());
    }

    /// As flown in `tall_test` with seed 3: it climbed slowly, as it was told, until it was told to climb fast.
    void aCommandThatHasJustGrownHasMetNothing() {
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 6.61});
        const std::vector<std::pair<double, double>> told_and_risen{
            {0.21, 6.61}, {0.25, 6.61}, {0.27, 6.63}, {0.26, 6.66}, {0.24, 6.7}, {1.0, 6.74}, {1.0, 6.79}, {1.0, 6.84}};
        for (const auto& [climb_m_s, z_m] : told_and_risen) {
            senses.base_in_map.position_m.z() = z_m;
            overhead.observe(senses, {.climb_m_s = climb_m_s});
            senses.now += Seconds(0.2);
        }
        QVERIFY(!overhead.hasCeiling());
        for (int tick = 0; tick < 8; ++tick) { // But one that had its time and got nowhere has.
            overhead.observe(senses, {.climb_m_s = 1.0});
            senses.now += Seconds(0.2);
        }
        QVERIFY(overhead.hasCeiling());
    }

    /// As flown in `tall_test` with seed 22: the slow climb was all but too slow, and the last two commands had no
    /// effect yet.
    void aCommandThatGrewAtTheEndHasMetNothing() {
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 10.87});
        const std::vector<std::pair<double, double>> told_and_risen{{0.172, 10.87}, {0.172, 10.85}, {0.188, 10.85},
                                                                    {0.188, 10.85}, {0.188, 10.86}, {0.18, 10.89},
                                                                    {1.0, 10.93},   {1.0, 10.99},   {1.0, 11.12}};
        for (const auto& [climb_m_s, z_m] : told_and_risen) {
            senses.base_in_map.position_m.z() = z_m;
            overhead.observe(senses, {.climb_m_s = climb_m_s});
            senses.now += Seconds(0.2);
        }
        QVERIFY(!overhead.hasCeiling());
    }

    /// As flown on the volcano with seed 1: it was told to climb a little, and its height drifted. The ceiling that was
    /// none kept it from going over the slope, and it landed where it was.
    void whatDoesNotStopAFastRobotIsNoCeiling_data() {
        QTest::addColumn<double>("level_m_s");
        QTest::addColumn<bool>("ceiling");
        QTest::newRow("fast") << 2.0 << false;
        QTest::newRow("slow") << 0.4 << true;
    }
    void whatDoesNotStopAFastRobotIsNoCeiling() {
        QFETCH(double, level_m_s);
        QFETCH(bool, ceiling);
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 139.75});
        const std::vector<std::pair<double, double>> told_and_risen{{0.15, 139.75}, {0.17, 139.75}, {0.19, 139.75},
                                                                    {0.22, 139.78}, {0.24, 139.79}, {0.26, 139.79},
                                                                    {0.28, 139.8},  {0.3, 139.8},   {0.31, 139.8}};
        for (const auto& [climb_m_s, z_m] : told_and_risen) {
            senses.velocity_in_map_m_s = Vec3(0.0, -level_m_s, 0.05);
            senses.base_in_map.position_m.z() = z_m;
            overhead.observe(senses, {.climb_m_s = climb_m_s});
            senses.now += Seconds(0.2);
        }
        QCOMPARE(overhead.hasCeiling(), ceiling);
    }

    void whatTheRobotGetsPastIsNoCeiling() {
        Overhead overhead;
        Senses senses = sensesAt({1.0, 2.0, 3.0});
        for (int tick = 0; tick < 10; ++tick) { // What it is told arrives late.
            overhead.observe(senses, {.climb_m_s = 0.4});
            senses.now += Seconds(0.2);
        }
        QVERIFY(overhead.hasCeiling());
        senses.base_in_map.position_m.z() = 3.2;
        overhead.observe(senses, {});
        QVERIFY(overhead.hasCeiling());
        senses.base_in_map.position_m.z() = 3.4;
        overhead.observe(senses, {});
        QVERIFY(!overhead.hasCeiling());
    }

    void whatABeamGetsPastIsNoCeiling() {
        Overhead overhead;
        seeCeiling(overhead);
        QVERIFY(overhead.hasCeiling());
        Senses senses = sensesWith(scanBelow(6.0, 12.0, radians(14.0), {0.0, 0.0, 4.3}));
        senses.scan->highest_near_m = 6.9; // The attitude is not known better.
        overhead.observe(senses, {});
        QVERIFY(overhead.hasCeiling());
        senses.scan->highest_near_m = 7.5;
        overhead.observe(senses, {});
        QVERIFY(overhead.hasCeiling()); // A number in that line may be damaged.
        overhead.observe(senses, {});
        QVERIFY(!overhead.hasCeiling());
    }

    /// With 0.18 rad of drift it flew into the roof that it had touched (a warehouse, survey 118109).
    void believesNoBeamWhereItsLeanMayHaveDrifted() {
        Overhead overhead;
        seeCeiling(overhead);
        Senses senses = sensesWith(scanBelow(100.0, 100.0, radians(14.0), {0.0, 0.0, 4.3}));
        senses.scan->lean_known = false;
        senses.scan->highest_near_m = 8.5;
        const double free_to_m = overhead.freeTo_m();
        for (int scans = 0; scans < 2; ++scans)
            overhead.observe(senses, {});
        QVERIFY(overhead.hasCeiling());
        QCOMPARE(overhead.freeTo_m(), free_to_m);
        senses.scan->highest_near_m = 9.5; // So much is no drift.
        for (int scans = 0; scans < 2; ++scans)
            overhead.observe(senses, {});
        QVERIFY(!overhead.hasCeiling());
        QVERIFY(overhead.everHadCeiling());
        overhead.forgetPlaces();
        QVERIFY(overhead.everHadCeiling());
        QVERIFY(!Overhead().everHadCeiling());
    }

    /// Beams got past the edge of what it pressed against, and it went on climbing there (survey 118277).
    void whatItHasJustTouchedIsThereAndSmall() {
        Overhead overhead;
        Senses senses = sensesWith(scanBelow(9.0, 12.0, radians(14.0), {0.0, 0.0, 4.3}));
        senses.ground_m = 0.0;
        senses.scan->highest_near_m = 7.5;
        const auto wait_s = [&](double seconds, double climb_m_s) {
            for (double past_s = 0.0; past_s < seconds; past_s += 0.2) {
                senses.now += Seconds(0.2);
                overhead.observe(senses, {climb_m_s, true});
            }
        };
        wait_s(2.0, 0.3);
        QVERIFY(overhead.hasCeiling());
        QCOMPARE(overhead.ceiling_m({0.0, 0.0}), std::optional(4.3));
        QVERIFY(!overhead.ceiling_m({3.0, 0.0}));
        wait_s(6.0, 0.0);
        QVERIFY(!overhead.hasCeiling());
    }

    /// It took a roof of 8.8 m for one of 4.1 m after it had met a beam, and then for none.
    void whatItTouchesFarBelowARoofIsNotTheRoof() {
        Overhead overhead;
        seeCeiling(overhead); // at 6 m
        Senses senses = sensesAt({0.0, 0.0, 4.3});
        senses.ground_m = 0.0;
        for (int tick = 0; tick < 10; ++tick) {
            senses.now += Seconds(0.2);
            overhead.observe(senses, {0.3, true});
        }
        QCOMPARE(overhead.ceiling_m({0.0, 0.0}), std::optional(4.3));
        overhead.takeForSmall(false, 5.0); // It has gone up beside it.
        QVERIFY(*overhead.ceiling_m({3.0, 0.0}) > 5.9);
    }

    /// It pressed against the same low floor for 12 s, because it took that for what it had met 3 m away (survey
    /// 122349).
    void whatItTouchesBeyondASmallCeilingIsAnother() {
        Overhead overhead;
        Senses senses = sensesAt({0, 0, 0});
        senses.ground_m = 0.0;
        const auto press = [&](const Vec3& at_m) {
            senses.base_in_map.position_m = at_m;
            for (int tick = 0; tick < 10; ++tick) {
                senses.now += Seconds(0.2);
                overhead.observe(senses, {0.3, true});
            }
        };
        press({0.0, 0.0, 3.2});
        overhead.takeForSmall(true, 3.2);
        QVERIFY(!overhead.ceiling_m({3.0, 0.0}));
        press({3.0, 0.0, 3.2});
        QCOMPARE(overhead.ceiling_m({3.0, 0.0}), std::optional(3.2));
    }

    void knowsAWallFromATrunk_data() {
        QTest::addColumn<int>("scans");
        QTest::addColumn<double>("top_m");
        QTest::addColumn<double>("slope");
        QTest::addColumn<bool>("wall");
        QTest::newRow("a wall") << 8 << 6.0 << 0.0 << true;
        QTest::newRow("a trunk that it passes") << 3 << 6.0 << 0.0 << false;
        QTest::newRow("a wall below the robot") << 8 << 4.0 << 0.0 << false;
        QTest::newRow("a steep slope") << 8 << 6.0 << 0.5 << false;
    }
    void knowsAWallFromATrunk() {
        QFETCH(int, scans);
        QFETCH(double, top_m);
        QFETCH(double, slope);
        QFETCH(bool, wall);
        Overhead overhead;
        Senses senses = sensesAt({0.0, 0.0, 6.0});
        senses.scan = PlacedScan{senses.line, senses.base_in_map, senses.base_in_map, {}};
        for (double z_m = 2.0; z_m <= top_m; z_m += 0.25)
            senses.scan->hits_in_map_m.emplace_back(0.0, 4.0 + slope * z_m, z_m);
        for (int scan = 0; scan < scans; ++scan)
            overhead.observe(senses, {});
        QCOMPARE(overhead.besideWall(senses.now), wall);
        QVERIFY(!overhead.besideWall(senses.now + Seconds(20.0)));
    }

    void aRobotThatDoesNotLiftOffHasMetNoCeiling() {
        Overhead overhead;
        Senses senses = sensesAt({0.0, 0.0, 0.2});
        senses.ground_m = 0.0;
        for (int tick = 0; tick < 20; ++tick) {
            overhead.observe(senses, {.climb_m_s = 0.4, .ascending = true});
            QVERIFY(!overhead.found());
            senses.now += Seconds(0.2);
        }
    }

    void knowsHowFarUpTheAirIsFree() {
        Overhead overhead;
        const Senses senses = sensesAt({0.0, 0.0, 1.5});
        QCOMPARE(overhead.allowed_m_s(senses, 1.0, 0.3), 0.3);
        QCOMPARE(overhead.allowed_m_s(senses, 1.0, 1.0), 1.0);
        overhead.observe(sensesWith(scanBelow(100.0, 15.0, radians(14.0), {0.0, 0.0, 1.5})), {});
        QVERIFY(overhead.freeTo_m() < 0.0); // Something stands there, and may stand elsewhere.
        overhead.observe(sensesWith(scanBelow(100.0, 100.0, radians(14.0), {0.0, 0.0, 1.5})), {});
        QVERIFY(std::abs(overhead.freeTo_m() - (1.5 + reach_m * std::sin(radians(14.0)) - Overhead::margin_m)) < 0.1);
    }

    void climbsFastWhereItHasComeDown() {
        Overhead overhead;
        Ascent first;
        Ascent again(5.0);
        Senses senses = sensesAt({0.0, 0.0, 0.3});
        first.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings);
        again.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings);
        senses.base_in_map.position_m.z() = 3.0;
        overhead.observe(sensesWith(scanBelow(100.0, 100.0, radians(14.0), {0.0, 0.0, 3.0})), {});
        QVERIFY(first.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings).climb_m_s <= Overhead::careful_m_s);
        QCOMPARE(again.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings).climb_m_s, settings.climb_speed_m_s);
        senses.base_in_map.position_m.z() = 4.8;
        QVERIFY(again.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings).climb_m_s <= Overhead::careful_m_s);
    }

    /// After each charge, the robot took six seconds to look at the last 0.7 m of its climb.
    void looksUpOnlyIfMoreThanALittleIsUnknown_data() {
        QTest::addColumn<double>("come_down_m");
        QTest::addColumn<bool>("looks");
        QTest::newRow("the last meter") << 6.2 << false;
        QTest::newRow("the last three meters") << 4.2 << true;
    }
    void looksUpOnlyIfMoreThanALittleIsUnknown() {
        QFETCH(double, come_down_m);
        QFETCH(bool, looks);
        Ascent ascent(come_down_m);
        Senses senses = sensesWith(scanBelow(100.0, 100.0, 0.0, {0.0, 0.0, 3.0}));
        bool looked = false;
        for (double z_m = 0.3; z_m < 6.2; z_m += 0.1) {
            senses.base_in_map.position_m.z() = z_m;
            looked = looked || ascent.step(senses, {0.0, 0.0, 6.3}, {}, {}, settings).right_m_s > 0.0;
        }
        QCOMPARE(looked, looks);
    }

    /// A look toward a pole that no sensor had looked at yet broke the robot in random survey 122038.
    void looksUpOnceItKnowsWhatStandsThere_data() {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<bool>("at_once");
        QTest::addColumn<bool>("later");
        QTest::newRow("nothing is near") << 5.0 << true << true;
        QTest::newRow("something farther off") << 4.5 << false << true;
        QTest::newRow("something where it would roll to") << 1.5 << false << false;
    }
    void looksUpOnceItKnowsWhatStandsThere() {
        QFETCH(double, range_m);
        QFETCH(bool, at_once);
        QFETCH(bool, later);
        Ascent ascent;
        Senses senses = sensesWith(scanBelow(100.0, 100.0, 0.0, {0.0, 0.0, 2.5}));
        const auto step = [&](double z_m, double yaw_rad, double heard_m) {
            senses.base_in_map.position_m.z() = z_m;
            senses.base_in_map.yaw_rad = yaw_rad;
            senses.ground_m = 0.0;
            setSonars(senses, {{"M0", heard_m}});
            return ascent.step(senses, {0.0, 0.0, 6.3}, {}, {}, settings);
        };
        step(0.3, 0.0, 5.0);
        step(2.0, 0.0, range_m);
        QCOMPARE(step(2.5, 0.0, 5.0).right_m_s > 0.0, at_once);
        if (at_once)
            return;
        QVERIFY(step(2.5, 0.1, 5.0).climb_m_s <= 0.0); // It waits there.
        for (double yaw_rad = 0.1; yaw_rad < pi; yaw_rad += 0.1)
            QCOMPARE(step(2.5, yaw_rad, 5.0).right_m_s, 0.0);
        QCOMPARE(step(2.5, pi, 5.0).right_m_s > 0.0 || step(2.5, pi, 5.0).right_m_s > 0.0, later);
    }

    void climbsWithCareBeyondADoor() {
        Ascent ascent = Ascent::beyondDoor();
        Senses senses = sensesAt({0.0, 0.0, 2.4});
        for (const double z_m : {2.4, 3.0}) {
            senses.base_in_map.position_m.z() = z_m;
            const AscentStep step = ascent.step(senses, {0.0, 0.0, 6.3}, {}, {}, settings);
            QCOMPARE(step.climb_m_s, Overhead::careful_m_s);
            QVERIFY(!step.turns);
        }
    }

    /// A robot that goes where it is told and rolls as it sets off, in a hall with this ceiling.
    void endsItsAscentBelowTheCeiling_data() {
        QTest::addColumn<double>("ceiling_m");
        QTest::addColumn<double>("reached_m");
        QTest::newRow("a hall of 6 m") << 6.0 << 6.0 - Overhead::margin_m;
        QTest::newRow("outdoors") << 1000.0 << 6.3;
    }
    void endsItsAscentBelowTheCeiling() {
        QFETCH(double, ceiling_m);
        QFETCH(double, reached_m);
        Overhead overhead;
        Ascent ascent;
        Vec3 at_m(0.0, 0.0, 0.3);
        double climb_m_s = 0.0;
        double roll_rad = 0.0;
        double yaw_rad = 0.0;
        bool looked_around = false;
        for (int tick = 0; tick < 300; ++tick) {
            Senses senses = sensesWith(scanBelow(ceiling_m, 30.0, roll_rad, at_m));
            senses.now = Seconds(0.2 * tick);
            senses.base_in_map.yaw_rad = yaw_rad;
            overhead.observe(senses, {climb_m_s, true});
            const AscentStep step = ascent.step(senses, {0.0, 0.0, 6.3}, overhead, {}, settings);
            yaw_rad = normalizedAngle(yaw_rad + (step.turns ? 0.1 : 0.0));
            looked_around = looked_around || step.looked_around;
            QVERIFY2(looked_around || at_m.z() < 3.2, qPrintable(QString::number(at_m.z())));
            if (step.reached) {
                QVERIFY2(std::abs(at_m.z() - reached_m) <= 0.35, qPrintable(QString::number(at_m.z())));
                return;
            }
            climb_m_s = step.climb_m_s;
            roll_rad = step.right_m_s != 0.0 ? radians(14.0) : 0.0;
            at_m.z() += 0.2 * climb_m_s;
            QVERIFY2(at_m.z() < ceiling_m - 0.3, qPrintable(QString::number(at_m.z())));
        }
        QFAIL("It never arrives.");
    }

    /// A thin trunk may stand between two scans of the turn.
    void hearsTrunksAsItLooksAround_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("hears");
        QTest::newRow("well above the ground") << 2.6 << true;
        QTest::newRow("so low that it may be the ground") << 1.4 << false;
    }
    void hearsTrunksAsItLooksAround() {
        QFETCH(double, height_m);
        QFETCH(bool, hears);
        Ascent ascent;
        const auto step = [&](double z_m) {
            Senses senses = sensesAt({0.0, 0.0, z_m});
            senses.ground_m = 0.0;
            setSonars(senses, {{"R2", 3.0}});
            ascent.step(senses, {0.0, 0.0, 6.3}, {}, {}, settings);
        };
        step(0.3);
        QVERIFY(ascent.heard().empty());
        step(height_m);
        QCOMPARE(ascent.heard().size(), std::size_t(hears ? 1 : 0));
    }

    void hearsTrunksAheadOfIt_data() {
        QTest::addColumn<QString>("sonar");
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("hears");
        QTest::newRow("near and ahead") << "R2" << 3.0 << 2.6 << true;
        QTest::newRow("far") << "R2" << 4.0 << 2.6 << false;
        QTest::newRow("beside it") << "R4" << 3.0 << 2.6 << false;
        QTest::newRow("the ground, perhaps") << "R2" << 3.0 << 1.4 << false;
    }
    void hearsTrunksAheadOfIt() {
        QFETCH(QString, sonar);
        QFETCH(double, range_m);
        QFETCH(double, height_m);
        QFETCH(bool, hears);
        Senses senses = sensesAt({0.0, 0.0, height_m});
        senses.ground_m = 0.0;
        setSonars(senses, {{sonar.toStdString(), range_m}});
        QCOMPARE(hearsAhead(senses, 3.2), hears);
    }

    /// Beside a rack that it cannot see in this plane, a roll to the side would end in it.
    void doesNotRollBesideWhatMayReachItsHeight_data() {
        QTest::addColumn<double>("aside_m");
        QTest::addColumn<double>("top_m");
        QTest::addColumn<double>("echo_m");
        QTest::addColumn<bool>("rolls");
        QTest::newRow("nothing near") << 8.0 << 2.95 << 5.0 << true;
        QTest::newRow("a rack whose top it could not see from below") << 1.6 << 2.95 << 5.0 << false;
        QTest::newRow("a pallet") << 1.6 << 1.0 << 5.0 << true;
        QTest::newRow("a rack that a sonar alone has met") << 8.0 << 2.95 << 1.7 << false;
    }
    void doesNotRollBesideWhatMayReachItsHeight() {
        QFETCH(double, aside_m);
        QFETCH(double, top_m);
        QFETCH(double, echo_m);
        QFETCH(bool, rolls);
        Ascent ascent;
        Overhead overhead;
        ObstacleMemory memory;
        Senses seen = sensesAt({0.0, 0.0, 3.0});
        setFlatScan(seen, {0.0, aside_m}, 0.3, top_m);
        memory.take(seen, {});
        ascent.step(sensesAt({0.0, 0.0, 0.3}), {0.0, 0.0, 6.3}, overhead, memory, settings);
        for (double yaw_rad = 0.0; yaw_rad < 3.3; yaw_rad += 0.1) // It looks around.
            ascent.step(sensesAt({0.0, 0.0, 2.9}, yaw_rad), {0.0, 0.0, 6.3}, overhead, memory, settings);
        Senses senses = sensesWith(scanBelow(100.0, 100.0, 0.0, {0.0, 0.0, 4.8}));
        setSonars(senses, {{"L4", echo_m}});
        QCOMPARE(ascent.step(senses, {0.0, 0.0, 6.3}, overhead, memory, settings).right_m_s != 0.0, rolls);
    }

    void whatNeverFlewHasNotCrashed() {
        CrashWatch watch;
        Senses senses = sensesAt({0.0, 0.0, 0.2});
        senses.ground_m = 0.0;
        for (int tick = 0; tick < 100; ++tick) {
            QVERIFY(!watch.update(senses, {.speed_m_s = 0.0, .climb_m_s = 0.4}));
            senses.now += Seconds(0.2);
        }
    }

    void knowsWhenItHasCrashed_data() {
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<double>("sinks_m_s");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("asked_m_s");
        QTest::addColumn<double>("ins_age_s");
        QTest::addColumn<QString>("words");
        QTest::newRow("flies") << 0.2 << 0.0 << 6.0 << 1.0 << 0.0 << "";
        QTest::newRow("sinks") << 0.0 << 0.6 << 6.0 << 0.0 << 0.0 << "";
        QTest::newRow("waits low") << 0.0 << 0.0 << 0.3 << 0.0 << 0.0 << "";
        QTest::newRow("is stuck in the air") << 0.0 << 0.0 << 4.0 << 1.0 << 0.0 << "";
        QTest::newRow("is on its side") << 1.3 << 0.0 << 0.3 << 0.0 << 0.0 << "it has turned over";
        QTest::newRow("falls") << 0.3 << 4.0 << 6.0 << 1.0 << 0.0 << "it falls";
        QTest::newRow("a damaged pose, and none after it") << 0.0 << 10.0 << 6.0 << 1.0 << 0.2 << ""; // survey 125001
        QTest::newRow("lies there") << 0.1 << 0.0 << 0.2 << 1.0 << 0.0 << "it lies on the ground and does not answer";
    }
    void knowsWhenItHasCrashed() {
        QFETCH(double, roll_rad);
        QFETCH(double, sinks_m_s);
        QFETCH(double, height_m);
        QFETCH(double, asked_m_s);
        QFETCH(double, ins_age_s);
        QFETCH(QString, words);
        CrashWatch watch;
        Senses in_the_air = sensesAt({0.0, 0.0, 6.0}, 0.0, 99.0);
        watch.update(in_the_air, {});
        Senses senses = sensesAt({0.0, 0.0, height_m});
        senses.base_in_map.roll_rad = roll_rad;
        senses.velocity_in_map_m_s.z() = -sinks_m_s;
        senses.ground_m = 0.0;
        watch.update(senses, {.speed_m_s = asked_m_s});
        senses.ins_age = Seconds(ins_age_s);
        QString said;
        for (int tick = 0; tick < 50; ++tick) {
            const char* const crash = watch.update(senses, {.speed_m_s = asked_m_s});
            said = crash ? crash : "";
            senses.now += Seconds(0.2);
        }
        QCOMPARE(said, words);
    }

    /// It scraped along a roof because its height had drifted by 0.75 m (survey 156413).
    void aCeilingDriftsWithTheFloor_data() {
        QTest::addColumn<double>("floor_m");
        QTest::addColumn<double>("sinks_by_m");
        QTest::newRow("the same floor") << 0.0 << 0.0;
        QTest::newRow("it seems lower") << -0.7 << 0.7;
        QTest::newRow("it seems higher, as on a rack") << 0.7 << 0.0;
        QTest::newRow("another floor") << -3.0 << 0.0;
    }
    void aCeilingDriftsWithTheFloor() {
        QFETCH(double, floor_m);
        QFETCH(double, sinks_by_m);
        Overhead overhead;
        Senses senses = sensesWith(scanBelow(6.0, 12.0, radians(14.0), {0.0, 0.0, 4.3}));
        senses.ground_m = 0.0;
        overhead.observe(senses, {.climb_m_s = 0.0, .ascending = true});
        const double ceiling_m = overhead.ceiling_m({0.0, 0.0}).value();
        overhead.putLid(3.0);
        senses.scan.reset();
        senses.ground_m = floor_m;
        for (int tick = 0; tick < 300; ++tick) {
            senses.now += Seconds(0.2);
            overhead.observe(senses, {});
        }
        QVERIFY(std::abs(overhead.ceiling_m({0.0, 0.0}).value() - (3.0 - sinks_by_m)) < 1e-9);
        overhead.putLid(std::nullopt);
        QVERIFY(std::abs(overhead.ceiling_m({0.0, 0.0}).value() - (ceiling_m - sinks_by_m)) < 1e-9);
    }

    void aLidIsACeilingEverywhere() {
        Overhead overhead;
        QVERIFY(!overhead.hasCeiling());
        overhead.putLid(3.0);
        QVERIFY(overhead.hasCeiling());
        QCOMPARE(overhead.limit_m({500.0, -500.0}), 3.0 - Overhead::margin_m);
        Senses senses = sensesAt({0.0, 0.0, 8.0}); // A robot above it does not show that there is none.
        overhead.observe(senses, {});
        QCOMPARE(overhead.ceiling_m({0.0, 0.0}), std::optional(3.0));
        overhead.putLid(std::nullopt);
        QVERIFY(!overhead.hasCeiling());
        overhead.putLid(3.0);
        overhead.forgetPlaces();
        QVERIFY(!overhead.hasCeiling());
    }
};

USAR_TEST(tst_Overhead)

} // namespace tst_overhead

#include "tst_overhead.moc"
