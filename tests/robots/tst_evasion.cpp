#include <QObject>
#include <QString>
#include <QTest>

#include "robots/airrobot/flight/evasion.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_evasion {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Evasion : public QObject {
    Q_OBJECT

    using Ranges = std::vector<std::pair<std::string, double>>;

    static ThreatPicture pictureOf(const Ranges& ranges) {
        Senses senses = sensesAt({0, 0, 6});
        setSonars(senses, ranges);
        return judgeThreats(senses, {});
    }
    static EvasionDecision decide(Evasion& evasion, const Ranges& ranges, const std::vector<Obstacle>& obstacles = {},
                                  const Vec2& goal_m = {20, 0}, double now_s = 100.0) {
        Senses senses = sensesAt({0, 0, 6}, 0.0, now_s);
        setSonars(senses, ranges);
        const ThreatPicture picture = judgeThreats(senses, {});
        evasion.observe(senses, picture, goal_m, {});
        return evasion.decide(senses, picture, obstacles, {});
    }
    static bool near(double a_rad, double b_rad) { return std::abs(normalizedAngle(a_rad - b_rad)) < 1e-6; }

private slots:
    void picksTheFirstFreeSonarOnTheFreerSide_data() {
        QTest::addColumn<QString>("near_sonars");
        QTest::addColumn<double>("bearing_deg");
        QTest::newRow("front, left freer") << "M0:4 R1:4 R2:4.5" << 18.0;
        QTest::newRow("front, right freer") << "M0:4 L1:4.1 L3:3" << -18.0;
        QTest::newRow("free sonar two steps on") << "M0:3 L1:3.5 R1:3.2 R2:3.1 R3:2 R4:2" << 36.0;
        QTest::newRow("left side blocked to the end") << "L4:2 L3:2 L2:2 L1:2 M0:2.5" << -18.0;
    }
    void picksTheFirstFreeSonarOnTheFreerSide() {
        QFETCH(QString, near_sonars);
        QFETCH(double, bearing_deg);
        Ranges ranges;
        for (const QString& item : near_sonars.split(' '))
            ranges.emplace_back(item.section(':', 0, 0).toStdString(), item.section(':', 1).toDouble());
        const auto bearing = freeBearing(pictureOf(ranges));
        QVERIFY(bearing);
        QVERIFY2(near(*bearing, radians(bearing_deg)), qPrintable(QString::number(degrees(*bearing))));
    }

    void findsNoFreeBearingInACorner() {
        Ranges all;
        for (const SonarMount& sonar : stockLayout().sonars)
            all.emplace_back(sonar.name, 2.0);
        QVERIFY(!freeBearing(pictureOf(all)));
        QVERIFY(!freeBearing(pictureOf({}))); // nothing is a threat: nothing to be free of
    }

    void ignoresAThreatThatDoesNotMatter_data() {
        QTest::addColumn<double>("goal_bearing_deg");
        QTest::addColumn<double>("goal_distance_m");
        QTest::addColumn<bool>("ignored");
        QTest::newRow("goal behind the obstacle") << 0.0 << 20.0 << false;
        QTest::newRow("goal nearer than the obstacle") << 0.0 << 3.0 << true;
        QTest::newRow("goal farther out than the way round") << 40.0 << 20.0 << true;
        QTest::newRow("goal out on the other side") << -40.0 << 20.0 << false;
    }
    void ignoresAThreatThatDoesNotMatter() {
        QFETCH(double, goal_bearing_deg);
        QFETCH(double, goal_distance_m);
        QFETCH(bool, ignored);
        const ThreatPicture picture = pictureOf({{"M0", 4.0}});
        QCOMPARE(mayIgnore(picture, radians(18.0), radians(goal_bearing_deg), goal_distance_m), ignored);
    }

    void fleesStraightBackFromAHighRisk() {
        Evasion evasion;
        const EvasionDecision decision = decide(evasion, {{"L2", 1.0}});
        QCOMPARE(decision.mode, EvasionMode::Flee);
        QVERIFY(near(decision.flee_bearing_rad, radians(36.0) + pi));
        QVERIFY(decision.new_high_risk);
        QVERIFY(!decide(evasion, {{"L2", 1.0}}).new_high_risk); // one mark for one risk
    }

    void neverReversesIntoWhatItRemembers() {
        Evasion evasion;
        const std::vector<Obstacle> behind{wallAt(-1.5, 0.0)};
        const EvasionDecision decision = decide(evasion, {{"M0", 1.0}}, behind);
        QCOMPARE(decision.mode, EvasionMode::Flee);
        QVERIFY(clearance_m(behind, {0, 0}, decision.flee_bearing_rad, 0.8, 1.6) >= 1.6);
        QVERIFY(std::abs(normalizedAngle(decision.flee_bearing_rad - pi)) > radians(20.0));
    }

    void isEnclosedWhenThereIsNoWayBack() {
        Evasion evasion;
        std::vector<Obstacle> ring;
        for (int i = 0; i < 24; ++i)
            ring.push_back(wallAt(1.4 * std::cos(i * pi / 12.0), 1.4 * std::sin(i * pi / 12.0)));
        QCOMPARE(decide(evasion, {{"M0", 1.0}}, ring).mode, EvasionMode::Enclosed);
    }

    void fleesToWhereItHasFlown_data() {
        QTest::addColumn<double>("flown_deg");
        QTest::addColumn<bool>("only_there");
        QTest::addColumn<bool>("flees");
        QTest::addColumn<double>("bearing_deg");
        QTest::newRow("it came from behind") << 180.0 << true << true << 180.0;
        QTest::newRow("it came from the side") << 90.0 << true << true << 90.0;
        QTest::newRow("it came from the side, without walls") << 90.0 << false << true << 180.0;
        QTest::newRow("it came from nowhere") << 0.0 << true << false << 0.0;
        QTest::newRow("it came from nowhere, without walls") << 0.0 << false << true << 180.0;
    }
    void fleesToWhereItHasFlown() {
        QFETCH(double, flown_deg);
        QFETCH(bool, only_there);
        QFETCH(bool, flees);
        QFETCH(double, bearing_deg);
        const Retreat retreat{
            [flown_deg](const Vec2& at_m) { return near(std::atan2(at_m.y(), at_m.x()), radians(flown_deg)); },
            only_there};
        const auto bearing = escapeBearing({}, {0, 0}, 0.0, 1.6, retreat);
        QCOMPARE(bearing.has_value(), flees);
        QVERIFY(!flees || near(*bearing, radians(bearing_deg)));
    }

    void divertsFromALowRiskTowardTheFreeSegment() {
        Evasion evasion;
        const EvasionDecision decision = decide(evasion, {{"M0", 4.0}, {"R1", 4.0}});
        QCOMPARE(decision.mode, EvasionMode::Divert);
        QVERIFY(near(std::atan2(decision.diversion_m.y(), decision.diversion_m.x()), radians(18.0)));
        QVERIFY(std::abs(decision.diversion_m.norm() - Settings{}.diversion_distance_m) < 1e-9);
        QVERIFY(decision.new_low_risk && decision.new_diversion);
    }

    void doesNotDivertIntoWhatItRemembers() {
        Evasion evasion;
        const std::vector<Obstacle> left{wallAt(2.5, 1.5)};
        QCOMPARE(decide(evasion, {{"M0", 4.0}, {"R1", 4.0}}, left).mode, EvasionMode::Enclosed);
    }

    void keepsADiversionUntilItWasCalmForAWhile_data() {
        QTest::addColumn<double>("tick_s");
        QTest::addColumn<int>("calm_ticks");
        QTest::newRow("UT2004") << 0.2 << static_cast<int>(Settings{}.calm_cycles);
        QTest::newRow("UDK") << 0.1 << 2 * static_cast<int>(Settings{}.calm_cycles) - 1;
    }
    void keepsADiversionUntilItWasCalmForAWhile() {
        QFETCH(double, tick_s);
        QFETCH(int, calm_ticks);
        Evasion evasion;
        const auto decideAt = [&](int tick, const Ranges& ranges) {
            return decide(evasion, ranges, {}, {20, 0}, 100.0 + tick * tick_s).mode;
        };
        decideAt(0, {{"M0", 4.0}});
        for (int tick = 1; tick < calm_ticks; ++tick)
            QCOMPARE(decideAt(tick, {}), EvasionMode::Divert);
        QCOMPARE(decideAt(calm_ticks, {}), EvasionMode::None);
    }

    void goesOnAtOnceAfterAHighRisk() {
        Evasion evasion;
        decide(evasion, {{"M0", 1.0}});
        QCOMPARE(decide(evasion, {}).mode, EvasionMode::None);
    }

    void doesNothingWithoutARisk() {
        Evasion evasion;
        const EvasionDecision decision = decide(evasion, {});
        QCOMPARE(decision.mode, EvasionMode::None);
        QVERIFY(!decision.new_low_risk && !decision.new_high_risk && !decision.new_diversion);
    }

    void forgetsWhenReset() {
        Evasion evasion;
        decide(evasion, {{"M0", 4.0}});
        evasion.reset();
        QCOMPARE(decide(evasion, {}).mode, EvasionMode::None);
    }

    void escapesTheNearestOpenWay_data() {
        QTest::addColumn<double>("wall_deg");
        QTest::addColumn<double>("off_back_deg");
        QTest::newRow("nothing behind") << 0.0 << 0.0;
        QTest::newRow("something straight behind") << 180.0 << 45.0;
    }
    void escapesTheNearestOpenWay() {
        QFETCH(double, wall_deg);
        QFETCH(double, off_back_deg);
        const std::vector<Obstacle> obstacles{
            wallAt(1.3 * std::cos(radians(wall_deg)), 1.3 * std::sin(radians(wall_deg)))};
        const auto bearing = escapeBearing(obstacles, {0, 0}, 0.0, 1.6);
        QVERIFY(bearing);
        QVERIFY(std::abs(std::abs(normalizedAngle(*bearing - pi)) - radians(off_back_deg)) < radians(8.0));
    }
};

USAR_TEST(tst_Evasion)

} // namespace tst_evasion

#include "tst_evasion.moc"
