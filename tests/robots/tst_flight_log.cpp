#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/flight_log.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_flight_log {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::agent;
using namespace usar::test;

class tst_FlightLog : public QObject {
    Q_OBJECT

    const Settings settings;

    template <class Value>
    static std::vector<Value> all(CommandPort& port) {
        std::vector<Value> found;
        for (const Published& value : port.takePublished())
            if (const auto* wanted = std::get_if<Value>(&value))
                found.push_back(*wanted);
        return found;
    }

private slots:
    void putsScansOnTheMapOnlyWhenTheyAreGood_data() {
        QTest::addColumn<double>("pitch_deg");
        QTest::addColumn<double>("turn_deg_s");
        QTest::addColumn<double>("height_m");
        QTest::addColumn<bool>("airborne");
        QTest::addColumn<bool>("good");
        QTest::newRow("level flight") << 2.0 << 0.0 << 6.0 << true << true;
        QTest::newRow("braking hard") << 20.0 << 0.0 << 6.0 << true << false;
        QTest::newRow("turning") << 2.0 << 35.0 << 6.0 << true << false;
        QTest::newRow("just over the ground") << 0.0 << 0.0 << 1.0 << true << false;
        QTest::newRow("on the ground") << 0.0 << 0.0 << 6.0 << false << false;
    }
    void putsScansOnTheMapOnlyWhenTheyAreGood() {
        QFETCH(double, pitch_deg);
        QFETCH(double, turn_deg_s);
        QFETCH(double, height_m);
        QFETCH(bool, airborne);
        QFETCH(bool, good);
        Senses senses = sensesAt({0, 0, 6});
        senses.base_in_map.pitch_rad = radians(pitch_deg);
        senses.yaw_rate_rad_s = radians(turn_deg_s);
        senses.ground_m = 6.0 - height_m;
        setFlatScan(senses, {0, 0}, 1.0, 0.0);
        QCOMPARE(goodForMap(senses, airborne, Lean(), settings), good);
        FlightLog log;
        CommandPort port;
        QCOMPARE(log.tick(senses, airborne, settings, port), good);
        QCOMPARE(all<ScanPlacement>(port).size(), std::size_t(good ? 1 : 0));
    }

    void scansBesideItselfWhereItLeans_data() {
        QTest::addColumn<double>("pitch_deg");
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<Vec2>("aside_m");
        QTest::newRow("level") << 2.0 << 0.0 << Vec2(0.0, 0.0);
        QTest::newRow("nose down, against a wind from the east") << 15.0 << 0.0 << Vec2(-1.61, 0.0);
        QTest::newRow("nose up, with it") << -15.0 << 180.0 << Vec2(-1.61, 0.0);
    }
    void scansBesideItselfWhereItLeans() {
        QFETCH(double, pitch_deg);
        QFETCH(double, yaw_deg);
        QFETCH(Vec2, aside_m);
        Lean lean;
        Senses senses = sensesAt({0, 0, 6}, radians(yaw_deg));
        senses.base_in_map.pitch_rad = radians(pitch_deg);
        for (int tick = 0; tick < 300; ++tick) {
            senses.now += Seconds(0.2);
            lean.note(senses);
        }
        QVERIFY((lean.scanAside_m(radians(yaw_deg), 6.0) - aside_m).norm() < 0.02);
        const Vec3 down_m = senses.base_in_map.rotation() * Vec3(0.0, 0.0, -6.0 / std::cos(radians(pitch_deg)));
        QVERIFY(aside_m.isZero() || (down_m.head<2>() - aside_m).norm() < 0.02);
    }

    void aSteadyLeanAgainstTheWindDoesNoHarm() {
        Lean lean;
        Senses senses = sensesAt({0, 0, 6});
        setFlatScan(senses, {0, 0}, 1.0, 0.0);
        senses.base_in_map.pitch_rad = radians(18.0);
        senses.scan->base_in_map = senses.base_in_map;
        bool good_at_once = false;
        for (int tick = 0; tick < 100; ++tick) {
            lean.note(senses);
            good_at_once = good_at_once || (tick == 2 && goodForMap(senses, true, lean, settings));
            senses.now += Seconds(0.2);
        }
        QVERIFY(!good_at_once);
        QVERIFY(goodForMap(senses, true, lean, settings));
        senses.scan->base_in_map.pitch_rad = 0.0; // It rights itself, as it does in a gust.
        QVERIFY(!goodForMap(senses, true, lean, settings));
    }

