#include <optional>

#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/sense_reader.h"
#include "tests/suite/suite.h"

namespace tst_senses {

using namespace usar;
using namespace usar::airrobot;

class tst_Senses : public QObject {
    Q_OBJECT

    std::optional<modules::RobotModules> robot;
    SensorLayout layout;
    const Seconds time_out{1.5};
    std::uint64_t line = 0;
    std::unique_ptr<SenseReader> reader;

    void tell(protocol::InfoMessage message) { robot->take({LineNumber{++line}, "", std::move(message), {}}); }
    void tellState(double time_s, double battery_s = 500.0) {
        protocol::RobotState state;
        state.time = Seconds(time_s);
        state.battery_left = Seconds(battery_s);
        tell(state);
    }
    void tellIns(const Pose& base_in_map) { tell(protocol::InsReading{{}, "INS", base_in_map}); }
    void tellSonars(double range_m) {
        protocol::SonarReadings sonars;
        for (const SonarMount& mount : layout.sonars)
            sonars.ranges.push_back({mount.name, range_m});
        tell(sonars);
    }
    void tellSonar(const std::string& name, double range_m) { tell(protocol::SonarReadings{{}, {{name, range_m}}}); }
    void tellFlatGround(double height_m, std::optional<Seconds> time = {}) {
        protocol::RangeScan scan{time, "Scanner1", radians(1.0), pi, {}};
        scan.ranges_m.resize(181);
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            const double down = std::cos(scan.beamAngle_rad(i));
            scan.ranges_m[i] = down > height_m / 20.0 ? (height_m - 0.1) / down : 20.0;
        }
        tell(scan);
    }
    Senses read() { return reader->read(robot->state.now(), LineNumber{line}, *robot, layout, time_out); }

private slots:
    void init() {
        robot.emplace();
        layout = stockLayout();
        line = 0;
        reader = std::make_unique<SenseReader>();
    }

    void findsTheGroundUnderTheBelly() {
        tellIns({Vec3(10, 20, 8), 0, 0, 0.5});
        tellFlatGround(6.0);
        tellState(10.0);
        const Senses senses = read();
        QVERIFY(senses.ground_m);
        QVERIFY(std::abs(*senses.ground_m - 2.0) < 0.05);
        QVERIFY(std::abs(senses.heightOverGround_m(0.0) - 6.0) < 0.05);
        QCOMPARE(senses.robot_battery->count(), 500.0);
    }

    void doubtsItsHeightMoreTheFartherItFlies() {
        const auto doubtAfter = [&](int meters) {
            for (int at_m = 1; at_m <= meters; ++at_m) {
                tellIns({Vec3(at_m, 0, 6), 0, 0, 0});
                tellState(10.0 + at_m);
                reader->read(robot->state.now(), LineNumber{line}, *robot, layout, time_out);
            }
            return read().height_doubt_m;
        };
        QCOMPARE(read().height_doubt_m, 0.0);
        QVERIFY(std::abs(doubtAfter(1000) - 3.0 * 0.71) < 0.1); // Three times the random walk of 1 km.
        reader->forgetMotion();
        QCOMPARE(read().height_doubt_m, 0.0);
        reader->navigateByTruth(true);
        QCOMPARE(doubtAfter(1000), 0.0);
    }

    // A damaged range would otherwise be an obstacle, or a beam that looks above a roof.
    void leavesOutABeamWhoseNumberIsDamaged() {
        tellIns({Vec3(0, 0, 6), 0, 0, 0});
        tellState(10.0);
        tellFlatGround(6.0);
        const std::size_t all = read().scan->hits_in_map_m.size();
        auto scan = *robot->sensors.scan("");
        scan.value.ranges_m[60] = 0.7; // "6.7" without its digit
        scan.value.ranges_m[120] = 68.0;
        tell(scan.value);
        tellState(10.2);
        const Senses senses = read();
        QCOMPARE(senses.scan->hits_in_map_m.size(), all - 2);
        for (const Vec3& hit_m : senses.scan->hits_in_map_m)
            QVERIFY(hit_m.z() < 0.5);
    }

