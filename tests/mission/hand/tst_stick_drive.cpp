// From a person's stick to the DRIVE of each kind of robot, by what its server told.
#include <cmath>
#include <functional>

#include <QTest>

#include "core/mission/hand/stick_drive.h"
#include "core/mission/hand/walking_gait.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_stick_drive {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr const char* aerial = "STA {Type AerialVehicle} {Time 1.00}";
constexpr const char* ground = "STA {Type GroundVehicle} {Time 1.00}";
constexpr const char* nautic = "STA {Type NauticVehicle} {Time 1.00}";
constexpr const char* air_limits =
    "CONF {Type AerialVehicle} {Name AirRobot} {SteeringType RotaryWing} {MaxLateralVelocity 2} "
    "{MaxLinearVelocity 4} {MaxAltitudeVelocity 1} {MaxRotationalVelocity 1.5}";
constexpr const char* skid_limits =
    "CONF {Type GroundVehicle} {Name P2AT} {SteeringType SkidSteered} {Mass 14} {MaxSpeed 5} {MaxFrontSteer 0}";
constexpr const char* skid_geometry =
    "GEO {Type GroundVehicle} {Name P2AT} {WheelRadius 0.1} {WheelSeparation 0.4} {WheelBase 0.3}";
constexpr const char* car_limits =
    "CONF {Type GroundVehicle} {Name Sedan} {SteeringType AckermanSteered} {MaxSpeed 60} {MaxFrontSteer 0.5}";
constexpr const char* boat_limits = "CONF {Type NauticVehicle} {Name Submarine} {SteeringType VariableDepth} "
                                    "{MaxPropellerSpeed 160} {MaxRudderAngle 0.35} {MaxSternPlaneAngle 0.25}";

DriveLimits learntFrom(const QByteArrayList& lines) {
    protocol::Reader reader;
    DriveLimits limits;
    for (const QByteArray& line : lines)
        limits.take(reader.read(line.toStdString()).message);
    return limits;
}

/// Without what says no more than its absence; numbers to four places.
QString lineOf(const std::optional<protocol::Command>& command) {
    return command ? QString::fromStdString(protocol::write(*command)).remove(" {Normalized false}")
                   : QString("nothing");
}

protocol::JointAngle joint(const std::string& name) {
    return {name, 0.0};
}

std::vector<protocol::JointAngle> dogJoints() {
    std::vector<protocol::JointAngle> joints;
    for (const char* leg : {"LF", "RF", "LH", "RH"})
        for (const char* part : {"Leg1", "Leg2", "Leg3"})
            joints.push_back(joint(std::string(leg) + part));
    return joints;
}

double angleOf(const protocol::MultiDrive& drive, const char* name) {
    for (const auto& target : drive.joints)
        if (target.joint.text() == name)
            return target.angle_rad;
    return std::nan("");
}

} // namespace

class tst_StickDrive : public QObject {
    Q_OBJECT
private slots:
    void aStickBecomesTheDriveOfItsKind_data() {
        QTest::addColumn<QByteArrayList>("told");
        QTest::addColumn<Stick>("stick");
        QTest::addColumn<double>("share");
        QTest::addColumn<QString>("drive");
        const auto row = [](const char* name, const QByteArrayList& told, const Stick& stick, double share,
                            const char* drive) { QTest::newRow(name) << told << stick << share << drive; };
        const QByteArrayList air{aerial, air_limits};
        row("flying, forward", air, {.forward = 1.0}, 1.0,
            "DRIVE {AltitudeVelocity 0} {LinearVelocity 4} {LateralVelocity 0} {RotationalVelocity 0}");
        row("flying, to the left, which the wire calls minus", air, {.left = 1.0}, 0.5,
            "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity -1} {RotationalVelocity 0}");
        row("flying, up and round to the left", air, {.turn = 1.0, .up = 0.5}, 1.0,
            "DRIVE {AltitudeVelocity 0.5} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity -1.5}");
        row("flying, limits not told", {aerial}, {.forward = 0.5}, 0.5,
            "DRIVE {AltitudeVelocity 0} {LinearVelocity 25} {LateralVelocity 0} {RotationalVelocity 0} {Normalized "
            "true}");
        const QByteArrayList skid{ground, skid_limits, skid_geometry};
        row("on two sides, forward", skid, {.forward = 1.0}, 1.0, "DRIVE {Left 5} {Right 5}");
        row("on two sides, back at half speed", skid, {.forward = -1.0}, 0.5, "DRIVE {Left -2.5} {Right -2.5}");
        row("on two sides, round to the left", skid, {.turn = 1.0}, 1.0, "DRIVE {Left -4} {Right 4}");
        row("on two sides, a curve keeps its shape at the limit", skid, {.forward = 1.0, .turn = 1.0}, 1.0,
            "DRIVE {Left 0.5555555555555554} {Right 5}");
        row("on two sides, nothing sideways", skid, {.left = 1.0}, 1.0, "DRIVE {Left 0} {Right 0}");
        row("on two sides, more than the whole stick", skid, {.forward = 7.0}, 1.0, "DRIVE {Left 5} {Right 5}");
        row("on two sides, no number", skid, {.forward = std::nan("")}, 1.0, "DRIVE {Left 0} {Right 0}");
        row("a car, forward and left", {ground, car_limits}, {.forward = 1.0, .turn = 1.0}, 0.5,
            "DRIVE {Speed 30} {FrontSteer -0.5} {RearSteer 0}");
        row("a car steers as far at any speed", {ground, car_limits}, {.turn = -1.0}, 0.1,
            "DRIVE {Speed 0} {FrontSteer 0.5} {RearSteer 0}");
        row("diving, down and to the left", {nautic, boat_limits}, {.forward = 1.0, .turn = 1.0, .up = -1.0}, 0.5,
            "DRIVE {Propeller 80} {Rudder -0.35} {SternPlane -0.25}");
        row("diving, limits not told", {nautic}, {.forward = 1.0, .up = 1.0}, 0.5,
            "DRIVE {Propeller 50} {Rudder 0} {SternPlane 100} {Normalized true}");
        row("UDK's flyer, which does not say that it is one",
            {"STA {Time 1.0000} {Battery 1200}",
             "CONF {Type AerialVehicle} {Name AirRobot} {MaxLinearVelocity 2} "
             "{MaxAltitudeVelocity 2} {MaxLateralVelocity 2} {MaxRotationalVelocity 1}"},
            {.up = 1.0}, 1.0,
            "DRIVE {AltitudeVelocity 2} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}");
        row("on wheels that have not said how they steer", {ground}, {.forward = 1.0}, 1.0, "nothing");
    }

