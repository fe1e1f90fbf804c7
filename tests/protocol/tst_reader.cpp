#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_reader {

using namespace usar;
using namespace usar::protocol;

namespace {

InfoLine read(const std::string& line) {
    Reader reader;
    return reader.read(line);
}

/// The value, which must be of this type and read without a diagnostic.
template <class T>
T cleanly(const std::string& line) {
    const InfoLine result = read(line);
    if (!std::holds_alternative<T>(result.message) || !result.diagnostics.empty())
        qFatal("not read cleanly: %s", line.c_str());
    return std::get<T>(result.message);
}

bool near(const Pose& pose, const Vec3& position_m, const Vec3& angles_rad) {
    return (pose.position_m - position_m).norm() < 1e-9 && std::abs(pose.roll_rad - angles_rad.x()) < 1e-9 &&
           std::abs(pose.pitch_rad - angles_rad.y()) < 1e-9 && std::abs(pose.yaw_rad - angles_rad.z()) < 1e-9;
}

int countOf(const Diagnostics& diagnostics, Severity severity) {
    return static_cast<int>(std::ranges::count(diagnostics, severity, &Diagnostic::severity));
}

} // namespace

class tst_Reader : public QObject {
    Q_OBJECT
private slots:
    void numbersLinesFromOneAndKeepsTheirText();
    void readsTheGreeting();
    void readsStartPosesInAllForms_data();
    void readsStartPosesInAllForms();
    void readsStateOfEveryDialect();
    void answersToGetStaAreThingsInTheWorld_data();
    void answersToGetStaAreThingsInTheWorld();
    void readsSonarsGroupedAndSingle_data();
    void readsSonarsGroupedAndSingle();
    void readsScannersByShape_data();
    void readsScannersByShape();
    void readsPosesIntoOurFrame();
    void anEmptyHeadIsNoNews_data();
    void anEmptyHeadIsNoNews();
    void whatItsTableCannotTakeIsKeptWhole_data();
    void whatItsTableCannotTakeIsKeptWhole();
    void keepsWhatNoFieldOfTheStateHolds();
    void readsEncodersGroupedAndSingle();
    void readsGeometryOfRobots();
    void readsGeometryOfItemsGroupedSingleAndLinked_data();
    void readsGeometryOfItemsGroupedSingleAndLinked();
    void readsConfigurationsInTheirOrder();
    void readsResponsesOfAnyCase_data();
    void readsResponsesOfAnyCase();
    void notANumberAmongRangesIsNanAndAWarning_data();
    void notANumberAmongRangesIsNanAndAWarning();
    void warnsOfDamageAndKeepsTheRest_data();
    void warnsOfDamageAndKeepsTheRest();
    void keepsUnknownLinesWhole();
};

void tst_Reader::numbersLinesFromOneAndKeepsTheirText() {
    Reader reader;
    QCOMPARE(reader.read("STA {Time 1.00} {Battery 5}").number.value, 1u);
    const InfoLine second = reader.read("  anything at all }{ ");
    QCOMPARE(second.number.value, 2u);
    QCOMPARE(second.text, std::string("  anything at all }{ "));
}

void tst_Reader::readsTheGreeting() {
    const auto game = cleanly<GameInfo>("NFO {Gametype BotDeathMatch} {Level DM-X_250} {TimeLimit 20}");
    QVERIFY(game == (GameInfo{"BotDeathMatch", "DM-X_250", 20}));
    QVERIFY(!cleanly<GameInfo>("NFO {Level DM-X_250}").time_limit_min);
    QVERIFY(cleanly<LockstepInfo>("NFO {Lockstep True}").on);
    QVERIFY(!cleanly<LockstepInfo>("NFO {Lockstep false}").on);
}

