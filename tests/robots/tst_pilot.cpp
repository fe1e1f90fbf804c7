#include <QObject>
#include <QTest>

#include "robots/airrobot/flight/pilot.h"
#include "tests/robots/robot_samples.h"
#include "tests/suite/suite.h"

namespace tst_pilot {

using namespace usar;
using namespace usar::airrobot;
using namespace usar::test;

class tst_Pilot : public QObject {
    Q_OBJECT

    Settings settings;

    static protocol::AerialDrive driveOf(agent::CommandPort& port) {
        const auto commands = port.takeCommands();
        return commands.empty() ? protocol::AerialDrive{} : std::get<protocol::AerialDrive>(commands.back().command);
    }

private slots:
    void turnsTheShortWayNoFasterThanItMay_data() {
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<double>("bearing_deg");
        QTest::addColumn<double>("sign");
        QTest::newRow("left") << 0.0 << 90.0 << 1.0;
        QTest::newRow("right") << 0.0 << -90.0 << -1.0;
        QTest::newRow("across the seam") << 170.0 << -170.0 << 1.0;
    }
    void turnsTheShortWayNoFasterThanItMay() {
        QFETCH(double, yaw_deg);
        QFETCH(double, bearing_deg);
        QFETCH(double, sign);
        const Senses senses = sensesAt({0, 0, 6}, radians(yaw_deg));
        const double rate_rad_s = turnRate_rad_s(senses, radians(bearing_deg), settings);
        QVERIFY(rate_rad_s * sign > 0.0);
        QVERIFY(std::abs(rate_rad_s) <= settings.turn_rate_rad_s);
    }

    void isCalmOnALateLink_data() {
        QTest::addColumn<double>("late_s");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("share");
        QTest::newRow("in time") << 0.0 << 1.6 << 1.0;
        // By hand: in the second that it takes to obey it passes v, and v^2 / 2 as it brakes at 1 m/s2, together 1.2 m.
        QTest::newRow("0.6 s") << 0.6 << 0.844 << 0.4545;
        QTest::newRow("3 s") << 3.0 << 0.336 << 0.1429;
    }
    void isCalmOnALateLink() {
        QFETCH(double, late_s);
        QFETCH(double, speed_m_s);
        QFETCH(double, share);
        Senses senses = sensesAt({0, 0, 6});
        senses.late = Seconds(late_s);
        const Motion motion = calmed({Vec2(0.0, 1.6), 1.0, 10.0}, senses, settings);
        QVERIFY2(std::abs(motion.velocity_in_map_m_s.y() - speed_m_s) < 1e-3,
                 qPrintable(QString::number(motion.velocity_in_map_m_s.y())));
        QVERIFY(std::abs(motion.climb_m_s - share) < 1e-3);
        QVERIFY(late_s == 0.0 || std::abs(motion.yaw_rate_rad_s - share * settings.turn_rate_rad_s) < 1e-3);
        QVERIFY(std::abs(turnRate_rad_s(senses, 0.1, settings) - share * 0.14) < 1e-3);
        QVERIFY(std::abs(holding(senses, {0.5, 0.0}).velocity_in_map_m_s.x() - share * 0.3) < 1e-3);
    }

    void fliesOnlyWhereItLooks_data() {
        QTest::addColumn<double>("off_deg");
        QTest::addColumn<double>("speed_m_s");
        QTest::addColumn<double>("round_m_s"); // where it may round corners
        QTest::newRow("ahead") << 0.0 << 1.0 << 1.0;
        QTest::newRow("aside, where a sonar looks") << 45.0 << 0.0 << 35.0 / 80.0;
        QTest::newRow("abeam, where none looks") << 85.0 << 0.0 << 0.0;
        QTest::newRow("behind") << 180.0 << 0.0 << 0.0;
    }
    void fliesOnlyWhereItLooks() {
        QFETCH(double, off_deg);
        QFETCH(double, speed_m_s);
        const Motion motion = toward(sensesAt({0, 0, 6}), radians(off_deg), 1.0, settings);
        QVERIFY(std::abs(motion.velocity_in_map_m_s.norm() - speed_m_s) < 1e-9);
        QFETCH(double, round_m_s);
        const Motion round = toward(sensesAt({0, 0, 6}), radians(off_deg), 1.0, settings, Corner::Round);
        QVERIFY(std::abs(round.velocity_in_map_m_s.norm() - round_m_s) < 1e-9);
        QCOMPARE(round.yaw_rate_rad_s, motion.yaw_rate_rad_s);
    }

