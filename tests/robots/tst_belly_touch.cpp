#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/belly_touch.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_belly_touch {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_BellyTouch : public QObject {
    Q_OBJECT

    static constexpr Seconds tick{0.2};
    BellyTouch touch;
    Senses senses;

    /// One tick of a robot that moves like this whatever it is told.
    std::optional<Motion> fly(const Vec3& velocity_m_s, const BellyTouch::Doing& doing) {
        senses.now += tick;
        senses.velocity_in_map_m_s = velocity_m_s;
        senses.base_in_map.position_m += tick.count() * velocity_m_s;
        return touch.free(senses, Vec2::Zero(), doing);
    }

private slots:
    void init() {
        touch = {};
        senses = sensesAt({0, 0, 9});
    }

    void risesFromWhatItRestsOn_data() {
        QTest::addColumn<double>("sinks_m_s");
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<double>("ground_m");
        QTest::addColumn<bool>("lands");
        QTest::addColumn<bool>("rests");
        QTest::newRow("on a wire below its nose") << 0.05 << -0.1 << 0.0 << false << true;
        QTest::newRow("on a wire as it lands") << 0.05 << -0.1 << 0.0 << true << true;
        QTest::newRow("it sinks as it is told") << 0.6 << -0.1 << 0.0 << false << false;
        QTest::newRow("it sinks slowly") << 0.3 << -0.1 << 0.0 << false << false;
        QTest::newRow("its estimate hangs, and it does not lean") << 0.0 << 0.0 << 0.0 << false << false;
        QTest::newRow("it lands on the ground") << 0.0 << -0.1 << 8.8 << true << false;
        // The belly scanner takes that for ground, as in random survey 140005.
        QTest::newRow("on the edge of a rack") << 0.0 << -0.1 << 8.8 << false << true;
    }
    void risesFromWhatItRestsOn() {
        QFETCH(double, sinks_m_s);
        QFETCH(double, pitch_rad);
        QFETCH(double, ground_m);
        QFETCH(bool, lands);
        QFETCH(bool, rests);
        senses.ground_m = ground_m;
        const BellyTouch::Doing sinking{.climb_m_s = -0.6, .to_ground = lands};
        for (int i = 0; i < 10; ++i)
            QVERIFY(!fly({0, 0, -0.6}, {.climb_m_s = -0.6, .speed_m_s = 1.0}));
        if (ground_m > 0.0)
            senses.base_in_map.position_m.z() = ground_m + 0.3;
        senses.base_in_map.pitch_rad = pitch_rad;
        std::optional<Motion> freeing;
        for (int i = 0; i < 6 && !freeing; ++i)
            freeing = fly({0, 0, -sinks_m_s}, sinking);
        QCOMPARE(freeing.has_value(), rests);
        if (!rests)
            return;
        QVERIFY(freeing->climb_m_s > 0.3);
        QVERIFY(touch.met_m()->x() > 0.2 && touch.met_m()->z() < senses.position_m().z());
        int ticks = 0;
        while (fly({0, 0, 0.4}, {.climb_m_s = 0.42}))
            QVERIFY(++ticks < 15);
        QVERIFY(ticks > 7); // It rises well above that.
    }

    /// As the edge of a rack tipped it in random survey 131077: it sinks all the while.
    void risesAsItTips_data() {
        QTest::addColumn<double>("roll_rad");
        QTest::addColumn<bool>("wind");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("leans_more");
        QTest::addColumn<bool>("rises");
        QTest::newRow("over an edge") << -0.28 << false << 0.0 << 0.0 << true;
        QTest::newRow("it leans a little") << -0.15 << false << 0.0 << 0.0 << false;
        QTest::newRow("it turns in wind") << -0.28 << true << 0.0 << 0.0 << false;
        QTest::newRow("it brakes") << -0.28 << false << 0.6 << 0.0 << false;
        QTest::newRow("it backs away, and leans a little more") << -0.28 << false << 0.6 << 0.15 << false;
        QTest::newRow("it backs away over an edge") << -0.28 << false << 0.6 << 0.3 << true; // survey 160949
        QTest::newRow("over an edge in wind") << -0.28 << true << 0.0 << 0.3 << true;
    }
    void risesAsItTips() {
        QFETCH(double, roll_rad);
        QFETCH(bool, wind);
        QFETCH(double, speed_m_s);
        QFETCH(double, leans_more);
        QFETCH(bool, rises);
        BellyTouch::Doing sinking{.climb_m_s = -0.3, .in_wind = wind};
        for (int i = 0; i < 6; ++i)
            QVERIFY(!fly({0, speed_m_s, -0.3}, sinking));
        senses.base_in_map.roll_rad = roll_rad;
        sinking.leans_more = leans_more;
        QCOMPARE(fly({0, speed_m_s, -0.5}, sinking).has_value(), rises);
    }

    /// It rises from a rack, and another shelf of that holds its rear down (random survey 97541).
    void sinksFromWhatHoldsItsRise_data() {
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<bool>("wind");
        QTest::addColumn<bool>("sinks");
        QTest::newRow("its rear is held") << -0.2 << false << true;
        QTest::newRow("it leans a little") << -0.12 << false << false;
        QTest::newRow("in wind") << -0.2 << true << false;
    }
    void sinksFromWhatHoldsItsRise() {
        QFETCH(double, pitch_rad);
        QFETCH(bool, wind);
        QFETCH(bool, sinks);
        senses.base_in_map.pitch_rad = 0.25; // more than later, but it rests
        std::optional<Motion> freeing;
        for (int i = 0; i < 12 && !freeing; ++i)
            freeing = fly({0, 0, i < 4 ? -0.4 : 0.0}, {.climb_m_s = -0.4, .in_wind = wind});
        QVERIFY(freeing.value().climb_m_s > 0.3);
        QVERIFY(fly({0, 0, 0.2}, {.climb_m_s = 0.42, .in_wind = wind}).value().climb_m_s > 0.3);
        senses.base_in_map.pitch_rad = 0.0;
        QVERIFY(fly({0, 0, 0.3}, {.climb_m_s = 0.42, .in_wind = wind}).value().climb_m_s > 0.3);
        senses.base_in_map.pitch_rad = pitch_rad;
        freeing = fly({0, 0, 0.2}, {.climb_m_s = 0.42, .in_wind = wind});
        QCOMPARE(freeing.value().climb_m_s < -0.2, sinks);
        int ticks = 0;
        while (sinks && (freeing = fly({0, 0, -0.2}, {.climb_m_s = -0.3}))) {
            QVERIFY(freeing->climb_m_s < 0.0 && ++ticks < 8); // It is not taken to tip over an edge.
            if (ticks == 3)
                senses.base_in_map.pitch_rad = 0.0;
        }
        QCOMPARE(ticks > 3, sinks);
    }

    void feelsNothingBelowARoof() {
        senses.base_in_map.roll_rad = 0.2;
        for (int i = 0; i < 10; ++i)
            QVERIFY(!fly({0, 0, 0}, {.climb_m_s = -0.3, .from_above = true}));
    }

    /// Its ring has met the edge of a shelf, and it still climbs as it is told to sink (random survey 145237).
    void doesNotTakeWhatIsAboveItForWhatItRestsOn() {
        for (int i = 0; i < 6; ++i)
            QVERIFY(!fly({0, 0, 0.45}, {.climb_m_s = 0.5}));
        senses.base_in_map.roll_rad = -0.28;
        for (int i = 0; i < 2; ++i)
            QVERIFY(!fly({0, 0, 0.25}, {.climb_m_s = -0.5}));
    }

    void doesNotTakeAClimbThatEndsForATouch() {
        senses.base_in_map.pitch_rad = -0.3; // It brakes.
        double climbs_m_s = 1.0;
        for (int i = 0; i < 10; ++i)
            QVERIFY(!fly({1, 0, climbs_m_s}, {.climb_m_s = 1.0}));
        for (int i = 0; i < 10; ++i) {
            climbs_m_s += 0.33 * (-0.6 - climbs_m_s); // as it follows in `quick_scan`
            QVERIFY(!fly({1, 0, climbs_m_s}, {.climb_m_s = -0.6}));
        }
    }
};

USAR_TEST(tst_BellyTouch)

} // namespace tst_belly_touch

#include "tst_belly_touch.moc"