void tst_Reader::readsStartPosesInAllForms_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("warnings");
    const auto row = [](const char* name, const char* line, int count, int warnings) {
        QTest::newRow(name) << QByteArray(line) << count << warnings;
    };
    row("triplets", "NFO {StartPoses 2} {A_1 1.00,2.00,3.00 0.10,0.20,0.30 B 4,5,6 0,0,0}", 2, 0);
    row("one segment each",
        "NFO {StartPoses 2} {Name A_1 Location 1,2,3 Orientation 0.1,0.2,0.3} {Name B Location "
        "4,5,6 Orientation 0,0,0}",
        2, 0);
    row("vectors with spaces", "NFO {StartPoses 1}{A_1 1.0, 2.0, 3.0 0.1,0.2,0.3}", 1, 0);
    row("vectors with spaces only", "NFO {StartPoses 1}{A_1 1.0 2.0 3.0 0.1 0.2 0.3}", 1, 0);
    row("none", "NFO {StartPoses 0}", 0, 0);
    row("a name of digits", "NFO {StartPoses 1} {7 1,2,3 0.1,0.2,0.3}", 1, 0);
    row("fewer than announced", "NFO {StartPoses 2} {A_1 1.00,2.00,3.00 0.10,0.20,0.30}", 1, 1);
}

void tst_Reader::readsStartPosesInAllForms() {
    QFETCH(QByteArray, line);
    QFETCH(int, count);
    QFETCH(int, warnings);
    const InfoLine result = read(line.toStdString());
    const StartPoses* const start = std::get_if<StartPoses>(&result.message);
    QVERIFY(start);
    QCOMPARE(static_cast<int>(start->poses.size()), count);
    QCOMPARE(countOf(result.diagnostics, Severity::Warning), warnings);
    if (count > 0)
        QVERIFY(near(start->poses[0].pose_in_map, {1, -2, -3}, {0.1, -0.2, -0.3}));
    if (count > 1)
        QCOMPARE(start->poses[1].name, std::string("B"));
}

void tst_Reader::readsStateOfEveryDialect() {
    const auto aerial = cleanly<RobotState>(
        "STA {Type AerialVehicle} {Time 268.50} {LightToggle False} {LightIntensity 0} {Battery 1180} {View -1}");
    QVERIFY(aerial == (RobotState{.kind = VehicleKind::Aerial,
                                  .time = Seconds(268.5),
                                  .battery_left = Seconds(1180),
                                  .light_on = false,
                                  .light_intensity_pct = 0,
                                  .view = -1}));

    const auto ground = cleanly<RobotState>("STA {Time 47.9754} {Battery 99999} {Type GroundVehicle} {LightToggle "
                                            "True} {LightIntensity 100} {FrontSteer 0.2618} {RearSteer 0}");
    QVERIFY(ground.kind == VehicleKind::Ground);
    QCOMPARE(ground.front_steer_rad.value(), -0.2618);
    QVERIFY(!ground.view);
    QVERIFY(ground.joints.empty());

    const auto nameless = cleanly<RobotState>("STA {Time 12.1000} {Battery 1200}");
    QVERIFY(nameless.kind == VehicleKind::Unknown);
    QVERIFY(!nameless.front_steer_rad && !nameless.light_on);

    const auto legged = cleanly<RobotState>("STA {Time 1} {Type LeggedVehicle} {HeadYaw 0.5} {HeadPitch -0.1745}");
    QVERIFY(legged.joints == (std::vector<JointAngle>{{"HeadYaw", 0.5}, {"HeadPitch", -0.1745}}));

    QVERIFY(cleanly<RobotState>("STA {Type GroundVehicle}{Time 12.345}{Battery 3600}{CountPer1sec 10}").joints.empty());
    QVERIFY(cleanly<RobotState>("STA {Type staticplatform} {Time 1}").kind == VehicleKind::StaticPlatform);
}

void tst_Reader::answersToGetStaAreThingsInTheWorld_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("warnings");
    QTest::newRow("whole braces") << QByteArray("STA {Name Box1} {Size 0.5,0.5,0.5} {Location 1,2,3} {Memory hi there} "
                                                "{Rotation 0,0,1.5}")
                                  << 1 << 0;
    QTest::newRow("the server's own braces, two things")
        << QByteArray(
               "STA {Name Box1} {Size 0.5,0.5,0.5} {Location 1,2,3 {Memory {hi there} {Rotation 0,0,1.5} {Name B} "
               "{Size 1,1,1} {Location 4,5,6 {Memory {} {Rotation 0,0,0}")
        << 2 << 1;
    QTest::newRow("no thing at all") << QByteArray("STA") << 0 << 0;
}

