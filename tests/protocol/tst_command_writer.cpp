#include <QTest>

#include "any_command.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "tests/suite/suite.h"

namespace tst_command_writer {

using namespace usar;
using namespace usar::protocol;

namespace {

void row(const char* name, const Command& command, const char* line) {
    QCOMPARE(QByteArray::fromStdString(write(command)), QByteArray(line));
    QTest::newRow(name) << QByteArray(line);
}

void spawnsAndDrives() {
    row("spawn at a pose", Init{"USARBot.AirRobot", "R1", Pose{{4.5, -1.9, 1.8}, 0.5, 0.25, -1.5}, {}},
        "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 4.5,1.9,-1.8} {Rotation 0.5,-0.25,1.5}");
    row("spawn at a name", Init{"USARBot.P3AT", {}, "PlayerStart", {}},
        "INIT {ClassName USARBot.P3AT} {Start PlayerStart}");
    row("spawn with a battery", Init{"P3AT", "A", Pose{}, {}, Seconds(3600)},
        "INIT {ClassName P3AT} {Name A} {Location 0,0,0} {Rotation 0,0,0} {Battery 3600}");
    row("start poses", GetStartPoses{}, "GETSTARTPOSES");
    row("fly", AerialDrive{0.5, 1.0, 0.25, -0.125, false},
        "DRIVE {AltitudeVelocity 0.5} {LinearVelocity 1} {LateralVelocity -0.25} {RotationalVelocity 0.125} "
        "{Normalized false}");
    row("only what is said", AerialDrive{.forward_m_s = 100.0, .normalized = true},
        "DRIVE {LinearVelocity 100} {Normalized true}");
    row("roll", SkidDrive{1.0, -1.0, false}, "DRIVE {Left 1} {Right -1} {Normalized false}");
    row("roll with lights", SkidDrive{1.0, 1.0, true, {true, false}},
        "DRIVE {Left 1} {Right 1} {Normalized true} {Light true} {Flip false}");
    row("lights alone", DriveSwitches{.light_on = true}, "DRIVE {Light true}");
    row("steer left", AckermannDrive{3.0, 0.5}, "DRIVE {Speed 3} {FrontSteer -0.5} {Normalized false}");
    row("many wheels", OmniDrive{{{0, 3.0, 0.5}, {1, 3.0, {}}}},
        "DRIVE {WheelNumber 0} {WheelSpeed 3} {WheelSteer -0.5} {WheelNumber 1} {WheelSpeed 3} {Normalized false}");
    row("dive", NauticDrive{20.0, 0.25, -0.125},
        "DRIVE {Propeller 20} {Rudder 0.25} {SternPlane -0.125} {Normalized false}");
    row("a joint's speed", JointDrive{"FLFlipper", JointOrder::Speed, 0.25},
        "DRIVE {Name FLFlipper} {Order 1} {Value 0.25} {Normalized false}");
    row("a wheel by name", JointDrive{"FrontLeft", JointOrder::Speed, 2.0, -0.5},
        "DRIVE {Name FrontLeft} {Order 1} {Value 2} {Steer 0.5} {Normalized false}");
    row("flippers", MultiDrive{{{"FRFlipper", 0.5}, {"FLFlipper", -0.5}}},
        "MULTIDRIVE {FRFlipper 0.5} {FLFlipper -0.5}");
}

void questionsAndSettings() {
    row("geometry", GetGeometry{"Sonar"}, "GETGEO {Type Sonar}");
    row("geometry of the robot", GetGeometry{"Robot", "P3AT"}, "GETGEO {Type Robot} {Name P3AT}");
    row("packages", GetConfiguration{"MisPkg"}, "GETCONF {Type MisPkg}");
    row("configuration", GetConfiguration{"Camera", "Cam"}, "GETCONF {Type Camera} {Name Cam}");
    row("INS", SetInsPose{"INS", {{1, -2, 3}, 0.5, 0.25, -1}},
        "SET {Type INS} {Name INS} {Opcode POSE} {Params 1,2,-3,0.5,-0.25,1}");
    row("odometry", ResetSensor{"Odometry", "Odometry"}, "SET {Type Odometry} {Name Odometry} {Opcode RESET}");
    row("one scan", ScanNow{"RangeImager", "kinect"}, "SET {Type RangeImager} {Name kinect} {Opcode SCAN}");
    row("read a tag", ReadTag{"118", "RFID"}, "SET {Type RFID} {Name RFID} {Opcode Read} {Params 118}");
    row("write a tag", WriteTag{"118", "visited by robot 2", "RFID"},
        "SET {Type RFID} {Name RFID} {Opcode Write} {Params 118 visited by robot 2}");
    row("drop a tag", ReleaseTag{"Gun"}, "SET {Type RFIDReleaser} {Name Gun} {Opcode Release}");
    row("count tags", CountTags{"Gun"}, "SET {Type RFIDReleaser} {Name Gun} {Opcode TagsRemaining}");
    row("grip", UseGripper{GripperAction::Grip, "G1"}, "SET {Type Gripper} {Name G1} {Opcode GRIP} {Params 1}");
    row("close", UseGripper{GripperAction::Close, "G1"}, "SET {Type Gripper} {Name G1} {Opcode CLOSE}");
    row("change tools", UseToolChanger{true, "TC1"}, "SET {Type ToolChanger} {Name TC1} {Opcode OPEN}");
    row("anything", SetItem{"Siren", "LOUD", "S", "at 3 o'clock"},
        "SET {Type Siren} {Name S} {Opcode LOUD} {Params at 3 o'clock}");
    row("set a joint", SetJoint{"HeadPitch", JointOpcode::Angle, 0.5},
        "SET {Type Joint} {Name HeadPitch} {Opcode Angle} {Params 0.5}");
    row("set and steer a wheel", SetJoint{"LeftWheel", JointOpcode::Torque, 5.0, -0.25},
        "SET {Type Joint} {Name LeftWheel} {Opcode Torque} {Params 5,0.25}");
    row("zoom", ZoomCamera{0.5, "Camera"}, "SET {Type Camera} {Name Camera} {Opcode Zoom} {Params 0.5}");
    row("attach", AttachCamera{"R1", "10.0.0.2", "GCam"}, "SET {Type Camera} {Robot R1} {Name GCam} {Client 10.0.0.2}");
    row("detach", DetachCamera{"10.0.0.2"}, "SET {Type Camera} {Client 10.0.0.2}");
    row("four views", SetViewports{ViewLayout::Quad, {"Cam1", "Cam2", "Disabled", "None"}},
        "SET {Type Viewports} {Config QuadView} {Viewport1 Cam1} {Viewport2 Cam2} {Viewport3 Disabled} {Viewport4 "
        "None}");
}

void packagesAndMarks() {
    row("pan and tilt", PackageDrive{"Arm", {{1, 0.5}, {2, 0.25, LinkOrder::Speed}}},
        "MISPKG {Name Arm} {Link 1} {Value 0.5} {Order 0} {Link 2} {Value 0.25} {Order 1}");
    row("the old way to turn", PackageRotation{"Cam1", 0.25, 0.5},
        "MISPKG {Name Cam1} {Rotation 0,0.25,0.5} {Order 0}");
    row("the tip of an arm", PackagePose{"Arm", {0.75, 0.25, 0.5}, Vec3(0.0, 0.5, 0.0)},
        "MISPKG {Name Arm} {Location 0.75,-0.25,-0.5} {Rotation 0,-0.5,0}");
    row("an arm's sequence", PackageDrive{"Arm", {}, 1, true}, "MISPKG {Name Arm} {Seq 1} {Gripper 1}");
    row("an actuator", ActuatorDrive{"Arm", {{1, 0.5}, {3, 0.0}}},
        "ACT {Name Arm} {Link 1} {Value 0.5} {Link 3} {Value 0}");
    row("an actuator's hand", ActuatorDrive{"Arm", {}, false, 2}, "ACT {Name Arm} {Gripper 0} {Sequence 2}");
    row("marks", Trace{true, Seconds(0.5), TraceColor::Red}, "TRACE {On true} {Interval 0.5} {Color Red}");
}

void objects() {
    row("an object",
        CreateObject{"Box", "B1", Pose{{1, -2, -1.5}, 0, 0, -0.5}, Vec3(1, 1, 2), ObjectPhysics::RigidBody, false,
                     "hello there", "M_Wood"},
        "CONTROL {Type Create} {ClassName Box} {Name B1} {Location 1,2,1.5} {Rotation 0,0,0.5} {Scale 1,1,2} {Physics "
        "RigidBody} {Permanent false} {Memory hello there} {Material M_Wood}");
    row("an object at a start", CreateObject{"Box", "B2", "PlayerStart"},
        "CONTROL {Type Create} {ClassName Box} {Name B2} {Start PlayerStart}");
    row("kill", KillObject{"B1"}, "CONTROL {Type Kill} {Name B1}");
    row("kill all", KillAllObjects{}, "CONTROL {Type KillAll}");
    row("kill all in a box", KillAllObjects{Box{{0, -5, -4}, {5, 1, 0}}},
        "CONTROL {Type KillAll} {MinPos 0,-1,0} {MaxPos 5,5,4}");
    row("place", PlaceObject{"B1", {{3, -2, 1}, 0, 0, -1.5}},
        "CONTROL {Type AbsMove} {Name B1} {Location 3,2,-1} {Rotation 0,0,1.5}");
    row("shift", ShiftObject{"B1", {{0.5, 0, 0}, 0, 0, 0}},
        "CONTROL {Type RelMove} {Name B1} {Location 0.5,0,0} {Rotation 0,0,0}");
    row("spin", SpinObject{"B1", {0.25, 0.5, -1}}, "CONTROL {Type Rotate} {Name B1} {Speed 0.25,-0.5,1}");
    row("conveyor", RunConveyor{"Belt1", 0.5}, "CONTROL {Type Conveyor} {Name Belt1} {Speed 0.5}");
    row("way points", AddWaypoints{"B1", {{1, -2, -1.5}, {3, -2, 0}}},
        "CONTROL {Type AddWP} {Name B1} {WP 1,2,1.5;3,2,0}");
    row("no way points", ClearWaypoints{"B1"}, "CONTROL {Type ClearWP} {Name B1}");
    row("follow in a time", FollowWaypoints{"B1", Seconds(10), false, true, true},
        "CONTROL {Type SetWP} {Name B1} {Time 10} {Loop false} {ResetOnClear true} {Moving true}");
    row("objects' states", GetObjectStates{"B1", "Box"}, "CONTROL {Type GetSTA} {Name B1} {ClassName Box}");
}

void avatarsAndSimulation() {
    row("path nodes", GetPathNodes{}, "GETPATHNODES");
    row("the next path node", GetClosestPathNode{{3, -4, 0}}, "GETCLOSESTPATHNODE {Location 3,4,0}");
    row("go", GoToNode{"PathNode_3"}, "GOTO {Name PathNode_3}");
    row("walk", WalkTo{Vec2(3.5, 2)}, "MOVE {Action New} {Type Walk_Forward} {Location 3.5,-2}");
    row("run on", WalkTo{"PathNode_3", Gait::Run, true}, "MOVE {Action Append} {Type Run} {Pathnode PathNode_3}");
    row("stand", PauseWalk{}, "MOVE {Action Pause}");
    row("walk on", ResumeWalk{}, "MOVE {Action Resume}");
    row("lockstep", Lockstep{true}, "LOCKSTEP {On true}");
    row("step", Step{}, "STEP");
    row("test", Test{}, "TEST");
    row("pause", Pause{Seconds(10)}, "PAUSE {Time 10}");
    row("raw", RawCommand{"DIE {Killer x}"}, "DIE {Killer x}");
}

} // namespace

class tst_CommandWriter : public QObject {
    Q_OBJECT
private slots:
    void writingThenReadingIsTheIdentity_data();
    void writingThenReadingIsTheIdentity();
    void spellsLinesAsStrictServersWantThem_data();
    void spellsLinesAsStrictServersWantThem();
    void udkHasItsOwnSpelling_data();
    void udkHasItsOwnSpelling();
    void degreesKeepEveryBitOfTheRadians();
    void appendsToWhatIsThere();
    void whatIsNoNumberIsZero();
    void percentEndAtAHundred();
    void noTextCanBreakTheLine_data();
    void noTextCanBreakTheLine();
    void aWorldControllersClassIsTheDialects();
};

void tst_CommandWriter::writingThenReadingIsTheIdentity_data() {
    QTest::addColumn<Dialect>("dialect");
    QTest::newRow("UT2004") << Dialect::Ut2004;
    QTest::newRow("UDK") << Dialect::Udk;
}

void tst_CommandWriter::writingThenReadingIsTheIdentity() {
    QFETCH(Dialect, dialect);
    Random random = seeded(42, 1);
    std::string line;
    for (std::size_t i = 0; i < 1000 * any::kinds; ++i) {
        const Command command = any::command(i % any::kinds, dialect, random);
        line.clear();
        write(command, dialect, line);
        Diagnostics diagnostics;
        const Command again = readCommand(line, diagnostics, dialect);
        QVERIFY2(again == command, line.c_str());
        QVERIFY2(diagnostics.empty(), (line + "  " + (diagnostics.empty() ? "" : diagnostics[0].message)).c_str());
    }
}

void tst_CommandWriter::spellsLinesAsStrictServersWantThem_data() {
    QTest::addColumn<QByteArray>("line");
    spawnsAndDrives();
    questionsAndSettings();
    packagesAndMarks();
    objects();
    avatarsAndSimulation();
}

void tst_CommandWriter::spellsLinesAsStrictServersWantThem() {
    QFETCH(QByteArray, line);
    // row() has compared the text, because a command is no meta type. Here our reader takes what our writer sends.
    Diagnostics diagnostics;
    QCOMPARE(QByteArray::fromStdString(write(readCommand(line.toStdString(), diagnostics))), line);
}

void tst_CommandWriter::udkHasItsOwnSpelling_data() {
    QTest::addColumn<QByteArray>("written");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const Command& command, const char* expected) {
        QTest::newRow(name) << QByteArray::fromStdString(write(command, Dialect::Udk)) << QByteArray(expected);
    };
    row("degrees per second", AerialDrive{.yaw_rate_rad_s = -pi / 2},
        "DRIVE {RotationalVelocity 90} {Normalized false}");
    row("percent stay percent", AerialDrive{.yaw_rate_rad_s = -50.0, .normalized = true},
        "DRIVE {RotationalVelocity 50} {Normalized true}");
    row("attitude in degrees", AerialDrive{.pitch_rad = -pi / 9, .roll_rad = -pi / 9},
        "DRIVE {Normalized false} {PitchAngle 20} {RollAngle -20}");
    row("all of an Ackermann DRIVE", AckermannDrive{.speed_rad_s = 2.0},
        "DRIVE {Speed 2} {FrontSteer 0} {RearSteer 0} {Normalized false}");
    row("the robot in any case", GetGeometry{"robot"}, "GETGEO {Type Robot}");
    row("packages in any case", GetConfiguration{"mispkg"}, "GETCONF {Type MisPkg}");
    row("packages by their newer word", GetConfiguration{"Actuator"}, "GETCONF {Type Actuator}");
    row("a joint", SetJoint{"AllJoints", JointOpcode::Stiffness, 0.5},
        "SET {Type Joint} {Name AllJoints} {Opcode Stiffness} {Params 0.5}");
    row("whole triples", PackageDrive{"Arm", {{2, 0.5}}}, "MISPKG {Name Arm} {Link 2} {Value 0.5} {Order 0}");
    row("its world controller", Init::worldController("WC", Dialect::Udk),
        "INIT {ClassName USARBotAPI.WorldController} {Name WC} {Location 0,0,0} {Rotation 0,0,0}");
}

