#include <cmath>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/column.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_column {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Column : public QObject {
    Q_OBJECT

    static constexpr double climbs_m_s = 0.4;
    Column column;
    Senses senses;

    Column::Minding mind(double commanded_m_s = climbs_m_s, const std::vector<Obstacle>& known = {}) {
        senses.now += Seconds(0.2);
        return column.mind(senses, known, Vec2::Zero(), commanded_m_s);
    }

private slots:
    void init() {
        column = {};
        senses = sensesAt({0, 0, 6});
        senses.velocity_in_map_m_s.z() = climbs_m_s;
        setSonars(senses, {});
    }

    void climbsFreelyInTheOpen() {
        const auto minding = mind();
        QVERIFY(minding.at_most_m_s > 1.0 && !minding.turns);
    }

    void looksAroundAsItClimbsAmongTrunks() {
        const auto minding = mind(climbs_m_s, {wallAt(3, 0)});
        QVERIFY(minding.turns);
        QVERIFY(minding.at_most_m_s > 0.0 && minding.at_most_m_s < 0.4);
    }

    /// It stopped turning as soon as it was above what it had last heard of a trunk, and climbed into the crown behind
    /// it (random survey 167626).
    void looksAroundForAWhileAfterItHasHeardATrunk_data() {
        QTest::addColumn<double>("climbed_m");
        QTest::addColumn<bool>("turns");
        QTest::newRow("it has climbed by a meter and a half") << 1.5 << true;
        QTest::newRow("it has climbed by two and a half") << 2.5 << false;
    }
    void looksAroundForAWhileAfterItHasHeardATrunk() {
        QFETCH(double, climbed_m);
        QFETCH(bool, turns);
        setSonars(senses, {{"R4", 1.5}});
        QVERIFY(mind().turns);
        setSonars(senses, {});
        senses.base_in_map.position_m.z() += climbed_m;
        QCOMPARE(mind().turns, turns);
    }

    void sinksBackWhereACrownComesNearAndGoesWhereThereIsRoom() {
        setSonars(senses, {{"M0", 0.4}}); // ahead, which is east
        QVERIFY(mind().at_most_m_s < 0.0);
        senses.base_in_map.position_m.z() = 5.5;
        setSonars(senses, {}); // It is not as wide here, but the robot has not forgotten it.
        QVERIFY(mind().at_most_m_s < 0.0);
        senses.base_in_map.position_m.z() = 5.1;
        QCOMPARE(mind().at_most_m_s, 0.0);
        QVERIFY(column.at_m && column.at_m->x() < -1.0);
        QVERIFY(!column.there);
    }

    /// As random survey 114144 heard a crown from below before it broke at it.
    void sinksBackFromAFlatUnderside_data() {
        QTest::addColumn<QList<double>>("ahead_m");
        QTest::addColumn<QList<double>>("left_m");
        QTest::addColumn<bool>("sinks");
        const QList<double> nothing{5.0, 5.0, 5.0, 5.0};
        QTest::newRow("it comes down into the cones")
            << QList<double>{2.5, 2.0, 1.5, 1.1} << QList<double>{3.0, 2.1, 1.7, 1.3} << true;
        QTest::newRow("one sonar is turned along a side") << QList<double>{2.5, 2.0, 1.5, 1.1} << nothing << false;
        QTest::newRow("a trunk that it turns to")
            << QList<double>{5.0, 1.4, 1.4, 1.4} << QList<double>{1.4, 1.4, 5.0, 5.0} << false;
        QTest::newRow("slowly") << QList<double>{1.8, 1.6, 1.4, 1.25} << QList<double>{1.9, 1.7, 1.5, 1.35} << false;
        QTest::newRow("far away") << QList<double>{4.0, 3.5, 3.0, 2.5} << QList<double>{4.0, 3.5, 3.0, 2.5} << false;
    }
    void sinksBackFromAFlatUnderside() {
        QFETCH(QList<double>, ahead_m);
        QFETCH(QList<double>, left_m);
        QFETCH(bool, sinks);
        double at_most_m_s = 0.0;
        for (int tick = 0; tick < ahead_m.size(); ++tick) {
            setSonars(senses, {{"M0", ahead_m[tick]}, {"L2", left_m[tick]}});
            at_most_m_s = mind(climbs_m_s, {wallAt(-1.2, 0.0)}).at_most_m_s; // A trunk is as near all the time.
            senses.base_in_map.position_m.z() += 0.06;
        }
        QCOMPARE(at_most_m_s < 0.0, sinks);
    }

    void feelsATouchByItsLean_data() {
        QTest::addColumn<double>("climbs_m_s");
        QTest::addColumn<double>("pitch_rad");
        QTest::addColumn<int>("within_ticks");
        QTest::addColumn<bool>("touched");
        QTest::newRow("it climbs as it is told and comes to lean") << 0.4 << 0.1 << 3 << false;
        QTest::newRow("it is slower for a moment") << 0.1 << 0.0 << 1 << false;
        QTest::newRow("something presses its nose down") << 0.1 << 0.09 << 2 << true;
        QTest::newRow("something jolts it") << 0.4 << 0.06 << 1 << true;
    }
    void feelsATouchByItsLean() {
        QFETCH(double, climbs_m_s);
        QFETCH(double, pitch_rad);
        QFETCH(int, within_ticks);
        QFETCH(bool, touched);
        for (int tick = 0; tick < 6; ++tick)
            QVERIFY(mind().at_most_m_s > 0.0);
        senses.velocity_in_map_m_s.z() = climbs_m_s;
        double at_most_m_s = 0.0;
        for (int tick = 0; tick < within_ticks; ++tick) {
            senses.base_in_map.pitch_rad += pitch_rad / within_ticks;
            at_most_m_s = mind().at_most_m_s;
        }
        QCOMPARE(at_most_m_s < 0.0, touched);
        if (!touched)
            return;
        senses.base_in_map.position_m.z() = 5.0;
        mind();
        QVERIFY(column.at_m && column.at_m->x() < 0.0); // away from what it has met
    }

    void staysWellAboveTheGround() {
        senses.ground_m = 3.5;
        setSonars(senses, {{"M0", 0.4}});
        QVERIFY(mind().at_most_m_s < 0.0);
        senses.base_in_map.position_m.z() = 5.65;
        QCOMPARE(mind().at_most_m_s, 0.0);
    }

    /// It has met a crown above itself, and crowns stand all around (random survey 98112).
    void doesNotClimbTwiceAtOnePlace_data() {
        QTest::addColumn<double>("room_m");
        QTest::addColumn<bool>("gives_up");
        QTest::newRow("in a gap between crowns") << 1.2 << true;
        QTest::newRow("on a clearing") << 6.0 << false;
    }
    void doesNotClimbTwiceAtOnePlace() {
        QFETCH(double, room_m);
        QFETCH(bool, gives_up);
        for (int tick = 0; tick < 6; ++tick)
            mind();
        senses.scan = PlacedScan{{1}, {}, {}, {}};
        for (int i = 0; i < 32; ++i)
            senses.scan->hits_in_map_m.emplace_back(room_m * std::cos(pi * i / 16.0), room_m * std::sin(pi * i / 16.0),
                                                    5.0);
        senses.velocity_in_map_m_s.z() = 0.1;
        senses.base_in_map.pitch_rad = 0.1;
        QVERIFY(mind().at_most_m_s < 0.0);
        QVERIFY(!column.givesUp());
        QVERIFY(column.mayMeetAgain({3.0, 0.0, 5.5})); // whether it gives up or not
        QVERIFY(!column.mayMeetAgain({3.0, 0.0, 4.0}) && !column.mayMeetAgain({6.0, 0.0, 5.5}));
        QVERIFY(!column.mayMeetAgain({0.0, 0.0, 7.0}));
        senses.base_in_map.position_m.z() = 5.0;
        mind();
        QCOMPARE(column.givesUp(), gives_up);
        QCOMPARE(column.at_m.value().norm() < in_column_m, gives_up);
        column.moveTo({0, 0}, senses.now); // Something is in the way to another place.
        QVERIFY(column.givesUp());
    }

    void givesUpWhereThereIsRoomNowhere() {
        for (int tries = 0; tries < 4; ++tries) {
            QVERIFY(!column.givesUp());
            senses.base_in_map.position_m.z() = 6.0;
            setSonars(senses, {{"M0", 0.4}});
            mind();
            senses.base_in_map.position_m.z() = 5.0;
            mind();
        }
        QVERIFY(column.givesUp());
    }
};

USAR_TEST(tst_Column)

} // namespace tst_column

#include "tst_column.moc"