    void aStickBecomesTheDriveOfItsKind() {
        QFETCH(QByteArrayList, told);
        QFETCH(Stick, stick);
        QFETCH(double, share);
        QFETCH(QString, drive);
        QCOMPARE(lineOf(driveOf(learntFrom(told), stick, share)), drive);
    }

    void aCenteredStickIsAZeroOfEveryTerm_data() {
        QTest::addColumn<QByteArrayList>("told");
        QTest::addColumn<QString>("drive");
        QTest::newRow("in the air") << QByteArrayList{aerial, air_limits}
                                    << "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} "
                                       "{RotationalVelocity 0}";
        QTest::newRow("on two sides") << QByteArrayList{ground, skid_limits} << "DRIVE {Left 0} {Right 0}";
        QTest::newRow("a car") << QByteArrayList{ground, car_limits} << "DRIVE {Speed 0} {FrontSteer 0} {RearSteer 0}";
        QTest::newRow("in the water") << QByteArrayList{nautic, boat_limits}
                                      << "DRIVE {Propeller 0} {Rudder 0} {SternPlane 0}";
    }

    void aCenteredStickIsAZeroOfEveryTerm() {
        QFETCH(QByteArrayList, told);
        QFETCH(QString, drive);
        QCOMPARE(lineOf(driveOf(learntFrom(told), {}, 1.0)).remove('-'), drive);
    }

    void whatCannotBeDrivenSaysWhy_data() {
        QTest::addColumn<QByteArrayList>("told");
        QTest::addColumn<bool>("unanswered");
        QTest::addColumn<QString>("words");
        QTest::newRow("wheels that steer one by one")
            << QByteArrayList{ground, "CONF {Type GroundVehicle} {Name Kurt} {SteeringType OmniDrive} {MaxSpeed 5}"}
            << false << "by itself";
        QTest::newRow("a platform") << QByteArrayList{"STA {Type StaticPlatform} {Time 1.00}"} << false
                                    << "fixed to the ground";
        QTest::newRow("two legs") << QByteArrayList{"STA {Type LeggedRobot} {Time 1.00} {LeftHip 0.1}"} << false
                                  << "no gait";
        QTest::newRow("no kind and no answer")
            << QByteArrayList{"STA {Time 1.0000} {Battery 1200}"} << true << "does not say";
    }

    void whatCannotBeDrivenSaysWhy() {
        QFETCH(QByteArrayList, told);
        QFETCH(bool, unanswered);
        QFETCH(QString, words);
        DriveLimits limits = learntFrom(told);
        if (unanswered)
            limits.giveUpAsking();
        QVERIFY2(QString::fromStdString(limits.hindrance).contains(words), limits.hindrance.c_str());
        QVERIFY(!limits.known() && !limits.axes().any());
        QVERIFY(!driveOf(limits, {.forward = 1.0}, 1.0));
    }