void tst_CommandWriter::udkHasItsOwnSpelling() {
    QFETCH(QByteArray, written);
    QFETCH(QByteArray, expected);
    QCOMPARE(written, expected);
}

void tst_CommandWriter::degreesKeepEveryBitOfTheRadians() {
    Random random = seeded(43, 1);
    for (int i = 0; i < 100000; ++i) {
        const AerialDrive drive{.yaw_rate_rad_s = uniform(random, -5, 5) * std::pow(10.0, i % 12 - 6)};
        Diagnostics diagnostics;
        QVERIFY(readCommand(write(drive, Dialect::Udk), diagnostics, Dialect::Udk) == Command(drive));
    }
}

void tst_CommandWriter::appendsToWhatIsThere() {
    std::string out = "STEP\r\n";
    write(GetStartPoses{}, Dialect::Ut2004, out);
    QCOMPARE(out, std::string("STEP\r\nGETSTARTPOSES"));
}

/// A server would read it so. No zero has a sign.
void tst_CommandWriter::whatIsNoNumberIsZero() {
    constexpr double endless = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(write(SkidDrive{nan, endless}), std::string("DRIVE {Left 0} {Right 0} {Normalized false}"));
    QCOMPARE(write(SkidDrive{nan, -endless, true}), std::string("DRIVE {Left 0} {Right 0} {Normalized true}"));
    QCOMPARE(write(AerialDrive{-0.0, 0.0, 0.0, nan}, Dialect::Udk),
             std::string("DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0} "
                         "{Normalized false}"));
    QCOMPARE(write(Pause{Seconds(endless)}), std::string("PAUSE {Time 0}"));
}

