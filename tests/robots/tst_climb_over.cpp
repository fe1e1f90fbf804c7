#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/climb_over.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_climb_over {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_ClimbOver : public QObject {
    Q_OBJECT

    Settings settings;
    const Vec2 goal_m{20, 0};

    ClimbStep step(ClimbOver& climb, Senses& senses, const std::vector<std::pair<std::string, double>>& ranges,
                   const std::vector<Obstacle>& obstacles, double highest_m = 1e9) const {
        setSonars(senses, ranges);
        senses.now += Seconds(0.2);
        return climb.step(senses, judgeThreats(senses, settings), obstacles, goal_m, highest_m, settings);
    }

    /// Climbs below something that its ring meets after a few centimeters, until `touches` touches are over.
    void climbUnderSomething(ClimbOver& climb, Senses& senses, int touches,
                             const std::vector<Obstacle>& obstacles = {}) const {
        climb.start(senses, obstacles, settings);
        double commanded_m_s = 0.0;
        bool sinks = false;
        for (int tick = 0; tick < 600 && climb.active() && (touches > 0 || sinks); ++tick) {
            climb.feel(senses, Vec2::Zero(), commanded_m_s, settings);
            const ClimbStep now = step(climb, senses, {{"M0", 3.4}}, obstacles);
            commanded_m_s = now.climb_m_s;
            senses.base_in_map.position_m.head<2>() = now.place_m;
            senses.base_in_map.position_m.z() += 0.2 * std::min(commanded_m_s, 0.05);
            senses.velocity_in_map_m_s.z() = std::min(commanded_m_s, 0.05);
            senses.base_in_map.roll_rad = 0.1;
            const bool sank = std::exchange(sinks, commanded_m_s < 0.0);
            touches -= sinks && !sank ? 1 : 0;
        }
    }