    void turnsMapVelocitiesIntoTheBodysFrame() {
        Pilot pilot;
        agent::CommandPort port;
        const Senses senses = sensesAt({0, 0, 6}, pi / 2.0);
        Motion motion;
        motion.velocity_in_map_m_s = {1.0, 0.0}; // east, while looking north
        motion.sudden = true;
        motion.climb_m_s = 0.5;
        pilot.fly(motion, senses, port, "test", settings);
        const auto drive = driveOf(port);
        QVERIFY(std::abs(*drive.forward_m_s) < 1e-9);
        QVERIFY(std::abs(*drive.left_m_s + 1.0) < 1e-9);
        QCOMPARE(*drive.climb_m_s, 0.5);
    }

    void gathersSpeedGentlyAndBrakesFirmlyWhateverTheTick_data() {
        QTest::addColumn<double>("tick_s");
        QTest::newRow("UT2004") << 0.2;
        QTest::newRow("UDK") << 0.1;
        QTest::newRow("slow") << 0.4;
    }
    void gathersSpeedGentlyAndBrakesFirmlyWhateverTheTick() {
        QFETCH(double, tick_s);
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6});
        const auto flyTick = [&](const Vec2& velocity_m_s) {
            Motion motion;
            motion.velocity_in_map_m_s = velocity_m_s;
            pilot.fly(motion, senses, port, "test", settings);
            senses.now += Seconds(tick_s);
            return pilot.wantedInBase_m_s().x();
        };
        const double first_m_s = flyTick({2.0, 0.0});
        QVERIFY(std::abs(first_m_s - 0.2 * settings.acceleration_m_s2) < 1e-9);
        QVERIFY(std::abs(flyTick({2.0, 0.0}) - first_m_s - tick_s * settings.acceleration_m_s2) < 1e-9);
        for (int i = 0; i < 100; ++i)
            flyTick({2.0, 0.0});
        QVERIFY(std::abs(pilot.wantedInBase_m_s().x() - 2.0) < 1e-9);
        QVERIFY(std::abs(flyTick({0.0, 0.0}) - (2.0 - 2.0 * tick_s)) < 1e-9);
    }

    /// It cannot make good the speed that is wanted, and still knows the wind when it is to stand (survey 96575).
    void doesNotTakeItsLimitForWind() {
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6});
        const Vec2 wind_m_s(-0.7, 0.2);
        Vec2 through_air_m_s = Vec2::Zero();
        for (int tick = 0; tick < 100; ++tick) {
            senses.velocity_in_map_m_s.head<2>() = through_air_m_s + wind_m_s;
            senses.now += Seconds(0.2);
            pilot.fly({.velocity_in_map_m_s = {1.9, 0.0}}, senses, port, "test", settings);
            for (const agent::CausedCommand& caused : port.takeCommands()) {
                const auto& drive = std::get<protocol::AerialDrive>(caused.command);
                through_air_m_s = Vec2(*drive.forward_m_s, *drive.left_m_s);
            }
        }
        QVERIFY(std::abs(through_air_m_s.norm() - 2.0) < 1e-9);
        QVERIFY2((pilot.drift_m_s() - wind_m_s).norm() < 0.1, qPrintable(QString::number(pilot.drift_m_s().x())));
    }

    /// The robot moves over ground as it is told through the air, and with the wind.
    void holdsItsPlaceInTheWind() {
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6}, 0.7);
        const Vec2 wind_m_s(1.1, -0.4);
        Vec2 through_air_m_s = Vec2::Zero();
        for (int tick = 0; tick < 200; ++tick) {
            senses.velocity_in_map_m_s.head<2>() = through_air_m_s + wind_m_s;
            senses.base_in_map.position_m.head<2>() += 0.2 * senses.velocity_in_map_m_s.head<2>();
            senses.now += Seconds(0.2);
            pilot.fly(holding(senses, {0, 0}), senses, port, "test", settings);
            for (const agent::CausedCommand& caused : port.takeCommands()) {
                const auto& drive = std::get<protocol::AerialDrive>(caused.command);
                through_air_m_s = Eigen::Rotation2Dd(0.7) * Vec2(*drive.forward_m_s, *drive.left_m_s);
            }
        }
        QVERIFY2(senses.position2_m().norm() < 0.5, qPrintable(QString::number(senses.position2_m().norm())));
        QVERIFY(senses.velocity_in_map_m_s.norm() < 0.15);
        QVERIFY(pilot.wantedInBase_m_s().norm() < 0.3); // The heading is compared with what was wanted over ground.
        senses.now += Seconds(2.0);
        pilot.brace(senses, 0.0, port, "test"); // Without a look at its senses, it still leans against the wind.
        const auto last = port.takeCommands();
        const auto& drive = std::get<protocol::AerialDrive>(last.at(0).command);
        const Vec2 braced_m_s = Eigen::Rotation2Dd(0.7) * Vec2(*drive.forward_m_s, *drive.left_m_s);
        QVERIFY((braced_m_s + wind_m_s).norm() < 0.2);
        QCOMPARE(pilot.still(senses).forward_m_s, drive.forward_m_s); // Whoever stops it, it leans on.
        QCOMPARE(pilot.still(senses).left_m_s, drive.left_m_s);
        Pilot landed = pilot;
        landed.stop(port, "landed");
        QVERIFY(landed.still(senses) == (protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        senses.late = Seconds(1.0);
        QVERIFY(pilot.still(senses) == (protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        port.takeCommands();
        pilot.brace(senses, 0.0, port, "test");
        QCOMPARE(*std::get<protocol::AerialDrive>(port.takeCommands().at(0).command).forward_m_s, 0.0);
        QVERIFY(pilot.still(senses) == (protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
    }

    /// A faulty INS that starts to add two meters, for one.
    void aLeapOfThePoseIsNoWind() {
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6});
        for (const double velocity_m_s : {0.0, 10.0, 0.0}) {
            senses.now += Seconds(0.2);
            senses.velocity_in_map_m_s = {velocity_m_s, 0.0, 0.0};
            pilot.fly({}, senses, port, "test", settings);
        }
        QVERIFY(pilot.still(senses) == (protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
    }

    /// It gathers speed, but its senses tell the velocity of the moment in which they fell silent.
    void silentSensesTeachNoWind() {
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6});
        Motion motion;
        motion.velocity_in_map_m_s = {2.0, 0.0};
        for (int tick = 0; tick < 7; ++tick) {
            senses.now += Seconds(0.2);
            senses.ins_age += Seconds(0.2);
            pilot.fly(motion, senses, port, "test", settings);
        }
        port.takeCommands();
        pilot.brace(senses, 0.0, port, "test");
        const auto last = port.takeCommands();
        QCOMPARE(*std::get<protocol::AerialDrive>(last.at(0).command).forward_m_s, 0.0);
    }

    void repeatsACommandThatMayHaveBeenLost() {
        Pilot pilot;
        agent::CommandPort port;
        Senses senses = sensesAt({0, 0, 6});
        std::size_t sent = 0;
        for (int tick = 0; tick < 10; ++tick) {
            senses.now = Seconds(0.2 * tick);
            pilot.fly({}, senses, port, "test", settings);
            sent += port.takeCommands().size();
        }
        QCOMPARE(sent, std::size_t(2));
    }

    void aGapInTheMessagesIsNoTimeToGatherSpeed() {
        Pilot pilot;
        agent::CommandPort port;
        Motion motion;
        motion.velocity_in_map_m_s = {5.0, 0.0};
        pilot.fly(motion, sensesAt({0, 0, 6}, 0.0, 100.0), port, "test", settings);
        pilot.fly(motion, sensesAt({0, 0, 6}, 0.0, 130.0), port, "test", settings);
        QVERIFY(std::abs(pilot.wantedInBase_m_s().x() - 0.6 * settings.acceleration_m_s2) < 1e-9);
        pilot.fly(motion, sensesAt({0, 0, 6}, 0.0, 3.0), port, "test", settings); // the server was restarted
        QVERIFY(std::abs(pilot.wantedInBase_m_s().x() - 0.8 * settings.acceleration_m_s2) < 1e-9);
    }

    void obeysASuddenMotionAtOnce() {
        Pilot pilot;
        agent::CommandPort port;
        Motion motion;
        motion.velocity_in_map_m_s = {-0.8, 0.0};
        motion.sudden = true;
        pilot.fly(motion, sensesAt({0, 0, 6}), port, "test", settings);
        QVERIFY(std::abs(*driveOf(port).forward_m_s + 0.8) < 1e-9);
    }

    void saysNothingTwice() {
        Pilot pilot;
        agent::CommandPort port;
        pilot.stop(port, "landed");
        pilot.stop(port, "landed");
        const auto commands = port.takeCommands();
        QCOMPARE(commands.size(), std::size_t(1));
        QCOMPARE(toText(commands[0].cause.source), std::string("landed"));
    }

    void comesBackToAPlaceThatItHolds() {
        const Motion far = holding(sensesAt({3, 0, 6}), {0, 0});
        QVERIFY(far.velocity_in_map_m_s.x() < 0.0);
        QVERIFY(far.velocity_in_map_m_s.norm() <= 0.5 + 1e-9);
        QCOMPARE(holding(sensesAt({0.1, 0, 6}), {0, 0}).velocity_in_map_m_s.norm(), 0.0);
    }
};

USAR_TEST(tst_Pilot)

} // namespace tst_pilot

#include "tst_pilot.moc"
