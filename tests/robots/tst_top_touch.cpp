#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/top_touch.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_top_touch {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_TopTouch : public QObject {
    Q_OBJECT

private slots:
    /// A wire pressed its nose down as it climbed at 1 m/s on its way (survey 156086).
    void feelsWhatPressesOneSideDown_data() {
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<double>("pitch_before_rad");
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<double>("faster_m_s");
        QTest::addColumn<bool>("feels");
        QTest::newRow("a wire above its nose") << 1.0 << 0.04 << 0.27 << 0.0 << true;
        QTest::newRow("a wire above its tail") << 1.0 << 0.04 << -0.2 << 0.0 << true;
        QTest::newRow("it does not climb") << 0.0 << 0.04 << 0.27 << 0.0 << false;
        QTest::newRow("it leans against the wind all the time") << 1.0 << 0.27 << 0.28 << 0.0 << false;
        QTest::newRow("it is told to fly faster") << 1.0 << 0.04 << 0.27 << 1.2 << false;
        QTest::newRow("it does not lean yet as it is told") << 1.0 << 0.04 << 0.04 << -1.2 << false;
        QTest::newRow("a gust") << 1.0 << 0.04 << 0.14 << 0.0 << false;
    }
    void feelsWhatPressesOneSideDown() {
        QFETCH(double, climb_m_s);
        QFETCH(double, pitch_before_rad);
        QFETCH(double, pitch_rad);
        QFETCH(double, faster_m_s);
        QFETCH(bool, feels);
        TopTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        senses.velocity_in_map_m_s = {1.5, 0.0, climb_m_s};
        senses.base_in_map.pitch_rad = pitch_before_rad;
        for (int tick = 0; tick < 6; ++tick) {
            senses.now += Seconds(0.2);
            QVERIFY(!touch.free(senses, {Vec2(1.5, 0.0), climb_m_s}));
        }
        senses.now += Seconds(0.2);
        senses.base_in_map.pitch_rad = pitch_rad;
        const auto sinks = touch.free(senses, {Vec2(1.5 + faster_m_s, 0.0), climb_m_s});
        QCOMPARE(sinks.has_value(), feels);
        QCOMPARE(touch.met_m().has_value(), feels);
        if (!feels)
            return;
        QVERIFY(sinks->climb_m_s < -0.3 && sinks->velocity_in_map_m_s.isZero());
        QCOMPARE(touch.met_m()->x() > 0.3, pitch_rad > pitch_before_rad);
        QVERIFY(touch.met_m()->z() > 6.0);
        int ticks = 0;
        while (touch.free(senses, {Vec2::Zero(), -0.5})) {
            senses.now += Seconds(0.2);
            QVERIFY(!touch.met_m() && ++ticks < 8);
        }
        QVERIFY(ticks > 4);
    }

    /// A crown above one side of its ring broke a rotor half a second after it had touched it (random survey 167584).
    void feelsWhatHoldsASlowClimbSooner_data() {
        QTest::addColumn<double>("climb_m_s");
        QTest::addColumn<double>("climbs_m_s");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<bool>("feels");
        QTest::newRow("it is slower than it is told") << 0.3 << 0.2 << 0.1 << true;
        QTest::newRow("it climbs as it is told") << 0.3 << 0.3 << 0.1 << false;
        QTest::newRow("it climbs fast") << 1.0 << 0.7 << 0.1 << false;
        QTest::newRow("it is on its way") << 0.3 << 0.2 << 1.0 << false;
    }
    void feelsWhatHoldsASlowClimbSooner() {
        QFETCH(double, climb_m_s);
        QFETCH(double, climbs_m_s);
        QFETCH(double, speed_m_s);
        QFETCH(bool, feels);
        TopTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        senses.velocity_in_map_m_s = {speed_m_s, 0.0, climb_m_s};
        for (int tick = 0; tick < 6; ++tick) {
            senses.now += Seconds(0.2);
            QVERIFY(!touch.free(senses, {Vec2(speed_m_s, 0.0), climb_m_s}));
        }
        senses.now += Seconds(0.2);
        senses.velocity_in_map_m_s.z() = climbs_m_s;
        senses.base_in_map.pitch_rad = 0.12;
        QCOMPARE(touch.free(senses, {Vec2(speed_m_s, 0.0), climb_m_s}).has_value(), feels);
    }

    /// Such a pose is not used until more agree, and then it is too late.
    void sinksWhereItsLeanCannotBeBelieved_data() {
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("in the air") << 6.0 << true;
        QTest::newRow("as it lifts off from a slope") << 1.0 << false;
    }
    void sinksWhereItsLeanCannotBeBelieved() {
        QFETCH(double, height_m);
        QFETCH(bool, sinks);
        TopTouch touch;
        Senses senses = sensesAt({0, 0, 6});
        senses.ground_m = 6.0 - height_m;
        QVERIFY(!touch.free(senses, {Vec2(1.5, 0.0), 1.0}));
        senses.ins_age = Seconds(0.2);
        senses.leans_beyond_belief = true;
        const auto motion = touch.free(senses, {Vec2(1.5, 0.0), 1.0});
        QCOMPARE(motion.has_value(), sinks);
        QVERIFY(!sinks || motion->climb_m_s < -0.3);
        QVERIFY(!touch.met_m()); // It does not know on which side.
    }
};

USAR_TEST(tst_TopTouch)

} // namespace tst_top_touch

#include "tst_top_touch.moc"
