// Every kind of robot driven by hand in the simulator, over loopback TCP.
#include <algorithm>
#include <functional>

#include <QTest>

#include "core/mission/session/robot_session.h"
#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"

namespace tst_hand_loop {

using namespace usar;
using namespace usar::mission;
using usar::server::HeadlessSimulator;
using usar::server::HeadlessSpec;

namespace {

/// What became of one held stick. Everything in the robot's frame at the hold's begin.
struct Drive {
    bool spawned = false;
    Pose way{};               ///< from the begin of the hold to its end
    double turned_rad = 0.0;  ///< meanwhile, also more than once around
    double driven_on_m = 0.0; ///< in two seconds from half a second after the release on
    std::string last_stop{};
};

struct HandTrial {
    QString class_name;
    Stick stick{.forward = 1.0};
    double speed_share = 0.5;
    Seconds held{6.0};
    QString world{};      ///< empty: level ground; else the start pose at sea
    double speed_x = 4.0; ///< faster, what lies between a hand and the robot would be a part of a short hold
};

/// For holds that are long, of what takes its time.
constexpr double fast_x = 12.0;

/// Poses of the robot by its clock, as ground truth tells them.
struct TruthWatch {
    void take(const Pose& now_in_map) {
        turned_rad += (inverse(base_in_map) * now_in_map).yaw_rad;
        base_in_map = now_in_map;
    }

