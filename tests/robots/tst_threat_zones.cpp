#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/flight/threat_zones.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_threat_zones {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;
using agent::Risk;

class tst_ThreatZones : public QObject {
    Q_OBJECT

private slots:
    void sortsBearingsIntoRings_data() {
        QTest::addColumn<double>("bearing_deg");
        QTest::addColumn<int>("ring");
        QTest::newRow("nose") << 0.0 << 0;
        QTest::newRow("left") << 18.0 << 1;
        QTest::newRow("right") << -36.0 << 2;
        QTest::newRow("wrapped") << 360.0 - 54.0 << 3;
        QTest::newRow("side") << 72.0 << 4;
        QTest::newRow("behind") << 180.0 << 4;
    }
    void sortsBearingsIntoRings() {
        QFETCH(double, bearing_deg);
        QFETCH(int, ring);
        QCOMPARE(ringOf(radians(bearing_deg)), std::size_t(ring));
    }

    void judgesAnEchoByItsZone_data() {
        QTest::addColumn<QString>("sonar");
        QTest::addColumn<double>("range_m");
        QTest::addColumn<int>("risk");
        QTest::newRow("front, far") << "M0" << 4.6 << int(Risk::None);
        QTest::newRow("front, low") << "M0" << 4.4 << int(Risk::Low);
        QTest::newRow("front, high") << "M0" << 2.1 << int(Risk::High);
        QTest::newRow("side, same distance, none") << "L4" << 2.3 << int(Risk::None);
        QTest::newRow("side, low") << "R4" << 2.1 << int(Risk::Low);
        QTest::newRow("side, high") << "R4" << 1.0 << int(Risk::High);
    }
    void judgesAnEchoByItsZone() {
        QFETCH(QString, sonar);
        QFETCH(double, range_m);
        QFETCH(int, risk);
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{sonar.toStdString(), range_m}});
        QCOMPARE(int(judgeThreats(senses, {}).risk), risk);
    }

    void namesTheNearestOfTheWorst() {
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{"L4", 1.5}, {"M0", 2.0}, {"R1", 1.9}});
        const ThreatPicture picture = judgeThreats(senses, {});
        QCOMPARE(picture.risk, Risk::High);
        QCOMPARE(picture.zones[*picture.greatest].name, std::string("R1")); // L4 is nearer, but a low risk only
        QCOMPARE(picture.zones.size(), std::size_t(9));
        QCOMPARE(picture.zones.front().name, std::string("L4"));
    }

    void leavesOutWhatPassesBelowOrAbove_data() {
        QTest::addColumn<double>("low_m");
        QTest::addColumn<double>("high_m");
        QTest::addColumn<bool>("threat");
        QTest::newRow("at our level") << 5.8 << 6.2 << true;
        QTest::newRow("the ground, seen while braking") << 4.0 << 5.0 << false;
        QTest::newRow("a crown far above") << 7.0 << 8.0 << false;
        QTest::newRow("its rim at our level") << 4.0 << 5.9 << true;
    }
    void leavesOutWhatPassesBelowOrAbove() {
        QFETCH(double, low_m);
        QFETCH(double, high_m);
        QFETCH(bool, threat);
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{"M0", 2.0}});
        senses.sonars[4].low_m = low_m;
        senses.sonars[4].high_m = high_m;
        QCOMPARE(judgeThreats(senses, {}).risk != Risk::None, threat);
    }

    void knowsWhatIsOnItsWay_data() {
        QTest::addColumn<QString>("sonar");
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("way_deg");
        QTest::addColumn<bool>("clear");
        QTest::newRow("before it, high") << "M0" << 2.1 << 0.0 << false;
        QTest::newRow("before it, low") << "M0" << 4.0 << 0.0 << true;
        QTest::newRow("on its left") << "L3" << 1.2 << 0.0 << true;
        QTest::newRow("on its left, to where it flies") << "L3" << 1.2 << 60.0 << false;
        QTest::newRow("before it as it flies backward") << "M0" << 2.1 << 180.0 << true;
    }
    void knowsWhatIsOnItsWay() {
        QFETCH(QString, sonar);
        QFETCH(double, range_m);
        QFETCH(double, way_deg);
        QFETCH(bool, clear);
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{sonar.toStdString(), range_m}});
        const ThreatPicture picture = judgeThreats(senses, {});
        QVERIFY(picture.risk != Risk::None);
        QCOMPARE(isWayClear(picture, radians(way_deg)), clear);
        QCOMPARE(noThreats(picture).risk, Risk::None);
        QVERIFY(!noThreats(picture).greatest);
        QCOMPARE(noThreats(picture).zones.size(), picture.zones.size());
    }

    void followsItsParameters() {
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, {{"M0", 3.0}});
        Settings settings;
        settings.low_risk_0_m = 2.9;
        settings.high_risk_0_m = 1.0;
        QCOMPARE(judgeThreats(senses, settings).risk, Risk::None);
    }
};

USAR_TEST(tst_ThreatZones)

} // namespace tst_threat_zones

#include "tst_threat_zones.moc"