    /// Its wheels could: 16.5 rad/s on a 0.33 m track are nearly 10 rad/s of yaw.
    void aPioneerDoesNotSpinTenTimesASecond() {
        const DriveLimits limits =
            learntFrom({ground, "CONF {Type GroundVehicle} {Name P2DX} {SteeringType SkidSteered} {MaxSpeed 16.5}",
                        "GEO {Type GroundVehicle} {Name P2DX} {WheelRadius 0.1} {WheelSeparation 0.33} {WheelBase 0}"});
        const auto drive = std::get<protocol::SkidDrive>(*driveOf(limits, {.turn = 1.0}, 1.0));
        const double yaw_rate_rad_s = (*drive.right_rad_s - *drive.left_rad_s) * 0.1 / 0.33;
        QVERIFY(std::abs(yaw_rate_rad_s - most_yaw_rate_rad_s) < 1e-9);
        QVERIFY(std::abs(limits.topSpeed_m_s().value() - 1.65) < 1e-9);
    }

    void aDeadZoneLeavesNoJump() {
        const auto shaped = [](double x, double y) {
            applyDeadZone(x, y, 0.2);
            return std::pair(x, y);
        };
        QCOMPARE(shaped(0.1, -0.1), std::pair(0.0, 0.0));
        QCOMPARE(shaped(1.0, 0.0), std::pair(1.0, 0.0));
        QVERIFY(shaped(0.21, 0.0).first < 0.02);
        const auto [x, y] = shaped(0.05, 0.9);
        QVERIFY(x > 0.04 && y > 0.8); // the slight turn of a hard push stays
        QCOMPARE(shaped(std::nan(""), 0.5), std::pair(0.0, 0.0));
    }

    void aStickRisesInItsTimeAndFallsAtOnce() {
        StickShaper shaper;
        const Seconds beat = StickShaper::rise / 8.0;
        QVERIFY(std::abs(shaper.follow({.forward = 1.0}, beat).forward - 0.125) < 1e-9);
        for (int i = 0; i < 7; ++i)
            shaper.follow({.forward = 1.0}, beat);
        QVERIFY(std::abs(shaper.now().forward - 1.0) < 1e-9);
        QCOMPARE(shaper.follow({.forward = 0.5}, beat).forward, 0.5);
        const double reversed = shaper.follow({.forward = -1.0}, beat).forward;
        QVERIFY(std::abs(reversed + 0.125) < 1e-9); // through rest, never a jump to the other end
        QVERIFY(shaper.follow({}, beat).centered());
    }

    void aDogBendsItsKneesBeforeItsFirstStep() {
        QVERIFY(WalkingGait::fits(dogJoints()));
        WalkingGait gait;
        double knee_rad = 0.0;
        for (int step = 0; step < 5; ++step) {
            const auto drive = gait.step({.forward = 1.0}, 1.0, Seconds(0.2 * step));
            QVERIFY(drive && drive->joints.size() == 12);
            QVERIFY(angleOf(*drive, "LFLeg3") > knee_rad);
            QCOMPARE(angleOf(*drive, "LFLeg3"), angleOf(*drive, "RHLeg3"));
            knee_rad = angleOf(*drive, "LFLeg3");
        }
        QVERIFY(knee_rad > 1.0 && knee_rad < 2.1);
    }

    void aDogsLegsStepInPairsOncePerStepTime() {
        WalkingGait gait;
        double now_s = 0.0;
        for (int step = 0; step < 5; ++step, now_s += 0.2)
            gait.step({.forward = 1.0}, 1.0, Seconds(now_s));
        const auto first = gait.step({.forward = 1.0}, 1.0, Seconds(now_s));
        QVERIFY(first);
        QVERIFY(!gait.step({.forward = 1.0}, 1.0, Seconds(now_s + 0.1)));
        QCOMPARE(angleOf(*first, "LFLeg1"), angleOf(*first, "RHLeg1"));
        QCOMPARE(angleOf(*first, "RFLeg1"), angleOf(*first, "LHLeg1"));
        QVERIFY(angleOf(*first, "LFLeg3") > angleOf(*first, "RFLeg3")); // lifted
        const protocol::MultiDrive stand = gait.stand();
        QCOMPARE(angleOf(stand, "LFLeg3"), angleOf(stand, "RFLeg3"));
    }

    void aTurningDogStepsLongerOnItsOuterSide() {
        const auto reachOf = [](const char* hip) {
            WalkingGait gait;
            double least = 10.0;
            double most = -10.0;
            for (int step = 0; step < 13; ++step) {
                const double angle = angleOf(*gait.step({.forward = 1.0, .turn = 0.5}, 1.0, Seconds(0.2 * step)), hip);
                if (step < 5)
                    continue;
                least = std::min(least, angle);
                most = std::max(most, angle);
            }
            return most - least;
        };
        QVERIFY(reachOf("RFLeg1") > reachOf("LFLeg1") + 0.1);
        QVERIFY(reachOf("RHLeg1") > reachOf("LHLeg1") + 0.1);
    }
};

USAR_TEST(tst_StickDrive)

} // namespace tst_stick_drive

#include "tst_stick_drive.moc"