private slots:
    void init() { settings = {}; }

    void backsAwayFromACrownBeforeItClimbs() {
        const std::vector<Obstacle> crown{wallAt(2.0, 0.0)};
        const Vec2 place_m = climbPlace_m(crown, {0, 0}, 3.2);
        QVERIFY(nearest_m(crown, place_m, 9.0) >= 3.0);
        QVERIFY(place_m.x() < 0.0);
    }

    void backsAwayToWhereItHasFlown() {
        const std::vector<Obstacle> crown{wallAt(2.0, 0.0)};
        const Retreat from_the_right{[](const Vec2& at_m) { return std::abs(at_m.x()) < 1.0 && at_m.y() < 0.0; }};
        QVERIFY(climbPlace_m(crown, {0, 0}, 3.2).y() > -1.0);
        const Vec2 place_m = climbPlace_m(crown, {0, 0}, 3.2, from_the_right);
        QVERIFY(place_m.y() < -1.5 && std::abs(place_m.x()) < 1.0);
    }

    /// An echo so near may come from the underside of a crown, into which the robot would climb (random surveys 133126
    /// and 149210).
    void sinksFromWhatComesNearItsRing_data() {
        QTest::addColumn<double>("left_m");
        QTest::addColumn<double>("ahead_m");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("an underside") << 0.3 << 0.2 << true;
        QTest::newRow("one trunk") << 0.6 << 2.0 << true;
        QTest::newRow("with room") << 1.1 << 1.0 << false;
    }
    void sinksFromWhatComesNearItsRing() {
        QFETCH(double, left_m);
        QFETCH(double, ahead_m);
        QFETCH(bool, sinks);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        climb.start(senses, {}, settings);
        for (int tick = 0; tick < 2; ++tick)
            step(climb, senses, {{"M0", 3.4}}, {});
        setSonars(senses, {{"L2", left_m}, {"M0", ahead_m}});
        senses.velocity_in_map_m_s.z() = 0.5;
        for (int tick = 0; tick < 2; ++tick)
            climb.feel(senses, Vec2::Zero(), 0.5, settings);
        QCOMPARE(climb.sinks(), sinks);
    }

    /// One that is pressed to one side tips over before it would have come to its speed (number 122502).
    void sinksAtOnceAsItTips_data() {
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<double>("climbs_m_s");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("it tips") << 0.25 << 0.0 << true;
        QTest::newRow("it tips while it climbs as it is told") << 0.25 << 0.45 << true; // number 97824
        QTest::newRow("it leans as it sets off") << 0.1 << 0.0 << false;
    }
    void sinksAtOnceAsItTips() {
        QFETCH(double, roll_rad);
        QFETCH(double, climbs_m_s);
        QFETCH(bool, sinks);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        climb.start(senses, {}, settings);
        for (int tick = 0; tick < 2; ++tick)
            step(climb, senses, {{"M0", 3.4}}, {});
        senses.base_in_map.roll_rad = roll_rad;
        senses.velocity_in_map_m_s.z() = climbs_m_s;
        for (int tick = 0; tick < 4; ++tick) {
            senses.now += Seconds(0.2);
            climb.feel(senses, Vec2::Zero(), 0.5, settings);
        }
        QCOMPARE(climb.sinks(), sinks);
    }

    void staysWhereThereIsRoom() { QCOMPARE(climbPlace_m({}, {5, 6}, 3.2), Vec2(5, 6)); }

    void doesNotBackThroughWhatItRemembers() {
        std::vector<Obstacle> dead_end{wallAt(2.0, 0.0), wallAt(-1.5, 0.0), wallAt(-1.5, 0.8), wallAt(-1.5, -0.8)};
        const Vec2 place_m = climbPlace_m(dead_end, {0, 0}, 3.2);
        const double bearing_rad = std::atan2(place_m.y(), place_m.x());
        QVERIFY(place_m.norm() < 1e-9 ||
                clearance_m(dead_end, {0, 0}, bearing_rad, 0.9, place_m.norm()) >= place_m.norm());
    }

    void climbsUntilTheWayIsFreeAndAThenSomeMore() {
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        const std::vector<Obstacle> crown{wallAt(4.0, 0.0)};
        climb.start(senses, crown, settings);
        QVERIFY(climb.active());
        QCOMPARE(step(climb, senses, {{"M0", 3.4}}, crown).state, ClimbState::Climbing);
        for (int i = 0; i < 20; ++i) {
            const ClimbStep up = step(climb, senses, {{"M0", 3.4}}, crown);
            QCOMPARE(up.state, ClimbState::Climbing);
            QVERIFY(up.climb_m_s > 0.0);
            senses.base_in_map.position_m.z() += 0.1;
        }
        const double free_z_m = senses.position_m().z();
        while (climb.active() && senses.position_m().z() < 30.0) {
            step(climb, senses, {}, {});
            senses.base_in_map.position_m.z() += 0.1;
            senses.ground_m = 0.0;
        }
        QVERIFY(senses.position_m().z() - free_z_m > 1.4);
        QVERIFY(senses.position_m().z() - free_z_m < 2.0);
    }

    void isNotOverWhileItLooksAnotherWay() {
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6}, pi / 2.0);
        climb.start(senses, {}, settings);
        for (int i = 0; i < 40; ++i) {
            step(climb, senses, {}, {});
            senses.base_in_map.position_m.z() += 0.1;
        }
        QVERIFY(climb.active());
    }

    void givesUpAtItsCeiling_data() {
        QTest::addColumn<bool>("ground_in_reach");
        QTest::newRow("so high over the ground") << true;
        QTest::newRow("so high that the ground is out of reach") << false;
    }
    void givesUpAtItsCeiling() {
        QFETCH(bool, ground_in_reach);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, settings.maximum_height_m + 0.5});
        senses.ground_m = ground_in_reach ? std::optional(0.0) : std::nullopt;
        const std::vector<Obstacle> wall{wallAt(4.0, 0.0)};
        climb.start(senses, wall, settings);
        step(climb, senses, {{"M0", 3.4}}, wall);
        QCOMPARE(step(climb, senses, {{"M0", 3.4}}, wall).state, ClimbState::Failed);
        QVERIFY(!climb.active());
    }

    void isOverBelowACeilingIfTheWayIsFreeThere_data() {
        QTest::addColumn<bool>("free");
        QTest::newRow("over a rack") << true;
        QTest::newRow("before a wall") << false;
    }
    void isOverBelowACeilingIfTheWayIsFreeThere() {
        QFETCH(bool, free);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 7.9});
        const std::vector<Obstacle> rack{wallAt(4.0, 0.0)};
        climb.start(senses, rack, settings);
        step(climb, senses, {{"M0", 3.4}}, rack, 8.2);
        senses.base_in_map.position_m.z() = 8.1;
        const ClimbStep end = free ? step(climb, senses, {}, {}, 8.2) : step(climb, senses, {{"M0", 3.4}}, rack, 8.2);
        QCOMPARE(end.state, free ? ClimbState::Over : ClimbState::Failed);
    }

    void sinksFromWhatItsRingMeetsAndClimbsElsewhere_data() {
        QTest::addColumn<double>("climbs_m_s");
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("it climbs as it is told") << 0.5 << 0.04 << false;
        QTest::newRow("it is slower for a moment") << 0.1 << 0.0 << false;
        QTest::newRow("something presses its nose down") << 0.1 << 0.1 << true;
        QTest::newRow("something jolts it") << 0.5 << 0.06 << true;
    }
    void sinksFromWhatItsRingMeetsAndClimbsElsewhere() {
        QFETCH(double, climbs_m_s);
        QFETCH(double, pitch_rad);
        QFETCH(bool, sinks);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        const std::vector<Obstacle> crown{wallAt(4.0, 0.0)};
        climb.start(senses, crown, settings);
        double commanded_m_s = 0.0;
        const auto fly = [&] {
            climb.feel(senses, Vec2::Zero(), commanded_m_s, settings);
            const ClimbStep now = step(climb, senses, {{"M0", 3.4}}, crown);
            commanded_m_s = now.climb_m_s;
            return now;
        };
        senses.velocity_in_map_m_s.z() = 0.5;
        for (int tick = 0; tick < 10; ++tick)
            QVERIFY(fly().state != ClimbState::Sinking);
        senses.velocity_in_map_m_s.z() = climbs_m_s;
        senses.base_in_map.pitch_rad = pitch_rad;
        const ClimbStep met = fly();
        QCOMPARE(met.state == ClimbState::Sinking, sinks);
        QCOMPARE(met.climb_m_s < 0.0, sinks);
        QVERIFY(climb.active());
        if (!sinks)
            return;
        senses.base_in_map.position_m.z() = 5.0;
        const ClimbStep back = fly();
        QCOMPARE(back.state, ClimbState::Backing);
        QVERIFY(back.place_m.x() < -1.0); // away from what it has met
    }

    /// Beside a wall among racks, it sank onto one that was below where it had begun to climb (random survey 166765).
    void sinksFromWhatItOnlyHearsNoDeeperThanWhereItBegan_data() {
        QTest::addColumn<bool>("touches");
        QTest::addColumn<double>("climbed_m");
        QTest::addColumn<double>("sinks_by_m");
        QTest::newRow("far above that") << false << 3.0 << 0.8;
        QTest::newRow("near that") << false << 0.3 << 0.3;
        QTest::newRow("near that, and it has touched something") << true << 0.3 << 0.8;
    }
    void sinksFromWhatItOnlyHearsNoDeeperThanWhereItBegan() {
        QFETCH(bool, touches);
        QFETCH(double, climbed_m);
        QFETCH(double, sinks_by_m);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        climb.start(senses, {}, settings);
        for (int tick = 0; tick < 2; ++tick)
            step(climb, senses, {{"M0", 3.4}}, {});
        senses.base_in_map.position_m.z() += climbed_m;
        senses.velocity_in_map_m_s.z() = 0.4;
        senses.base_in_map.roll_rad = touches ? 0.25 : 0.0;
        setSonars(senses, {{"L2", touches ? 3.0 : 0.3}});
        for (int tick = 0; tick < 4; ++tick) {
            senses.now += Seconds(0.2);
            climb.feel(senses, Vec2::Zero(), 0.5, settings);
        }
        QVERIFY(climb.sinks());
        double& z_m = senses.base_in_map.position_m.z();
        const double met_m = z_m;
        QVERIFY(climb.mayBePressed(met_m - 0.2));
        QVERIFY(!climb.mayBePressed(met_m - 0.5));
        while (climb.sinks() && z_m > met_m - 2.0) {
            z_m -= 0.05;
            step(climb, senses, {{"M0", 3.4}}, {});
        }
        QVERIFY2(std::abs(met_m - z_m - sinks_by_m) < 0.1, qPrintable(QString::number(met_m - z_m)));
    }

    void givesUpWhereverItsRingMeetsSomething() {
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        climbUnderSomething(climb, senses, 100);
        QVERIFY(!climb.active());
        QVERIFY(senses.position_m().z() < 6.0);
    }

    /// Crowns all around leave it no other place (random survey 98112).
    void doesNotClimbTwiceAtOnePlace_data() {
        QTest::addColumn<double>("room_m");
        QTest::addColumn<bool>("tries_again");
        QTest::newRow("in a gap between crowns") << 1.4 << false;
        QTest::newRow("on a clearing") << 6.0 << true;
    }
    void doesNotClimbTwiceAtOnePlace() {
        QFETCH(double, room_m);
        QFETCH(bool, tries_again);
        std::vector<Obstacle> crowns;
        for (int i = 0; i < 16; ++i)
            crowns.push_back(wallAt(room_m * std::cos(pi * i / 8.0), room_m * std::sin(pi * i / 8.0)));
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 15});
        climbUnderSomething(climb, senses, 1, crowns);
        QCOMPARE(climb.active(), tries_again);
        if (!tries_again)
            return;
        QVERIFY(senses.position2_m().norm() > 0.9);
        climbUnderSomething(climb, senses, 1, crowns);
        QVERIFY(climb.active()); // Another climb may do without the places of the one before.
    }

    void forgetsWhatAnotherClimbHasMet() {
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 15});
        for (int time = 0; time < 2; ++time) {
            climbUnderSomething(climb, senses, 2);
            QVERIFY(climb.active());
        }
    }

    void sinksNeitherToTheGroundNorBelowItsFloor_data() {
        QTest::addColumn<std::optional<double>>("ground_m");
        QTest::addColumn<double>("floor_m");
        QTest::addColumn<double>("lowest_m");
        QTest::newRow("low over the ground") << std::optional(3.5) << -25.0 << 5.7;
        QTest::newRow("over its floor") << std::optional<double>() << 5.5 << 5.5;
    }
    void sinksNeitherToTheGroundNorBelowItsFloor() {
        QFETCH(std::optional<double>, ground_m);
        QFETCH(double, floor_m);
        QFETCH(double, lowest_m);
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        senses.ground_m = ground_m;
        settings.floor_level_m = floor_m;
        climbUnderSomething(climb, senses, 3);
        QVERIFY2(senses.position_m().z() > lowest_m - 0.15, qPrintable(QString::number(senses.position_m().z())));
    }

    void doesNotBackAwayForever() {
        ClimbOver climb;
        Senses senses = sensesAt({0, 0, 6});
        const std::vector<Obstacle> crown{wallAt(2.0, 0.0)};
        climb.start(senses, crown, settings);
        QCOMPARE(step(climb, senses, {}, crown).state, ClimbState::Backing); // the robot does not move
        senses.now += Seconds(9.0);
        QCOMPARE(step(climb, senses, {}, crown).state, ClimbState::Climbing);
    }
};

USAR_TEST(tst_ClimbOver)

} // namespace tst_climb_over

#include "tst_climb_over.moc"
