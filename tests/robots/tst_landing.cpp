#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/landing.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_landing {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Landing : public QObject {
    Q_OBJECT

    static ObstacleMemory meadow(const std::vector<Vec3>& things = {}) {
        ObstacleMemory memory;
        Senses senses = sensesAt({0, 0, 6});
        setFlatScan(senses, {0, 0}, 10.0, 0.0);
        senses.scan->hits_in_map_m.insert(senses.scan->hits_in_map_m.end(), things.begin(), things.end());
        memory.take(senses, {});
        return memory;
    }

private slots:
    void landsWhereItIsWanted() { QCOMPARE(landingPlace_m(meadow(), {1, 1}, 4.0), Vec2(1, 1)); }

    void stepsAsideForABush() {
        const Vec2 place_m = landingPlace_m(meadow({Vec3(0.2, 0.2, 0.9)}), {0, 0}, 4.0);
        QVERIFY((place_m - Vec2(0.2, 0.2)).norm() > 1.2);
        QVERIFY(place_m.norm() <= 4.0);
    }

    void staysWithinItsRadius() { QCOMPARE(landingPlace_m(meadow({Vec3(0.2, 0.2, 0.9)}), {0, 0}, 0.0), Vec2(0, 0)); }

    void takesTheWantedPlaceWhereNothingIsKnown() {
        QCOMPARE(landingPlace_m(ObstacleMemory(), {3, 4}, 5.0), Vec2(3, 4));
    }

    void sinksSlowlyNearTheGround() {
        const Settings settings;
        Touchdown touchdown;
        Senses senses = sensesAt({0, 0, 6});
        QCOMPARE(touchdown.sinkRate_m_s(senses, settings), settings.descent_speed_m_s);
        senses.ground_m = 4.0;
        QCOMPARE(touchdown.sinkRate_m_s(senses, settings), settings.landing_speed_m_s);
        senses.ground_m.reset(); // too near for the scanner, or too far: slowly
        QCOMPARE(touchdown.sinkRate_m_s(senses, settings), settings.landing_speed_m_s);
    }

    void noticesTheTouchAfterASecondOfStillness_data() {
        QTest::addColumn<double>("tick_s");
        QTest::addColumn<int>("ticks");
        QTest::newRow("UT2004") << 0.2 << 6;
        QTest::newRow("UDK") << 0.1 << 11;
    }
    void noticesTheTouchAfterASecondOfStillness() {
        QFETCH(double, tick_s);
        QFETCH(int, ticks);
        Touchdown touchdown;
        touchdown.start();
        Senses senses = sensesAt({0, 0, 0.3});
        senses.ground_m = 0.1;
        const auto touchedAfterTick = [&] {
            senses.now += Seconds(tick_s);
            return touchdown.touched(senses);
        };
        senses.velocity_in_map_m_s = {0, 0, -0.3};
        for (int i = 0; i < 20; ++i)
            QVERIFY(!touchedAfterTick());
        senses.velocity_in_map_m_s = {0, 0, 0};
        int still_ticks = 1;
        while (!touchedAfterTick() && still_ticks < 100)
            ++still_ticks;
        QCOMPARE(still_ticks, ticks);
    }

    void takesNoStillnessInTheAirForATouch() {
        Touchdown touchdown;
        touchdown.start();
        for (int i = 0; i < 50; ++i)
            QVERIFY(!touchdown.touched(sensesAt({0, 0, 6}, 0.0, 0.2 * i)));
    }
};

USAR_TEST(tst_Landing)

} // namespace tst_landing

#include "tst_landing.moc"