void tst_Reader::answersToGetStaAreThingsInTheWorld() {
    QFETCH(QByteArray, line);
    QFETCH(int, count);
    QFETCH(int, warnings);
    const InfoLine result = read(line.toStdString());
    const auto* const world = std::get_if<WorldObjects>(&result.message);
    QVERIFY(world);
    QCOMPARE(static_cast<int>(world->objects.size()), count);
    QCOMPARE(static_cast<int>(result.diagnostics.size()), warnings);
    if (count == 0)
        return;
    const WorldObject& box = world->objects.front();
    QCOMPARE(box.name, std::string("Box1"));
    QCOMPARE(box.memory, std::string("hi there"));
    QVERIFY(*box.size_m == Vec3(0.5, 0.5, 0.5));
    QVERIFY(box.object_in_map.position_m == Vec3(1, -2, -3));
    QCOMPARE(box.object_in_map.yaw_rad, -1.5);
}

void tst_Reader::readsSonarsGroupedAndSingle_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("grouped") << QByteArray("SEN {Time 2.5} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 5.0}");
    QTest::newRow("single") << QByteArray("SEN {Time 2.5} {Type Sonar} {Name F1} {Range 4.5604} {Name F2} {Range 5.0}");
    QTest::newRow("mixed, any case") << QByteArray(
        "sen {TIME 2.5} {type sonar} {name F1 RANGE 4.5604} {NAME F2}{range 5}");
}

void tst_Reader::readsSonarsGroupedAndSingle() {
    QFETCH(QByteArray, line);
    QVERIFY(cleanly<SonarReadings>(line.toStdString()) == (SonarReadings{Seconds(2.5), {{"F1", 4.5604}, {"F2", 5.0}}}));
}

void tst_Reader::readsScannersByShape_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<bool>("is_scan");
    const auto row = [](const char* name, const char* line, bool is_scan) {
        QTest::newRow(name) << QByteArray(line) << is_scan;
    };
    row("RangeScanner", "SEN {Time 1} {Type RangeScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1.5,2,.25}", true);
    row("IRScanner", "SEN {Time 1} {Type IRScanner} {Name S} {Resolution 0.5} {FOV 1} {Range 1.5,2,.25}", true);
    row("an unheard-of laser", "SEN {Time 1} {Type Laser9} {Name S} {Resolution 0.5} {FOV 1} {Range 1.5,2,.25}", true);
    row("any order, spaces", "SEN {Type Laser}{Range 1.5, 2 , .25}{FOV 1}{Name S}{Resolution 0.5}{Time 1}", true);
    row("trailing comma", "SEN {Time 1} {Type RangeImager} {Name S} {Resolution 0.5} {FOV 1} {Range 1.5,2,.25,}", true);
    row("two resolutions are another shape", "SEN {Type RangeImager} {Name k} {Resolution 4,2} {FOV 1,2} {Range 1,2}",
        false);
    row("no range yet", "SEN {Time 1} {Type RangeImager} {Name k} {Resolution 4,2} {FOV 1,2} {Frames 0}", false);
    row("a single ray", "SEN {Time 41.6} {Type Range} {Name ray} {Range 4.2119}", false);
}

void tst_Reader::readsScannersByShape() {
    QFETCH(QByteArray, line);
    QFETCH(bool, is_scan);
    if (!is_scan) {
        QVERIFY(!std::holds_alternative<RangeScan>(read(line.toStdString()).message));
        return;
    }
    auto scan = cleanly<RangeScan>(line.toStdString());
    QVERIFY(line.contains("{Type " + QByteArray::fromStdString(scan.type) + "}"));
    scan.type = "RangeScanner";
    QVERIFY(scan == (RangeScan{Seconds(1), "S", 0.5, 1.0, {1.5, 2.0, 0.25}}));
    QCOMPARE(scan.beamAngle_rad(0), -0.5); // the first beam looks right
}

void tst_Reader::readsPosesIntoOurFrame() {
    const auto truth = cleanly<GroundTruthReading>(
        "SEN {Time 395.3833} {Type GroundTruth} {Name GT} {Location 4.50,1.90,-1.85} {Orientation 0.00,0.25,6.00}");
    QCOMPARE(truth.time.value().count(), 395.3833);
    QCOMPARE(truth.name, std::string("GT"));
    QVERIFY(near(truth.base_in_map, {4.5, -1.9, 1.85}, {0.0, -0.25, 2 * pi - 6.0}));

    const auto ins = cleanly<InsReading>("SEN {Type INS} {Name INS} {Location 1,2,3} {Orientation 0.1,0,0}");
    QVERIFY(!ins.time);
    QVERIFY(near(ins.base_in_map, {1, -2, -3}, {0.1, 0, 0}));

    const auto odometry = cleanly<OdometryReading>("SEN {Type Odometry} {Name O} {Pose  0.5,0.25,-8.6119}");
    QVERIFY(near(odometry.base_in_start.value(), {0.5, -0.25, 0}, {0, 0, 8.6119 - 2 * pi}));
}

