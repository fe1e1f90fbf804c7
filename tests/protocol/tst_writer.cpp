#include <QTest>

#include <cmath>

#include "core/base/random.h"
#include "core/protocol/reader.h"
#include "core/protocol/writer.h"
#include "tests/suite/suite.h"

namespace tst_writer {

using namespace usar;
using namespace usar::protocol;

namespace {

QByteArray written(const InfoMessage& message) {
    std::string line;
    write(message, line);
    return QByteArray::fromStdString(line);
}

template <class T>
T readAgain(const T& value) {
    Reader reader;
    std::string line;
    write(value, line);
    const InfoLine result = reader.read(line);
    if (!std::holds_alternative<T>(result.message) || !result.diagnostics.empty())
        qFatal("not read again: %s", line.c_str());
    return std::get<T>(result.message);
}

double angleBetween(double a_rad, double b_rad) {
    return std::abs(normalizedAngle(a_rad - b_rad));
}

Pose anyPose(Random& random) {
    return {{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -50, 50)},
            uniform(random, -pi, pi),
            uniform(random, -1.5, 1.5),
            uniform(random, -pi, pi)};
}

bool within(const Pose& a, const Pose& b, double tolerance) {
    return (a.position_m - b.position_m).cwiseAbs().maxCoeff() <= tolerance &&
           angleBetween(a.roll_rad, b.roll_rad) <= tolerance && angleBetween(a.pitch_rad, b.pitch_rad) <= tolerance &&
           angleBetween(a.yaw_rad, b.yaw_rad) <= tolerance;
}

} // namespace

class tst_Writer : public QObject {
    Q_OBJECT
private slots:
    void spellsLinesAsUt2004Does_data();
    void spellsLinesAsUt2004Does();
    void appendsToWhatIsThere();
    void anglesOfTruthNeverGoNegative();
    void posesComeBackWithinTheirDecimals();
    void scansComeBackWithinTheirDecimals();
    void discreteMessagesComeBackExactly();
};

void tst_Writer::spellsLinesAsUt2004Does_data() {
    // The lines as a UT2004 server prints them: what is read must be written the same, to the last byte.
    QTest::addColumn<QByteArray>("line");
    const auto row = [](const char* name, const char* line) { QTest::newRow(name) << QByteArray(line); };
    row("greeting", "NFO {Gametype BotDeathMatch} {Level DM-USAR_yellow_250} {TimeLimit 0}");
    row("lockstep", "NFO {Lockstep True}");
    row("no start poses", "NFO {StartPoses 0}");
    row("start poses", "NFO {StartPoses 2} {PlayerStart 0.75,-7.28,-0.44 0.00,0.00,0.00 robot1 3.63,10.80,-0.18 "
                       "0.00,0.00,-1.59}");
    row("aerial state", "STA {Type AerialVehicle} {Time 268.50} {LightToggle False} {LightIntensity 0} {Battery 1180} "
                        "{View -1}");
    row("ground state", "STA {Type GroundVehicle} {Time 48.22} {FrontSteer 0.1000} {RearSteer -0.1000} {FRFlipper "
                        "-0.0006} {FLFlipper -0.0005} {LightToggle True} {LightIntensity 0} {Battery 1196} {View -1}");
    row("sonars", "SEN {Time 395.6055} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 2.4576}");
    row("scan", "SEN {Time 395.38} {Type RangeScanner} {Name Scanner1} {Resolution 0.0174} {FOV 3.1415} {Range "
                "2.1924,2.1961,20.0000}");
    row("scan of another scanner", "SEN {Time 30.20} {Type IRScanner} {Name IRScan} {Resolution 0.0174} {FOV 0.0348} "
                                   "{Range 1.1200,1.1000,1.0900}");
    row("state with more than we know", "STA {Type AerialVehicle} {Time 268.50} {Battery 1180} {Mode Hover} {Lone}");
    row("sonars without a range", "SEN {Time 395.6055} {Type Sonar} {Name F1} {Echo 0.3}");
    row("INS", "SEN {Type INS} {Name INS} {Location 4.50,1.90,1.80} {Orientation 0.00,6.28,3.01}");
    row("ground truth", "SEN {Time 395.3833} {Type GroundTruth} {Name GroundTruth} {Location 4.50,1.90,-1.85} "
                        "{Orientation 0.00,6.28,6.28}");
    row("odometry", "SEN {Type Odometry} {Name Odometry} {Pose 0.0320,0.0014,0.0296}");
    row("encoders", "SEN {Type Encoder} {Name ECLeft Tick -30} {Name ECRight Tick -18}");
    row("geometry of a robot",
        "GEO {Type GroundVehicle} {Name P2AT} {Dimensions 0.5238,0.4968,0.2913} {COG "
        "0.0100,0.0200,-0.0300} {WheelRadius 0.1300} {WheelSeparation 0.4712} {WheelBase 0.2884}");
    row("geometry of sonars", "GEO {Type Sonar} {Name F2 Location 0.1850,-0.1150,0.0100 Orientation "
                              "0.0000,0.1000,-0.8727 Mount HARD} {Name F3 Location 0.2200,-0.0800,0.0100 Orientation "
                              "0.0000,0.1000,-0.5235 Mount HARD}");
    row("no such thing", "GEO {Type Laser}");
    row("configuration", "CONF {Type Sonar} {Name R8} {MaxRange 5.0000} {MinRange 0.1000} {BeamAngle 0.3491}");
    row("response", "RES {Time 120.40} {Type INS} {Name INS} {Status OK}");
    row("failure", "RES {Time 120.40} {Type INS} {Name INS} {Status Failed}");
    row("anything else", "EFF {Time 41.2000} {Type Gripper} {Name Gripper1} {On}");
}