    Seconds now{0.0};
    Pose base_in_map{};
    double turned_rad = 0.0;
};

Drive driveByHand(const HandTrial& trial) {
    const HeadlessSpec spec{.speed_x = trial.speed_x};
    auto simulator = trial.world.isEmpty() ? HeadlessSimulator::serve(doubles::flatWorld(), spec)
                                           : HeadlessSimulator::start(trial.world, spec);
    Drive drive;
    if (!simulator)
        return drive;
    RobotSession session;
    TruthWatch truth;
    QObject::connect(&session, &RobotSession::updated, &session, [&](const auto& update) {
        truth.now = update->figures.now;
        for (const protocol::InfoLine& line : update->lines)
            if (const auto* const reading = std::get_if<protocol::GroundTruthReading>(&line.message))
                truth.take(reading->base_in_map);
    });
    QObject::connect(&session, &RobotSession::startPosesKnown, &session, [&](const protocol::StartPoses& poses) {
        const auto afloat = std::ranges::find(poses.poses, "OpenSea", &protocol::StartPose::name);
        const auto start = afloat == poses.poses.end() ? poses.poses.begin() : afloat;
        session.spawn({"USARBot." + trial.class_name.toStdString(), "R1", start->pose_in_map});
    });
    session.open("127.0.0.1", (*simulator)->port(), true);
    drive.spawned = QTest::qWaitFor([&] { return session.figures().spawned && truth.now.count() > 0.0; }, 15000);
    const auto passed = [&](Seconds span, const std::function<void()>& each) {
        const Seconds until = truth.now + span;
        return QTest::qWaitFor(
            [&] {
                each();
                return truth.now >= until;
            },
            30000);
    };
    session.takeControl();
    if (!drive.spawned || !passed(Seconds(3.0), [] {})) // it has landed, and knows how it is driven
        return drive;
    const Pose from = truth.base_in_map;
    const double turned_before_rad = truth.turned_rad;
    passed(trial.held, [&] {
        session.drive({.source = HandSource::Keys, .stick = trial.stick, .speed_share = trial.speed_share});
    });
    drive.way = inverse(from) * truth.base_in_map;
    drive.turned_rad = truth.turned_rad - turned_before_rad;
    session.drive({.source = HandSource::Keys});
    drive.last_stop = session.figures().control.last_stop;
    passed(Seconds(3.0), [] {});
    const Pose resting = truth.base_in_map;
    passed(Seconds(2.0), [] {});
    drive.driven_on_m = (truth.base_in_map.position_m - resting.position_m).norm();
    session.close();
    return drive;
}

} // namespace

class tst_HandLoop : public QObject {
    Q_OBJECT
private slots:
    void heldForwardDrivesForwardAndLetGoStops_data();
    void heldForwardDrivesForwardAndLetGoStops();
    void heldToTheLeftTurnsLeft_data();
    void heldToTheLeftTurnsLeft();
    void aFlyerClimbsAndSlips();
    void aSubmarineDivesAndRises();
};

void tst_HandLoop::heldForwardDrivesForwardAndLetGoStops_data() {
    QTest::addColumn<QString>("class_name");
    QTest::addColumn<QString>("world");
    QTest::addColumn<double>("speed_share");
    QTest::addColumn<double>("least_m");
    QTest::addColumn<double>("coasts_m"); ///< what water allows after a stop
    QTest::newRow("AirRobot") << "AirRobot"
                              << "" << 0.5 << 3.0 << 0.1;
    QTest::newRow("P2DX") << "P2DX"
                          << "" << 0.5 << 3.0 << 0.02;
    QTest::newRow("P2AT") << "P2AT"
                          << "" << 0.5 << 1.0 << 0.02;
    QTest::newRow("Sedan") << "Sedan"
                           << "" << 0.2 << 5.0 << 0.1;
    QTest::newRow("Submarine") << "Submarine"
                               << "point_lookout" << 0.8 << 3.0 << 2.0;
    QTest::newRow("ERS") << "ERS"
                         << "" << 1.0 << 0.15 << 0.015; // ground truth is told in whole centimeters
}

void tst_HandLoop::heldForwardDrivesForwardAndLetGoStops() {
    QFETCH(QString, class_name);
    QFETCH(QString, world);
    QFETCH(double, speed_share);
    QFETCH(double, least_m);
    QFETCH(double, coasts_m);
    const bool swims = class_name == "Submarine"; // and takes its time
    const bool slow = swims || class_name == "ERS";
    const Drive drive = driveByHand({.class_name = class_name,
                                     .speed_share = speed_share,
                                     .held = Seconds(swims ? 10.0 : 6.0),
                                     .world = world,
                                     .speed_x = slow ? fast_x : 4.0});
    QVERIFY(drive.spawned);
    const Vec3 way_m = drive.way.position_m;
    const QString said =
        QString("%1 %2 %3, then %4").arg(way_m.x()).arg(way_m.y()).arg(way_m.z()).arg(drive.driven_on_m);
    QVERIFY2(way_m.x() > least_m, qPrintable(said));
    QVERIFY2(std::abs(way_m.y()) < 0.7 * way_m.x(), qPrintable(said));
    QVERIFY2(drive.driven_on_m < coasts_m, qPrintable(said));
    QCOMPARE(drive.last_stop, std::string("the keys were let go"));
}

void tst_HandLoop::heldToTheLeftTurnsLeft_data() {
    QTest::addColumn<QString>("class_name");
    QTest::addColumn<QString>("world");
    QTest::addColumn<double>("forward");
    QTest::addColumn<double>("least_rad");
    QTest::newRow("AirRobot") << "AirRobot"
                              << "" << 0.0 << 0.5;
    QTest::newRow("P2DX") << "P2DX"
                          << "" << 0.0 << 0.5;
    QTest::newRow("P2AT") << "P2AT"
                          << "" << 0.0 << 0.3;
    QTest::newRow("Sedan") << "Sedan"
                           << "" << 0.3 << 0.3;
    QTest::newRow("Submarine") << "Submarine"
                               << "point_lookout" << 1.0 << 0.2;
    QTest::newRow("ERS") << "ERS"
                         << "" << 0.0 << 0.15;
}

void tst_HandLoop::heldToTheLeftTurnsLeft() {
    QFETCH(QString, class_name);
    QFETCH(QString, world);
    QFETCH(double, forward);
    QFETCH(double, least_rad);
    const bool slow = class_name == "ERS" || class_name == "Submarine";
    const Drive drive = driveByHand({.class_name = class_name,
                                     .stick = {.forward = forward, .turn = 1.0},
                                     .speed_share = slow ? 1.0 : 0.5,
                                     .held = Seconds(slow ? 9.0 : 1.6),
                                     .world = world,
                                     .speed_x = slow ? fast_x : 4.0});
    QVERIFY(drive.spawned);
    QVERIFY2(drive.turned_rad > least_rad, qPrintable(QString::number(drive.turned_rad)));
}

void tst_HandLoop::aFlyerClimbsAndSlips() {
    const Drive drive =
        driveByHand({.class_name = "AirRobot", .stick = {.left = 1.0, .up = 1.0}, .held = Seconds(4.0)});
    QVERIFY(drive.spawned);
    const Vec3 way_m = drive.way.position_m;
    QVERIFY2(way_m.y() > 2.0 && way_m.z() > 2.0, qPrintable(QString("%1 %2").arg(way_m.y()).arg(way_m.z())));
}

/// By the difference, for it settles a little whatever its planes do.
void tst_HandLoop::aSubmarineDivesAndRises() {
    const auto swimWith = [](double up) {
        return driveByHand({.class_name = "Submarine",
                            .stick = {.forward = 1.0, .up = up},
                            .speed_share = 1.0,
                            .held = Seconds(16.0),
                            .world = "point_lookout",
                            .speed_x = fast_x});
    };
    const Drive down = swimWith(-1.0);
    const Drive level = swimWith(0.0);
    QVERIFY(down.spawned && level.spawned);
    const QString said = QString("%1 m, %2 rad; level %3 m, %4 rad")
                             .arg(down.way.position_m.z())
                             .arg(down.way.pitch_rad)
                             .arg(level.way.position_m.z())
                             .arg(level.way.pitch_rad);
    QVERIFY2(down.way.position_m.z() < level.way.position_m.z() - 0.5, qPrintable(said));
    QVERIFY2(down.way.pitch_rad > level.way.pitch_rad + 0.1, qPrintable(said)); // the nose is lower
}

USAR_TEST(tst_HandLoop)

} // namespace tst_hand_loop

#include "tst_hand_loop.moc"