    void allowsForTheTiltOfTheRobot() {
        tellIns({Vec3(0, 0, 6), 0, 0, 0});
        tellFlatGround(6.0);
        tellState(10.0);
        const auto level = read().scan->hits_in_map_m.front();
        tellIns({Vec3(0, 0, 6), radians(10.0), 0, 0});
        tellFlatGround(6.0);
        tellState(10.2);
        const Senses rolled = read();
        QVERIFY(std::abs(rolled.scan->hits_in_map_m.front().z() - level.z()) > 0.5); // right side sinks when rolled
    }

    /// In steady flight straight ahead, a robot that shows a roll does not have it.
    void placesBeamsAsTheRobotLeansInSteadyFlight_data() {
        QTest::addColumn<bool>("corrects");
        QTest::addColumn<bool>("by_truth");
        QTest::addColumn<bool>("level");
        QTest::newRow("as the INS tells it") << false << false << false;
        QTest::newRow("as it leans") << true << false << true;
        QTest::newRow("the truth needs no correction") << true << true << false;
    }
    void placesBeamsAsTheRobotLeansInSteadyFlight() {
        QFETCH(bool, corrects);
        QFETCH(bool, by_truth);
        QFETCH(bool, level);
        reader->correctLean(corrects);
        reader->navigateByTruth(by_truth);
        Senses senses;
        for (int tick = 0; tick < 100; ++tick) {
            const Pose shown{Vec3(0.4 * tick, 0, 6), 0.08, 0.08, 0.0};
            if (by_truth)
                tell(protocol::GroundTruthReading{{}, "GroundTruth", shown});
            else
                tellIns(shown);
            tellFlatGround(6.0);
            tellState(10.0 + 0.2 * tick);
            senses = read();
        }
        const auto& hits_m = senses.scan->hits_in_map_m;
        QCOMPARE(std::abs(hits_m.front().z() - hits_m.back().z()) < 0.3, level);
        QCOMPARE(senses.scan->highest_m < senses.base_in_map.position_m.z() + 0.3, !by_truth);
        QVERIFY(senses.scan->lean_known);
        QCOMPARE(senses.base_in_map.roll_rad, 0.08);
        QCOMPARE(senses.scan->base_in_map.roll_rad, 0.08);
        QCOMPARE(std::abs(senses.level_in_map.roll_rad) < 0.01, !by_truth); // for the map, whatever beams are for
        const Pose level_base_in_map = senses.scan->level_scanner_in_map * inverse(layout.scanner_in_base);
        QVERIFY(std::abs(level_base_in_map.roll_rad - senses.level_in_map.roll_rad) < 1e-6);
        QCOMPARE(senses.scan->scanner_in_map.position_m.z(),
                 (senses.base_in_map * layout.scanner_in_base).position_m.z());
    }

    /// It climbed into a roof at full speed, because its looks up had made its roll drift (survey 161109).
    void seesAsHighAsItsBeamsSurelyGet() {
        const auto highestOver_m = [&](int looks) {
            init();
            Senses senses;
            for (int tick = 0; tick < 10 * looks + 2; ++tick) {
                const double roll_rad = tick < 10 * looks ? 0.24 * std::sin(2.0 * pi * tick / 10.0) : 0.24;
                tellIns({Vec3(0, 0, 6), roll_rad, 0.0, 0.0});
                tellFlatGround(6.0);
                tellState(10.0 + 0.2 * tick);
                senses = read();
            }
            return senses.scan->highest_m - 6.0;
        };
        const double once_m = highestOver_m(0);
        QVERIFY2(once_m > 3.5 && once_m < 4.8, qPrintable(QString::number(once_m))); // 20 m at 0.24 rad
        const double later_m = highestOver_m(10);
        QVERIFY2(later_m > 1.0 && later_m < once_m - 1.0, qPrintable(QString::number(later_m)));
    }

    void doesNotKnowItsLeanOnceItHasJumpedUnlessThereIsWind() {
        Senses senses;
        double x_m = 0.0;
        const auto fly = [&](double roll_rad) {
            for (int tick = 0; tick < 100; ++tick) {
                x_m += 0.2;
                tellIns({Vec3(x_m, 0, 6), roll_rad, 0.01, 0.0});
                tellFlatGround(6.0);
                tellState(10.0 + x_m);
                senses = read();
            }
        };
        fly(0.0);
        QVERIFY(senses.scan->lean_known);
        fly(0.4);
        QVERIFY(!senses.scan->lean_known);
        reader->tellWind(true);
        fly(0.4);
        QVERIFY(senses.scan->lean_known);
    }