void tst_Writer::spellsLinesAsUt2004Does() {
    QFETCH(QByteArray, line);
    Reader reader;
    QByteArray again = written(reader.read(line.toStdString()).message);
    // Half a turn about x turns a 0 into a -0, which real servers print as freely.
    for (const char* minus_zero : {"-0.0000,", "-0.0000}", "-0.0000 ", "-0.00,", "-0.00}", "-0.00 "})
        again.replace(minus_zero, minus_zero + 1);
    QCOMPARE(again, line);
}

void tst_Writer::appendsToWhatIsThere() {
    std::string out = "first\r\n";
    write(LockstepInfo{false}, out);
    QCOMPARE(out, std::string("first\r\nNFO {Lockstep False}"));
}

void tst_Writer::anglesOfTruthNeverGoNegative() {
    const QByteArray line = written(GroundTruthReading{Seconds(1), "G", {{0, 0, 0}, -0.01, 0.02, 1.0}});
    QVERIFY2(line.contains("{Orientation 6.27,6.26,5.28}"), line.constData());
    QVERIFY(line.contains("{Time 1.0000}"));
}

void tst_Writer::posesComeBackWithinTheirDecimals() {
    Random random = seeded(31, 1);
    for (int i = 0; i < 2000; ++i) {
        const Pose pose = anyPose(random);
        constexpr double half_a_hundredth = 0.005 + 1e-9;
        QVERIFY(within(readAgain(GroundTruthReading{Seconds(1.25), "G", pose}).base_in_map, pose, half_a_hundredth));
        QVERIFY(within(readAgain(InsReading{std::nullopt, "I", pose}).base_in_map, pose, half_a_hundredth));
        QVERIFY(within(readAgain(StartPoses{{{"A", pose}}}).poses[0].pose_in_map, pose, half_a_hundredth));
        const GeometryInfo mounted{.type = "Sonar", .items = {{"F1", pose, "HARD"}}};
        QVERIFY(within(readAgain(mounted).items[0].item_in_mount, pose, 1e-4));
        const Pose flat{{pose.position_m.x(), pose.position_m.y(), 0}, 0, 0, pose.yaw_rad};
        QVERIFY(within(*readAgain(OdometryReading{Seconds(2), "O", flat}).base_in_start, flat, 1e-4));
    }
}

void tst_Writer::scansComeBackWithinTheirDecimals() {
    Random random = seeded(32, 1);
    RangeScan scan{Seconds(3.5), "Belly", 0.0174, 3.1415, {}};
    for (int i = 0; i < 181; ++i)
        scan.ranges_m.push_back(uniform(random, 0.1, 20.0));
    RangeScan again = readAgain(scan);
    QCOMPARE(again.ranges_m.size(), std::size_t(181));
    for (std::size_t i = 0; i < 181; ++i) {
        // cut, so never longer
        QVERIFY(again.ranges_m[i] <= scan.ranges_m[i] + 1e-9);
        QVERIFY(scan.ranges_m[i] - again.ranges_m[i] < 1e-4);
    }
    QVERIFY(readAgain(again) == again);
}

void tst_Writer::discreteMessagesComeBackExactly() {
    const EncoderReadings encoders{Seconds(1), {{"A", -1234567890123}, {"B", 0}}};
    QVERIFY(readAgain(encoders) == encoders);
    const RobotState state{
        .kind = VehicleKind::Legged, .time = Seconds(2.25), .battery_left = Seconds(7), .light_on = true};
    QVERIFY(readAgain(state) == state);
    QCOMPARE(readAgain(RobotState{.time = Seconds(1), .battery_left = Seconds(6.9)}).battery_left->count(), 6.0);
    const Response response{Seconds(1), "INS", "INS", true, {{"Name", "INS", true, std::nullopt}}, std::nullopt, {}};
    QVERIFY(readAgain(response) == response);
    const Response tag{Seconds(1), "RFID", "R", true, {{"Name", "R", true, std::nullopt}}, 118, "seen by robot 2"};
    QVERIFY(readAgain(tag) == tag);
    const GameInfo game{"G", "L", 5};
    QVERIFY(readAgain(game) == game);
    const ConfigurationInfo numbers{"AerialVehicle", {{"AirRobot", {{"MaxLinearVelocity", "", 5.0}}}}};
    QCOMPARE(readAgain(numbers).items[0].settings[0].value, std::string("5.0000"));
    const RobotState more{.kind = VehicleKind::Ground, .time = Seconds(1), .others = {{"Mode", "Auto"}, {"Lone", ""}}};
    QVERIFY(readAgain(more) == more);
    const RangeScan infrared{Seconds(1.5), "IR", 0.0174, 0.0348, {1.5, 2.0, 2.5}, "IRScanner"};
    QVERIFY(readAgain(infrared) == infrared);
}

USAR_TEST(tst_Writer)

} // namespace tst_writer

#include "tst_writer.moc"
