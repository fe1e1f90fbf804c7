#include <cmath>
#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/side_touch.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_side_touch {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_SideTouch : public QObject {
    Q_OBJECT

private slots:
    void feelsWhatTurnsTheRobot_data() {
        QTest::addColumn<double>("told_rad_s");
        QTest::addColumn<double>("turns_rad_s");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("feels");
        QTest::addColumn<bool>("to_the_left");
        QTest::newRow("something to its left") << 0.0 << 0.25 << 0.8 << 6.0 << true << true;
        QTest::newRow("something to its right") << 0.0 << -0.25 << 0.8 << 6.0 << true << false;
        QTest::newRow("it turns as it is told") << 0.6 << 0.55 << 0.8 << 6.0 << false << false;
        QTest::newRow("it is held as it turns") << 0.6 << 0.9 << 0.8 << 6.0 << true << true;
        QTest::newRow("it turns a little") << 0.0 << 0.05 << 0.8 << 6.0 << false << false;
        QTest::newRow("it stands") << 0.0 << 0.25 << 0.0 << 6.0 << false << false;
        QTest::newRow("on the ground") << 0.0 << 0.25 << 0.8 << 0.4 << false << false;
    }
    void feelsWhatTurnsTheRobot() {
        QFETCH(double, told_rad_s);
        QFETCH(double, turns_rad_s);
        QFETCH(double, speed_m_s);
        QFETCH(double, height_m);
        QFETCH(bool, feels);
        QFETCH(bool, to_the_left);
        SideTouch touch;
        Senses senses = sensesAt({0, 0, height_m});
        senses.ground_m = 0.0;
        senses.ins_yaw_rate_rad_s = turns_rad_s;
        const SideTouch::Doing doing{told_rad_s, Vec2(speed_m_s, 0.0)};
        std::optional<Motion> away;
        for (int tick = 0; tick < 5 && !away; ++tick) {
            senses.now += Seconds(0.2);
            away = touch.free(senses, doing);
        }
        QCOMPARE(away.has_value(), feels);
        if (!feels)
            return;
        const Vec3 met_m = touch.met_m().value();
        QVERIFY(met_m.x() > 0.3 && met_m.z() > height_m);
        QCOMPARE(met_m.y() > 0.0, to_the_left);
        QVERIFY(away->velocity_in_map_m_s.dot(met_m.head<2>()) < 0.0);
        QVERIFY(away->climb_m_s < -0.2);
        senses.ins_yaw_rate_rad_s = 0.0;
        int ticks = 0;
        while (touch.free(senses, doing)) {
            senses.now += Seconds(0.2);
            QVERIFY(!touch.met_m() && ++ticks < 8);
        }
        QVERIFY(ticks > 4);
    }

    /// Beside racks, it sank onto one, which turned it over (surveys 168461 and 168653).
    void doesNotSinkOntoWhatIsBelow_data() {
        QTest::addColumn<bool>("over_things");
        QTest::newRow("over a rack") << true;
        QTest::newRow("over the ground") << false;
    }
    void doesNotSinkOntoWhatIsBelow() {
        QFETCH(bool, over_things);
        SideTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        senses.ground_m = 0.0;
        setSonars(senses, {{"M0", 0.1}});
        const auto away = touch.free(senses, {.velocity_in_map_m_s = Vec2(0.4, 0.0), .over_things = over_things});
        QVERIFY(away && away->velocity_in_map_m_s.x() < -0.3);
        QCOMPARE(away->climb_m_s < 0.0, !over_things);
    }

    /// A beam below a roof held it, and it took that for wind (survey 163333).
    void backsAwayFromWhatHoldsItFast_data() {
        QTest::addColumn<double>("told_m_s");
        QTest::addColumn<double>("moves_m_s");
        QTest::addColumn<bool>("held");
        QTest::newRow("it does not move at all") << 1.3 << 0.0 << true;
        QTest::newRow("wind lets it hardly get on") << 1.3 << 0.05 << false;
        QTest::newRow("it stands") << 0.0 << 0.0 << false;
    }
    void backsAwayFromWhatHoldsItFast() {
        QFETCH(double, told_m_s);
        QFETCH(double, moves_m_s);
        QFETCH(bool, held);
        SideTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        senses.ground_m = 0.0;
        std::optional<Motion> away;
        bool fast = false;
        for (int tick = 0; tick < 30 && !away; ++tick) {
            senses.now += Seconds(0.2);
            senses.base_in_map.position_m.x() += 0.2 * moves_m_s;
            away = touch.free(senses, {0.0, Vec2(told_m_s, 0.0)});
            fast = touch.holdsFast();
        }
        QCOMPARE(away.has_value(), held);
        QCOMPARE(fast, held);
        if (held)
            QVERIFY(away->velocity_in_map_m_s.x() < -0.3 && away->climb_m_s < -0.2 && touch.met_m()->x() > 0.3);
    }

    /// It meets something as it turns back: that lies where it came from.
    void knowsThatItMetThatBeforeItTurnedBack() {
        SideTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        for (int tick = 0; tick < 5; ++tick) {
            senses.now += Seconds(0.2);
            QVERIFY(!touch.free(senses, {0.0, Vec2(-0.8, 0.0)}));
        }
        senses.ins_yaw_rate_rad_s = -0.3;
        for (int tick = 0; tick < 2; ++tick) {
            senses.now += Seconds(0.2);
            touch.free(senses, {0.0, Vec2(0.8, 0.0)});
        }
        QVERIFY(touch.met_m().value().x() < -0.3);
    }

    /// It passes a crown too closely (survey 96575).
    void backsAwayFromWhatItHears() {
        SideTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{"R4", 0.1}, {"M0", 3.0}});
        senses.ins_yaw_rate_rad_s = -0.6;
        std::optional<Motion> away;
        for (int tick = 0; tick < 3; ++tick) {
            senses.now += Seconds(0.2);
            away = touch.free(senses, {0.0, Vec2(1.5, 0.0)});
        }
        QVERIFY(away.value().velocity_in_map_m_s.y() > 0.4); // R4 looks to the right.
    }

    /// It leans toward a crown that holds its nose, and does not turn (survey 131616).
    void feelsWhatItHearsAtItsRing_data() {
        QTest::addColumn<double>("heard_m");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<bool>("lands");
        QTest::addColumn<bool>("feels");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("at its ring") << 0.1 << 6.0 << 0.0 << false << true << true;
        QTest::newRow("as it lands") << 0.1 << 6.0 << 0.0 << true << true << false;
        QTest::newRow("a little before it") << 0.4 << 6.0 << 0.0 << false << false << false;
        QTest::newRow("as it sinks") << 0.1 << 6.0 << -0.5 << false << true << false;
        QTest::newRow("as it rises") << 0.1 << 6.0 << 0.5 << false << true << true;
        QTest::newRow("low down") << 0.1 << 1.0 << 0.0 << false << true << false;
        QTest::newRow("on the ground") << 0.1 << 0.4 << 0.0 << false << false << false;
    }
    void feelsWhatItHearsAtItsRing() {
        QFETCH(double, heard_m);
        QFETCH(double, height_m);
        QFETCH(double, climb_m_s);
        QFETCH(bool, lands);
        QFETCH(bool, feels);
        QFETCH(bool, sinks);
        SideTouch touch;
        Senses senses = sensesAt({0, 0, height_m});
        senses.ground_m = 0.0;
        setSonars(senses, {{"L3", heard_m}, {"L2", heard_m + 0.05}, {"R4", 2.0}});
        const auto away = touch.free(senses, {0.0, Vec2(1.0, 0.0), climb_m_s, lands});
        QCOMPARE(away.has_value(), feels);
        if (!feels)
            return;
        const Vec2& away_m_s = away->velocity_in_map_m_s;
        QVERIFY(std::abs(std::atan2(-away_m_s.y(), -away_m_s.x()) - radians(45.0)) < radians(2.0)); // between L2 and L3
        QCOMPARE(away->climb_m_s < 0.0, sinks);
        senses.now += Seconds(0.2);
        setSonars(senses, {{"M0", heard_m}}); // It has turned toward that, which goes on holding it.
        const auto later = touch.free(senses, {0.0, Vec2(1.0, 0.0), -0.4});
        QVERIFY(later.value().velocity_in_map_m_s.x() < -0.4);
        QCOMPARE(later->climb_m_s < 0.0, sinks);
    }

    /// The robot still turns when it has been told to stop.
    void doesNotTakeATurnThatEndsForATouch() {
        SideTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        double told_rad_s = 0.6;
        for (int tick = 0; tick < 15; ++tick) {
            senses.now += Seconds(0.2);
            if (tick == 5)
                told_rad_s = 0.0;
            senses.ins_yaw_rate_rad_s += 0.4 * (told_rad_s - senses.ins_yaw_rate_rad_s);
            senses.base_in_map.position_m.x() += 0.2;
            QVERIFY(!touch.free(senses, {told_rad_s, Vec2(1.0, 0.0)}));
        }
    }
};

USAR_TEST(tst_SideTouch)

} // namespace tst_side_touch

#include "tst_side_touch.moc"