void tst_Reader::anEmptyHeadIsNoNews_data() {
    QTest::addColumn<QByteArray>("type");
    for (const char* type : {"Sonar", "RangeScanner", "INS", "GroundTruth", "Odometry", "Encoder", "Camera"})
        QTest::newRow(type) << QByteArray(type);
}

void tst_Reader::anEmptyHeadIsNoNews() {
    QFETCH(QByteArray, type);
    const auto head = cleanly<GenericMessage>("SEN {Time 48.0983} {Type " + type.toStdString() + "} ");
    QCOMPARE(head.type, type.toStdString());
}

void tst_Reader::whatItsTableCannotTakeIsKeptWhole_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("segments");
    QTest::newRow("a sonar of another kind") << QByteArray("SEN {Time 1} {Type Sonar} {Name F1} {Echo 0.3}") << 4;
    QTest::newRow("an encoder of another kind") << QByteArray("SEN {Type Encoder} {Name W1} {Angle 0.3}") << 3;
    QTest::newRow("an odometry of another kind") << QByteArray("SEN {Type Odometry} {Name O} {Way 12}") << 3;
}

void tst_Reader::whatItsTableCannotTakeIsKeptWhole() {
    QFETCH(QByteArray, line);
    QFETCH(int, segments);
    QCOMPARE(static_cast<int>(cleanly<GenericMessage>(line.toStdString()).segments.size()), segments);
}

void tst_Reader::keepsWhatNoFieldOfTheStateHolds() {
    const auto state = cleanly<RobotState>("STA {Type Submarine} {Time 1} {Battery 5} {Mode Dive} {FLFlipper 0.5} "
                                           "{Drift 1,2,3} {CountPer1sec 10} {Battery 6} {Odd nan} {Lone}");
    QVERIFY(state.others == (std::vector<KeyValue>{{"Type", "Submarine"},
                                                   {"Mode", "Dive"},
                                                   {"Drift", "1,2,3"},
                                                   {"CountPer1sec", "10"},
                                                   {"Battery", "6"},
                                                   {"Odd", "nan"},
                                                   {"Lone", ""}}));
    QCOMPARE(state.battery_left->count(), 5.0);
    QVERIFY(state.joints == (std::vector<JointAngle>{{"FLFlipper", 0.5}}));
}

void tst_Reader::readsEncodersGroupedAndSingle() {
    QVERIFY(cleanly<EncoderReadings>("SEN {Type Encoder} {Name L Tick -30} {Name R Tick 18}") ==
            (EncoderReadings{std::nullopt, {{"L", -30}, {"R", 18}}}));
    QVERIFY(cleanly<EncoderReadings>("SEN {Time 3} {Type Encoder} {Name W1} {Tick 7}") ==
            (EncoderReadings{Seconds(3), {{"W1", 7}}}));
}

void tst_Reader::readsGeometryOfRobots() {
    const auto ground =
        cleanly<GeometryInfo>("GEO  {Name P3AT} {Type GroundVehicle} {Dimensions 0.5,0.4,0.3} {COG "
                              "0.1,0.2,0.3} {WheelRadius 0.13} {WheelSeparation 0.47} {WheelBase 0.28}");
    QCOMPARE(ground.robot_class, std::string("P3AT"));
    QVERIFY(ground.items.empty());
    QVERIFY(ground.dimensions_m.value() == Vec3(0.5, 0.4, 0.3));
    QVERIFY(ground.center_of_gravity_m.value() == Vec3(0.1, -0.2, -0.3));
    QCOMPARE(ground.wheel_base_m.value(), 0.28);

    const auto aerial = cleanly<GeometryInfo>("GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}");
    QVERIFY(!aerial.wheel_radius_m && !aerial.center_of_gravity_m);
    QCOMPARE(cleanly<GeometryInfo>("GEO {Name AirRobot}").robot_class, std::string("AirRobot"));

    const auto nothing = cleanly<GeometryInfo>("GEO {Type Laser} {Name NoSuch}");
    QVERIFY(nothing == GeometryInfo{.type = "Laser"});
}

