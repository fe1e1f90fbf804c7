// How a robot is driven and how fast it may go, as its messages tell it.
#include <QTest>

#include "core/mission/hand/drive_limits.h"
#include "core/mission/hand/hand_driver.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_drive_limits {

using namespace usar;
using namespace usar::mission;

namespace {

DriveLimits toldBy(const QStringList& lines) {
    protocol::Reader reader;
    DriveLimits limits;
    for (const QString& line : lines)
        limits.take(reader.read(line.toStdString()).message);
    return limits;
}

/// "forward left turn up", those of them that the robot can follow.
QString wordsOf(const StickAxes& axes) {
    QStringList words;
    for (const auto& [can, word] : {std::pair(axes.forward, "forward"), std::pair(axes.left, "left"),
                                    std::pair(axes.turn, "turn"), std::pair(axes.up, "up")})
        if (can)
            words << word;
    return words.join(' ');
}

const QString ground = "STA {Type GroundVehicle} {Time 1}";
const QString skid = "CONF {Type GroundVehicle} {Name P2AT} {SteeringType SkidSteered} {MaxSpeed 5}";
const QString wheels = "GEO {Type GroundVehicle} {Name P2AT} {WheelRadius 0.1} {WheelSeparation 0.4}";

HandIntent pushed(HandSource source, double forward) {
    return {.source = source, .stick = {.forward = forward}};
}

} // namespace

class tst_DriveLimits : public QObject {
    Q_OBJECT
private slots:
    void theMessagesSayHowItIsDriven_data() {
        QTest::addColumn<QStringList>("lines");
        QTest::addColumn<int>("style");
        QTest::addColumn<QString>("axes");
        QTest::addColumn<QString>("hindrance");
        const auto row = [](const char* name, const QStringList& lines, DriveStyle style, const char* axes,
                            const char* hindrance = "") {
            QTest::newRow(name) << lines << int(style) << QString(axes) << QString(hindrance);
        };
        row("nothing was heard", {}, DriveStyle::Unknown, "");
        row("a flying robot", {"STA {Type AerialVehicle} {Time 1}"}, DriveStyle::Aerial, "forward left turn up");
        row("a boat", {"STA {Type NauticVehicle} {Time 1}"}, DriveStyle::Nautic, "forward turn up");
        row("wheels, not yet known how", {ground}, DriveStyle::Unknown, "");
        row("skid-steered", {ground, skid}, DriveStyle::Skid, "forward turn");
        row("configured before its state", {skid, ground}, DriveStyle::Skid, "forward turn");
        row("a car with one n",
            {ground, "CONF {Type GroundVehicle} {Name Hummer} {SteeringType ackermansteered} {MaxSpeed 5}"},
            DriveStyle::Ackermann, "forward turn");
        row("a car with two n", {ground, "CONF {Type GroundVehicle} {Name Hummer} {SteeringType AckermannSteered}"},
            DriveStyle::Ackermann, "forward turn");
        row("a ground vehicle that does not say", {ground, "CONF {Type GroundVehicle} {Name X} {Mass 14}"},
            DriveStyle::Skid, "forward turn");
        row("each wheel by itself",
            {ground, "CONF {Type GroundVehicle} {Name Rover} {SteeringType OmniDrive} {MaxSpeed 5}"},
            DriveStyle::Unknown, "", "Each of its wheels is steered by itself");
        row("a flying robot of UDK, by its climb",
            {"STA {Time 1} {Battery 5}", "CONF {Name AirRobot} {Type AerialVehicle} {MaxAltitudeVelocity 1}"},
            DriveStyle::Aerial, "forward left turn up");
        row("a platform", {"STA {Type StaticPlatform} {Time 1}"}, DriveStyle::Unknown, "", "fixed to the ground");
        row("unknown legs", {"STA {Type LeggedRobot} {Time 1} {Leg1 0.5}"}, DriveStyle::Unknown, "", "walks on legs");
        row("a vehicle of no kind", {"CONF {Type Robot} {Name X} {Mass 3}", "STA {Time 1} {Battery 5}"},
            DriveStyle::Unknown, "");
        row("sensors say nothing about it",
            {"SEN {Type Odometry} {Name O} {Pose 1,2,3}", "CONF {Type Sonar} {Name F1}"}, DriveStyle::Unknown, "");
    }

    void theMessagesSayHowItIsDriven() {
        QFETCH(QStringList, lines);
        QFETCH(int, style);
        QFETCH(QString, axes);
        QFETCH(QString, hindrance);
        const DriveLimits limits = toldBy(lines);
        QCOMPARE(int(limits.style), style);
        QCOMPARE(wordsOf(limits.axes()), axes);
        QCOMPARE(limits.known(), limits.style != DriveStyle::Unknown);
        const QString told = QString::fromStdString(limits.hindrance);
        QVERIFY2(hindrance.isEmpty() ? told.isEmpty() : told.contains(hindrance), qPrintable(told));
    }