    void placesAScanWhereTheRobotWasWhenItWasTaken() {
        tellIns({Vec3(0, 0, 6), 0, 0, 0});
        tellState(10.0);
        read();
        tellFlatGround(6.0, Seconds(10.0)); // one tick old, as on some servers
        tellIns({Vec3(1, 0, 6), 0, 0, 0});
        tellState(10.2);
        const Senses senses = read();
        QVERIFY(senses.scan);
        QVERIFY(std::abs(senses.scan->base_in_map.position_m.x()) < 1e-9);
        QCOMPARE(senses.position_m().x(), 1.0);
        QVERIFY(std::abs(senses.velocity_in_map_m_s.x() - 5.0) < 1e-9);
    }

    void givesAScanOnce() {
        tellIns({});
        tellFlatGround(6.0);
        tellState(10.0);
        QVERIFY(read().scan);
        tellState(10.2);
        const Senses senses = read();
        QVERIFY(!senses.scan);
        QVERIFY(senses.ground_m); // still known
    }

    void hasNoGroundBeyondTheReach() {
        tellIns({Vec3(0, 0, 30), 0, 0, 0});
        tellFlatGround(25.0);
        tellState(10.0);
        QVERIFY(!read().ground_m);
    }

    void placesSonarEchoesAroundTheRobot() {
        tellIns({Vec3(0, 0, 6), 0, 0, pi / 2.0});
        tellSonars(3.0);
        tellState(10.0);
        const Senses senses = read();
        QCOMPARE(senses.sonars.size(), std::size_t(9));
        const SonarEcho& front = senses.sonars[4];
        QCOMPARE(front.name, std::string("M0"));
        QVERIFY(front.hit);
        QVERIFY((front.center_in_map_m - Vec3(0, 3.5, 6)).norm() < 1e-9);
        QVERIFY(front.low_m < 5.7 && front.high_m > 6.3);
    }

    void takesTheMaximumForNoEchoAndLeavesOutNonsense() {
        tellIns({});
        protocol::SonarReadings sonars;
        sonars.ranges = {{"L4", 5.0}, {"M0", std::nan("")}};
        tell(sonars);
        tellState(10.0);
        const Senses senses = read();
        QCOMPARE(senses.sonars.size(), std::size_t(1));
        QVERIFY(!senses.sonars[0].hit);
    }

    void leavesOutASonarThatStopped_data() {
        QTest::addColumn<double>("last_m");
        QTest::newRow("says nothing more") << 0.0;
        QTest::newRow("says what is not a number") << std::nan("");
    }
    void leavesOutASonarThatStopped() {
        QFETCH(double, last_m);
        tellIns({});
        tellSonars(3.0);
        tellState(10.0);
        QCOMPARE(read().sonars.size(), std::size_t(9));
        for (int tick = 1; tick <= 10; ++tick) {
            for (const SonarMount& mount : layout.sonars)
                if (mount.name != "L2")
                    tellSonar(mount.name, 3.0);
                else if (std::isnan(last_m))
                    tellSonar(mount.name, last_m);
            tellState(10.0 + 0.2 * tick);
            const Senses senses = read();
            const bool silent = tick >= 8;
            QCOMPARE(senses.silent_sonars, silent ? std::vector<std::string>{"L2"} : std::vector<std::string>{});
            QVERIFY(std::ranges::none_of(senses.sonars, [&](const SonarEcho& echo) {
                return (silent || std::isnan(last_m)) && echo.name == "L2";
            }));
            QVERIFY(std::abs(senses.sonar_age.count() - 0.2 * tick) < 1e-9);
        }
        tellSonar("L2", 3.0);
        tellState(12.2);
        QVERIFY(read().silent_sonars.empty());
    }

    void countsTheAgeOfEachSensor() {
        tellState(10.0);
        QVERIFY(read().ins_age > Seconds(1e6));
        tellIns({});
        tellSonars(5.0);
        tellFlatGround(6.0);
        tellState(10.2);
        read();
        tellSonars(5.0);
        tellState(11.2);
        const Senses senses = read();
        QVERIFY(std::abs(senses.ins_age.count() - 1.0) < 1e-9);
        QVERIFY(std::abs(senses.scan_age.count() - 1.0) < 1e-9);
        QCOMPARE(senses.sonar_age.count(), 0.0);
    }
};

USAR_TEST(tst_Senses)

} // namespace tst_senses

#include "tst_senses.moc"