    void hasNothingToPlaceWithoutAScan() { QVERIFY(!goodForMap(sensesAt({0, 0, 6}), true, Lean(), settings)); }

    void namesTheScansLineAndPose() {
        Senses senses = sensesAt({1, 2, 6});
        setFlatScan(senses, {0, 0}, 1.0, 0.0);
        senses.scan->line = {77};
        senses.scan->scanner_in_map.roll_rad = 0.08;
        senses.scan->level_scanner_in_map = {Vec3(1, 2, 5.9), 0.01, 0.0, 0.0};
        FlightLog log;
        CommandPort port;
        log.tick(senses, true, settings, port);
        const auto placed = all<ScanPlacement>(port);
        QCOMPARE(placed.at(0).scan_line.value, std::uint64_t(77));
        QCOMPARE(placed.at(0).scanner_in_map.position_m.z(), 5.9);
        QCOMPARE(placed.at(0).scanner_in_map.roll_rad, 0.01); // The map is made without the drift.
    }

    void marksThePathEveryMetre() {
        FlightLog log;
        CommandPort port;
        for (int i = 0; i <= 100; ++i)
            log.tick(sensesAt({0.1 * i, 0, 6}), true, settings, port);
        const auto marks = all<MapMark>(port);
        QVERIFY(marks.size() >= 10 && marks.size() <= 11);
        QCOMPARE(marks[0].kind, MarkKind::Path);
        QCOMPARE(marks[0].line.value, std::uint64_t(42));
    }

    void tellsThePoseEveryTickAlsoOnTheGround() {
        FlightLog log;
        CommandPort port;
        Senses senses = sensesAt({3, 4, 0});
        senses.base_in_map.roll_rad = 0.08;
        senses.level_in_map.roll_rad = 0.01;
        log.tick(senses, false, settings, port);
        const auto told = all<PoseEstimate>(port);
        QCOMPARE(told.at(0).base_in_map.position_m.x(), 3.0);
        QCOMPARE(told.at(0).base_in_map.roll_rad, 0.01); // The map's own corrections begin there.
        log.tick(sensesAt({3, 4, 0}), false, settings, port);
        QVERIFY(all<MapMark>(port).empty());
    }

    void marksRisksAndDiversions() {
        const FlightLog log;
        CommandPort port;
        EvasionDecision decision;
        decision.new_low_risk = decision.new_diversion = true;
        decision.diversion_m = {4, 1};
        log.risks(sensesAt({0, 0, 6}), decision, port);
        const auto marks = all<MapMark>(port);
        QCOMPARE(marks.size(), std::size_t(2));
        QCOMPARE(marks[0].kind, MarkKind::LowRisk);
        QCOMPARE(marks[1].kind, MarkKind::Diversion);
        QCOMPARE(marks[1].position_in_map_m, Vec3(4, 1, 6));
        decision = {};
        decision.new_high_risk = true;
        log.risks(sensesAt({0, 0, 6}), decision, port);
        QCOMPARE(all<MapMark>(port).at(0).kind, MarkKind::HighRisk);
    }

    void tellsAGoalWhenItChanges() {
        FlightLog log;
        CommandPort port;
        log.goal(Vec3(1, 2, 3), port);
        log.goal(Vec3(1.1, 2, 3), port);
        QCOMPARE(all<CurrentGoal>(port).size(), std::size_t(1));
        log.goal(Vec3(5, 2, 3), port);
        log.goal(std::nullopt, port);
        log.goal(std::nullopt, port);
        const auto goals = all<CurrentGoal>(port);
        QCOMPARE(goals.size(), std::size_t(2));
        QVERIFY(!goals[1].goal_in_map_m);
    }
};

USAR_TEST(tst_FlightLog)

} // namespace tst_flight_log

#include "tst_flight_log.moc"