    void theTopSpeedNeedsWheelsOrALimit_data() {
        QTest::addColumn<QStringList>("lines");
        QTest::addColumn<double>("speed_m_s");
        const QString air = "STA {Type AerialVehicle} {Time 1}";
        QTest::newRow("nothing was heard") << QStringList{} << -1.0;
        QTest::newRow("a flying robot without limits") << QStringList{air} << -1.0;
        QTest::newRow("a flying robot")
            << QStringList{air, "CONF {Type AerialVehicle} {Name A} {MaxLinearVelocity 4} {MaxAltitudeVelocity 1}"}
            << 4.0;
        QTest::newRow("spin without a radius") << QStringList{ground, skid} << -1.0;
        QTest::newRow("spin and radius") << QStringList{ground, skid, wheels} << 0.5;
        QTest::newRow("a radius of zero is none")
            << QStringList{ground, skid, "GEO {Type GroundVehicle} {Name P2AT} {WheelRadius 0}"} << -1.0;
        QTest::newRow("a negative spin is none")
            << QStringList{ground, "CONF {Type GroundVehicle} {Name P} {SteeringType SkidSteered} {MaxSpeed -5}",
                           wheels}
            << -1.0;
        QTest::newRow("the newest limit counts")
            << QStringList{ground, skid, wheels,
                           "CONF {Type GroundVehicle} {Name P} {SteeringType SkidSteered} {MaxSpeed 10}"}
            << 1.0;
        QTest::newRow("the size of a sensor is no wheel")
            << QStringList{ground, skid, "GEO {Type Sonar} {Name F Location 1,0,0 Orientation 0,0,0 Mount HARD}"}
            << -1.0;
    }

    void theTopSpeedNeedsWheelsOrALimit() {
        QFETCH(QStringList, lines);
        QFETCH(double, speed_m_s);
        QCOMPARE(toldBy(lines).topSpeed_m_s().value_or(-1.0), speed_m_s);
    }

    void whoeverGetsNoAnswerGuessesForTheGroundAlone() {
        DriveLimits on_ground = toldBy({ground});
        on_ground.giveUpAsking();
        QVERIFY(on_ground.style == DriveStyle::Skid && on_ground.configured && on_ground.hindrance.empty());
        DriveLimits unknown;
        unknown.giveUpAsking();
        QVERIFY(unknown.style == DriveStyle::Unknown && unknown.configured);
        QCOMPARE(unknown.hindrance, std::string("The server does not say what kind of vehicle it is."));
        DriveLimits platform = toldBy({"STA {Type StaticPlatform} {Time 1}"});
        platform.giveUpAsking();
        QCOMPARE(platform.hindrance, std::string("It is fixed to the ground."));
    }

    void theFirstDeviceHasTheRobotUntilItIsReleased() {
        using Verdict = HandControl::Verdict;
        HandControl hands;
        QCOMPARE(int(hands.accept(pushed(HandSource::Keys, 1.0), Seconds{0.0})), int(Verdict::Ignored));
        hands.setOn(true);
        QCOMPARE(int(hands.accept(pushed(HandSource::Keys, 1.0), Seconds{0.1})), int(Verdict::Ignored));
        QCOMPARE(int(hands.accept(pushed(HandSource::Keys, 0.0), Seconds{0.2})), int(Verdict::Ignored));
        QCOMPARE(int(hands.accept(pushed(HandSource::Keys, 1.0), Seconds{0.3})), int(Verdict::Held));
        QCOMPARE(int(hands.accept(pushed(HandSource::Pad, 1.0), Seconds{0.4})), int(Verdict::Ignored));
        QCOMPARE(int(hands.accept(pushed(HandSource::Keys, 0.0), Seconds{0.5})), int(Verdict::Released));
        QVERIFY(!hands.holding());
        QCOMPARE(int(hands.accept(pushed(HandSource::Pad, 1.0), Seconds{0.6})), int(Verdict::Ignored));
        QCOMPARE(int(hands.accept(pushed(HandSource::Pad, 0.0), Seconds{0.7})), int(Verdict::Ignored));
        QCOMPARE(int(hands.accept(pushed(HandSource::Pad, 1.0), Seconds{0.8})), int(Verdict::Held));
    }

    void aHeldDeviceThatFallsSilentIsOverdue() {
        HandControl hands;
        hands.setOn(true);
        QVERIFY(!hands.overdue(Seconds{99.0}, Seconds{0.3}));
        hands.accept(pushed(HandSource::Gamepad, 1.0), Seconds{1.0});
        QVERIFY(!hands.overdue(Seconds{1.3}, Seconds{0.5}));
        QVERIFY(hands.overdue(Seconds{1.6}, Seconds{0.5}));
        hands.accept(pushed(HandSource::Gamepad, 0.5), Seconds{1.7});
        QVERIFY(!hands.overdue(Seconds{1.9}, Seconds{0.5}));
        hands.letGo();
        QVERIFY(!hands.overdue(Seconds{99.0}, Seconds{0.5}));
    }
};

USAR_TEST(tst_DriveLimits)

} // namespace tst_drive_limits

#include "tst_drive_limits.moc"