void tst_CommandWriter::percentEndAtAHundred() {
    QCOMPARE(write(SkidDrive{250.0, -250.0, true}), std::string("DRIVE {Left 100} {Right -100} {Normalized true}"));
    QCOMPARE(write(SkidDrive{250.0, -250.0, false}), std::string("DRIVE {Left 250} {Right -250} {Normalized false}"));
    Diagnostics diagnostics;
    QVERIFY(readCommand("DRIVE {Left 250} {Normalized true}", diagnostics) ==
            Command(SkidDrive{.left_rad_s = 100.0, .normalized = true}));
    QCOMPARE(diagnostics.size(), std::size_t{1});
}

void tst_CommandWriter::noTextCanBreakTheLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<bool>("is_token");
    QTest::addColumn<bool>("is_name");
    QTest::addColumn<bool>("is_text");
    QTest::newRow("a word") << QByteArray("R1") << true << true << true;
    QTest::newRow("a byte above 127") << QByteArray("Ren\xe9") << true << true << true;
    QTest::newRow("nothing") << QByteArray() << false << true << true;
    QTest::newRow("two words") << QByteArray("my robot") << false << false << true;
    QTest::newRow("a space before") << QByteArray(" R1") << false << false << false;
    QTest::newRow("a space after it") << QByteArray("R1 ") << false << false << false;
    QTest::newRow("an opening brace") << QByteArray("R{1") << false << false << false;
    QTest::newRow("a closing brace") << QByteArray("R}1") << false << false << false;
    QTest::newRow("a line end") << QByteArray("R1}\r\nDRIVE {Left 9") << false << false << false;
    QTest::newRow("a tab") << QByteArray("R\t1") << false << false << false;
    QTest::newRow("a zero byte") << QByteArray("R\0001", 3) << false << false << false;
}

void tst_CommandWriter::noTextCanBreakTheLine() {
    QFETCH(QByteArray, text);
    QFETCH(bool, is_token);
    QFETCH(bool, is_name);
    QFETCH(bool, is_text);
    const std::string given = text.toStdString();
    QCOMPARE(Token::make(given).has_value(), is_token);
    QCOMPARE(Name::make(given).has_value(), is_name);
    QCOMPARE(Text::make(given).has_value(), is_text);
    QVERIFY(is_text || !Text::make(given).error().mend.empty());
    const Text mended = Text::mended(given);
    QVERIFY(Text::make(mended.text()).has_value());
    QCOMPARE(mended.text() == given, is_text);
    QVERIFY(Name::make(Name::mended(given).text()).has_value());
}

void tst_CommandWriter::aWorldControllersClassIsTheDialects() {
    QCOMPARE(Init::worldController("WC", Dialect::Ut2004).class_name.text(), std::string("USARBot.WorldController"));
    QCOMPARE(Init::worldController("WC", Dialect::Udk).class_name.text(), std::string("USARBotAPI.WorldController"));
}

USAR_TEST(tst_CommandWriter)

} // namespace tst_command_writer

#include "tst_command_writer.moc"