void tst_Reader::readsGeometryOfItemsGroupedSingleAndLinked_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* line, const char* expected) {
        QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
    };
    row("grouped",
        "GEO {Type Sonar} {Name F1 Location 1,0,0 Orientation 0,0,0 Mount HARD} {Name F2 Location 2,0,0 "
        "Orientation 0,0,0 Mount Arm_Link2}",
        "F1@HARD:1 F2@Arm_Link2:2 ");
    row("grouped without mount", "GEO {Type Gripper} {Name G Location 3,0,0 Orientation 0,0,0}", "G@:3 ");
    row("single",
        "GEO {Type RangeScanner} {Name A} {Location 1,0,0} {Orientation -0.00,-0.00,-0.00} {Mount P3AT} "
        "{Name B} {Location 2,0,0} {Orientation 0,0,0}{Mount P3AT}",
        "A@P3AT:1 B@P3AT:2 ");
    row("on a link", "GEO {Type Gripper} {Name G} {Location 1,0,0} {Orientation 0,0,0}{Mount Arm}{MountLink 6}",
        "G@Arm_Link6:1 ");
    row("a mission package",
        "GEO {Type MisPkg} {Name Cam} {Link 1} {ParentLink -1} {Location 1,0,0} {Orientation "
        "0,0,0} {Link 2} {ParentLink 1} {Location 2,0,0} {Orientation 0,0,0}",
        "Cam_Link1@HARD:1 Cam_Link2@Cam_Link1:2 ");
    row("an actuator with a base",
        "GEO {Type Actuator} {Name Arm} {Location 1,0,0} {Orientation 0,0,0}{Mount P3AT} "
        "{Link 1} {Parent 0} {Location 2,0,0} {Orientation 0,0,0}{Tip 9,9,9}",
        "Arm@P3AT:1 Arm_Link1@Arm:2 ");
}

void tst_Reader::readsGeometryOfItemsGroupedSingleAndLinked() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    QByteArray seen;
    for (const MountedItem& item : cleanly<GeometryInfo>(line.toStdString()).items)
        seen += QByteArray::fromStdString(item.name + "@" + item.mount) + ":" +
                QByteArray::number(item.item_in_mount.position_m.x()) + " ";
    QCOMPARE(seen, expected);
}

void tst_Reader::readsConfigurationsInTheirOrder() {
    const auto robot =
        cleanly<ConfigurationInfo>("CONF {Name P3AT} {Type GroundVehicle} {SteeringType SkidSteered} {Mass 11.9}");
    QCOMPARE(robot.type, std::string("GroundVehicle"));
    QVERIFY(robot.items == (std::vector<ConfiguredItem>{
                               {"P3AT", {{"SteeringType", "SkidSteered", std::nullopt}, {"Mass", "11.9", 11.9}}}}));
    QCOMPARE(robot.items[0].number("mass").value(), 11.9);
    QVERIFY(!robot.items[0].number("SteeringType"));
    QVERIFY(!robot.items[0].number("absent"));

    const auto cameras = cleanly<ConfigurationInfo>("CONF {Type Camera} {Name A}{Fov 1}{Fov 2} {Name B}{Fov 3}");
    QCOMPARE(cameras.items.size(), std::size_t(2));
    QCOMPARE(cameras.items[0].settings.size(), std::size_t(2));
    QCOMPARE(cameras.items[0].number("Fov").value(), 1.0);
    QVERIFY(cleanly<ConfigurationInfo>("CONF {Type Laser}").items.empty());
}

void tst_Reader::readsResponsesOfAnyCase_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<bool>("ok");
    QTest::newRow("ok") << QByteArray("RES {Time 1} {Type INS} {Name INS} {Status OK}") << QByteArray("INS") << true;
    QTest::newRow("failed") << QByteArray("RES {Type INS} {Name INS} {Status Failed}") << QByteArray("INS") << false;
    QTest::newRow("lower case") << QByteArray("RES {Type RFID} {Name R} {status ok} {ID 3}") << QByteArray("R") << true;
    QTest::newRow("one of two cameras failed")
        << QByteArray("RES {Type Camera} {Name A} {FOV 1} {Status OK} {Name B} {Status Failed}") << QByteArray("A")
        << false;
}

void tst_Reader::readsResponsesOfAnyCase() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, name);
    QFETCH(bool, ok);
    const auto response = cleanly<Response>(line.toStdString());
    QCOMPARE(QByteArray::fromStdString(response.name), name);
    QCOMPARE(response.ok, ok);
}

void tst_Reader::notANumberAmongRangesIsNanAndAWarning_data() {
    QTest::addColumn<QByteArray>("spelling");
    for (const char* spelling : {"nan", "NaN", "inf", "-inf", "-1.#IND", "1.#QNAN", "1.#INF", "abc", "", "1e999"})
        QTest::newRow(*spelling ? spelling : "nothing") << QByteArray(spelling);
}

void tst_Reader::notANumberAmongRangesIsNanAndAWarning() {
    QFETCH(QByteArray, spelling);
    const std::string bad = spelling.toStdString();
    const InfoLine scan_line =
        read("SEN {Type RangeScanner} {Name S} {Resolution 1} {FOV 2} {Range 1.5," + bad + ",3}");
    const RangeScan* const scan = std::get_if<RangeScan>(&scan_line.message);
    QVERIFY(scan);
    QCOMPARE(scan->ranges_m.size(), std::size_t(3));
    QVERIFY(std::isnan(scan->ranges_m[1]));
    QCOMPARE(scan->ranges_m[2], 3.0);
    QCOMPARE(countOf(scan_line.diagnostics, Severity::Warning), 1);

    const InfoLine sonar_line = read("SEN {Type Sonar} {Name F1} {Range " + bad + "} {Name F2} {Range 2}");
    const SonarReadings* const sonars = std::get_if<SonarReadings>(&sonar_line.message);
    QVERIFY(sonars);
    QCOMPARE(sonars->ranges.size(), std::size_t(2));
    QVERIFY(std::isnan(sonars->ranges[0].range_m));
    QCOMPARE(countOf(sonar_line.diagnostics, Severity::Warning), 1);
}

void tst_Reader::warnsOfDamageAndKeepsTheRest_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("offset");
    QTest::newRow("time") << QByteArray("STA {Time soon} {Battery 5}") << 10;
    QTest::newRow("a time with junk") << QByteArray("STA {Time 1.5s} {Battery 5}") << 10;
    QTest::newRow("boolean") << QByteArray("STA {Time 1} {LightToggle maybe} {Battery 5}") << 14;
    QTest::newRow("huge view") << QByteArray("STA {Time 1} {View 1e30} {Battery 5}") << 19;
    QTest::newRow("lost brace") << QByteArray("STA {Time 1} {Battery 5") << 13;
}

void tst_Reader::warnsOfDamageAndKeepsTheRest() {
    QFETCH(QByteArray, line);
    QFETCH(int, offset);
    const InfoLine result = read(line.toStdString());
    const RobotState* const state = std::get_if<RobotState>(&result.message);
    QVERIFY(state);
    QCOMPARE(state->battery_left.value().count(), 5.0);
    QCOMPARE(result.diagnostics.size(), std::size_t(1));
    QVERIFY(result.diagnostics[0].severity == Severity::Warning);
    QCOMPARE(static_cast<int>(result.diagnostics[0].offset), offset);
}

void tst_Reader::keepsUnknownLinesWhole() {
    const auto message = cleanly<GenericMessage>("WHO {Time 4} {Type Gripper} {Name G1} {On}");
    QVERIFY(message ==
            (GenericMessage{"WHO", "Gripper", "G1", {{"Time", "4"}, {"Type", "Gripper"}, {"Name", "G1"}, {"On", ""}}}));
    const auto grouped = cleanly<GenericMessage>("SEN {Type Feeler} {Name IR1 Range 0.5} {Name IR2 Range 0.8}");
    QCOMPARE(grouped.name, std::string("IR1"));
    QCOMPARE(grouped.segments[1].value, std::string("IR1 Range 0.5"));
    QCOMPARE(cleanly<GenericMessage>("HTTP/1.1 400 Bad Request").type_word, std::string("HTTP/1.1 400 Bad Request"));
}

USAR_TEST(tst_Reader)

} // namespace tst_reader

#include "tst_reader.moc"
