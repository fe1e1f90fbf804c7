#include <QTest>

#include "core/base/random.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_command_reader {

using namespace usar;
using namespace std::string_literals;
using namespace usar::protocol;

namespace {

struct Taken {
    Command command;
    Diagnostics diagnostics;
};

Taken take(const std::string& line, Dialect dialect = Dialect::Ut2004) {
    Taken taken;
    taken.command = readCommand(line, taken.diagnostics, dialect);
    return taken;
}

template <class T>
T taken(const std::string& line, std::size_t diagnostics = 0) {
    const Taken result = take(line);
    if (!std::holds_alternative<T>(result.command) || result.diagnostics.size() != diagnostics)
        qFatal("not taken as expected: %s", line.c_str());
    return std::get<T>(result.command);
}

} // namespace

class tst_CommandReader : public QObject {
    Q_OBJECT
private slots:
    void takesVectorsInEverySpelling_data();
    void takesVectorsInEverySpelling();
    void readsInit();
    void aNamedStartKeepsItsFallback();
    void readsAerialDrives();
    void readsSkidDrives();
    void yawRateFollowsTheDialect();
    void readsQuestions_data();
    void readsQuestions();
    void insTakesExactlySixNumbers_data();
    void insTakesExactlySixNumbers();
    void readsOurOwnWords();
    void readsEveryKind_data();
    void readsEveryKind();
    void readsWhatClientsSend();
    void repairsWhatServersTolerate_data();
    void repairsWhatServersTolerate();
    void takesNumbersAsServersDo_data();
    void takesNumbersAsServersDo();
    void keepsTheRestRaw_data();
    void keepsTheRestRaw();
    void everyPrefixOfEveryLineIsTaken();
    void randomBytesAreTaken();
    void whatIsTakenFromAnOddLineIsWrittenSo();
};

void tst_CommandReader::takesVectorsInEverySpelling_data() {
    QTest::addColumn<QByteArray>("location");
    for (const char* location : {"1,-2,0.5", "1, -2, 0.5", "1 -2 0.5", "1,-2 ,0.5", " 1.000000  -2.000000 .5 ",
                                 "+1,-2,0.50", "01,-02,00.5", "1e0,-2E0,5e-1"})
        QTest::newRow(location) << QByteArray(location);
}

void tst_CommandReader::takesVectorsInEverySpelling() {
    QFETCH(QByteArray, location);
    const auto init = taken<Init>("INIT {ClassName X} {Location " + location.toStdString() + "} {Rotation 0,0,0}");
    QVERIFY(std::get<Pose>(init.start).position_m == Vec3(1, 2, -0.5));
}

void tst_CommandReader::readsInit() {
    const auto init =
        taken<Init>("init{classname USARBot.AirRobot}{name R1}{location 4.5,1.9,-1.8}{rotation 0.1,0.2,0.3}");
    QCOMPARE(init.class_name.text(), std::string("USARBot.AirRobot"));
    QCOMPARE(init.robot_name.text(), std::string("R1"));
    QVERIFY(std::get<Pose>(init.start) == (Pose{{4.5, -1.9, 1.8}, 0.1, -0.2, -0.3}));
    QVERIFY(std::get<Pose>(taken<Init>("INIT {ClassName X}").start) == Pose{});
    // One brace missing, as the pyro driver sends it.
    const auto pyro = taken<Init>("INIT {ClassName X} {Name r} {Location 4.5,1.9,1.8} {Rotation 0,0,1", 1);
    QCOMPARE(std::get<Pose>(pyro.start).yaw_rad, -1.0);
    QVERIFY(std::get<Pose>(taken<Init>("INIT {ClassName X} {Location 1,2}", 1).start).position_m == Vec3(1, -2, 0));
}

void tst_CommandReader::aNamedStartKeepsItsFallback() {
    const auto named = taken<Init>("INIT {ClassName X} {Start playerstart}");
    QCOMPARE(std::get<Token>(named.start).text(), std::string("playerstart"));
    QVERIFY(!named.fallback_in_map);
    const auto both = taken<Init>("INIT {ClassName X}{Location 1,-2,0}{Rotation 0,0,0}{Start Point1}");
    QCOMPARE(std::get<Token>(both.start).text(), std::string("Point1"));
    QVERIFY(both.fallback_in_map.value().position_m == Vec3(1, 2, 0));
}

void tst_CommandReader::readsAerialDrives() {
    QVERIFY(taken<AerialDrive>("DRIVE {AltitudeVelocity 1} {LinearVelocity 2} {LateralVelocity 3} {RotationalVelocity "
                               "0.5} {Normalized false}") == (AerialDrive{1.0, 2.0, -3.0, -0.5, false}));
    const auto partial = taken<AerialDrive>("DRIVE {LINEARVELOCITY 50} {Normalized True}");
    QVERIFY(partial == (AerialDrive{.forward_m_s = 50.0, .normalized = true}));
    const auto stop = taken<AerialDrive>("DRIVE {Left 0} {Right 0} {Speed 0} {AltitudeVelocity 0} {LinearVelocity 0} "
                                         "{LateralVelocity 0} {RotationalVelocity 0}");
    QVERIFY(stop == (AerialDrive{0.0, 0.0, 0.0, 0.0, false}));
}

void tst_CommandReader::readsSkidDrives() {
    QVERIFY(taken<SkidDrive>("DRIVE {RIGHT 1.0} {LEFT -1.0}") == (SkidDrive{-1.0, 1.0, false}));
    QVERIFY(taken<SkidDrive>("DRIVE {Left 1.0}") == (SkidDrive{1.0, std::nullopt, false}));
    QVERIFY(taken<SkidDrive>("DRIVE {Left 20} {Right 20} {Normalized true} {Light false}") ==
            (SkidDrive{20, 20, true, {.light_on = false}}));
    QVERIFY(taken<SkidDrive>("DRIVE {Left 1}DRIVE {Left 2}") == (SkidDrive{1.0, std::nullopt, false}));
}

void tst_CommandReader::yawRateFollowsTheDialect() {
    const std::string physical = "DRIVE {RotationalVelocity 90} {Normalized false}";
    QCOMPARE(std::get<AerialDrive>(take(physical).command).yaw_rate_rad_s.value(), -90.0);
    QCOMPARE(std::get<AerialDrive>(take(physical, Dialect::Udk).command).yaw_rate_rad_s.value(), -pi / 2);
    const std::string percent = "DRIVE {RotationalVelocity 90} {Normalized true}";
    QCOMPARE(std::get<AerialDrive>(take(percent, Dialect::Udk).command).yaw_rate_rad_s.value(), -90.0);
}

void tst_CommandReader::readsQuestions_data() {
    QTest::addColumn<QByteArray>("segments");
    QTest::addColumn<QByteArray>("type");
    QTest::addColumn<QByteArray>("name");
    QTest::newRow("all of a type") << QByteArray(" {Type Sonar}") << QByteArray("Sonar") << QByteArray();
    QTest::newRow("one by name") << QByteArray("{Type Sonar} {Name F1} ") << QByteArray("Sonar") << QByteArray("F1");
    QTest::newRow("an empty name is none")
        << QByteArray(" {Type Sonar} {Name }") << QByteArray("Sonar") << QByteArray();
}

void tst_CommandReader::readsQuestions() {
    QFETCH(QByteArray, segments);
    QFETCH(QByteArray, type);
    QFETCH(QByteArray, name);
    QVERIFY(taken<GetGeometry>("GETGEO" + segments.toStdString()) ==
            (GetGeometry{Token::make(type.toStdString()).value(), Name::mended(name.toStdString())}));
    QVERIFY(taken<GetConfiguration>("GetConf" + segments.toStdString()) ==
            (GetConfiguration{Token::make(type.toStdString()).value(), Name::mended(name.toStdString())}));
}

void tst_CommandReader::insTakesExactlySixNumbers_data() {
    QTest::addColumn<QByteArray>("params");
    QTest::addColumn<bool>("good");
    QTest::newRow("six") << QByteArray("{Params 1,2,-3,0,0,1}") << true;
    QTest::newRow("six with spaces") << QByteArray("{Params 1, 2, -3, 0, 0, 1}") << true;
    QTest::newRow("five") << QByteArray("{Params 1,2,-3,0,0}") << false;
    QTest::newRow("seven") << QByteArray("{Params 1,2,-3,0,0,1,1}") << false;
    QTest::newRow("a word among them") << QByteArray("{Params 1,2,-3,0,zero,1}") << false;
    QTest::newRow("not a number") << QByteArray("{Params 1,2,-3,0,nan,1}") << false;
    QTest::newRow("none") << QByteArray("") << false;
}

void tst_CommandReader::insTakesExactlySixNumbers() {
    QFETCH(QByteArray, params);
    QFETCH(bool, good);
    const std::string line = "SET {Type INS} {Name Ins2} {Opcode pose} " + params.toStdString();
    const Taken result = take(line);
    if (good) {
        QVERIFY(result.command == Command(SetInsPose{"Ins2", {{1, -2, 3}, 0, 0, -1}}));
        QVERIFY(result.diagnostics.empty());
    } else {
        QVERIFY(result.command == Command(RawCommand{line}));
        QVERIFY(!result.diagnostics.empty());
    }
}

void tst_CommandReader::readsOurOwnWords() {
    QVERIFY(taken<Lockstep>("LOCKSTEP {On true}").on);
    QVERIFY(!taken<Lockstep>("lockstep {on False}").on);
    taken<RawCommand>("LOCKSTEP", 1);
    taken<RawCommand>("LOCKSTEP {On perhaps}", 1);
    taken<Step>("STEP");
    taken<GetStartPoses>("getstartposes ");
    taken<GetStartPoses>("STARTPOSES");
}

void tst_CommandReader::readsEveryKind_data() {
    QTest::addColumn<bool>("as_expected");
    const auto row = [](const char* name, const char* line, const Command& expected) {
        const Taken result = take(line);
        QTest::newRow(name) << (result.command == expected && result.diagnostics.empty());
    };
    row("one steering angle alone", "DRIVE {FrontSteer 0.17}", AckermannDrive{.front_steer_rad = -0.17});
    row("a boat", "DRIVE {Propeller 0}", NauticDrive{.propeller_rad_s = 0.0});
    row("a joint without order goes to an angle", "DRIVE {Name FrontLeft} {Value 0}",
        JointDrive{"FrontLeft", JointOrder::Angle, 0});
    row("a joint by a relative order", "DRIVE {Name Knee}{Order 11}{Value -1}",
        JointDrive{"Knee", JointOrder::RelativeSpeed, -1.0});
    row("a brake", "DRIVE {Name FrontLeft} {Order 3} {Value 5}", JointDrive{"FrontLeft", JointOrder::Brake, 5.0});
    row("wheels in groups", "DRIVE {WheelNumber 1} {WheelSteer 0.5} {WheelSpeed 3} {WheelNumber 0} {WheelSpeed -3}",
        OmniDrive{{{1, 3.0, -0.5}, {0, -3.0, {}}}});
    row("flip", "DRIVE {Flip true}", DriveSwitches{.flip = true});
    row("nothing to drive", "DRIVE", DriveSwitches{});
    row("only what unit is meant", "DRIVE {Normalized true}", AerialDrive{.normalized = true});
    row("flippers in mixed case", "MULTIDRIVE {FRFlipper 1.5}{FLflipper -1.5}",
        MultiDrive{{{"FRFlipper", 1.5}, {"FLflipper", -1.5}}});
    row("a package by its misspelt word", "MISSPKG {Name Cam} {Link 1} {Value 1.5}", PackageDrive{"Cam", {{1, 1.5}}});
    row("a package turned the old way", "MISPKG {Name Cam1}{Rotation 0,0.1,0.5}", PackageRotation{"Cam1", 0.1, 0.5});
    row("a package's tip at a place", "MISPKG {Name Arm} {Location 0.5,0.25,-1}",
        PackagePose{"Arm", {0.5, -0.25, 1.0}});
    row("a package's tip in a pose", "MISSPKG {Name Arm}{Rotation 0.5,0.1,-1}{Location 0.5, 0.25, -1}",
        PackagePose{"Arm", {0.5, -0.25, 1.0}, Vec3(0.5, -0.1, 1.0)});
    row("orders of single links", "MISPKG {Name Arm} {Link 1} {Value 1} {Link 2} {Value 2} {Order 2}",
        PackageDrive{"Arm", {{1, 1.0, LinkOrder::Angle}, {2, 2.0, LinkOrder::Torque}}});
    row("a sequence", "ACT {Name KR60Arm} {Sequence 2}", ActuatorDrive{"KR60Arm", {}, {}, 2});
    row("a zoom without key", "SET {Type Camera} {Name Camera} {Opcode Zoom} {0.785398}",
        ZoomCamera{0.785398, "Camera"});
    row("a zoom by its other word", "SET {Type Camera} {Opcode fov} {Params 0.5}", ZoomCamera{0.5});
    row("a joint's numbered opcode", "SET {Type Joint} {Name Knee} {Opcode 12} {Params 1}",
        SetJoint{"Knee", JointOpcode::RelativeTorque, 1.0});
    row("a joint's target", "SET {Type Joint} {Name Knee} {Opcode Target} {Params 0.3}",
        SetJoint{"Knee", JointOpcode::Angle, 0.3});
    row("a grip without number", "SET {Type Gripper} {Opcode GRIP}", UseGripper{GripperAction::Grip});
    row("a hand that lets go", "SET {Type Gripper} {Opcode grip} {Params 0}", UseGripper{GripperAction::LetGo});
    row("parameters are not asked for", "SET {Type Gripper} {Opcode Close} {Params 0.0000}",
        UseGripper{GripperAction::Close});
    row("a tag without text", "SET {Type RFID} {Name RFID} {Opcode Write} {Params 118}", WriteTag{"118", {}, "RFID"});
    row("another setting of INS", "SET {Type INS} {Name INS} {Opcode RESET}", ResetSensor{"INS", "INS"});
    row("a sensor nobody knows", "SET {Type Siren} {Opcode LOUD} {Params a b}", SetItem{"Siren", "LOUD", {}, "a b"});
    row("marks off", "Trace {On False}", Trace{.on = false});
    row("all objects", "CONTROL {Type KillAll}", KillAllObjects{});
    row("a box's corners change sides", "CONTROL {Type KillAll} {MinPos 0,1,2} {MaxPos 5,6,7}",
        KillAllObjects{Box{{0, -6, -7}, {5, -1, -2}}});
    row("a type said twice", "CONTROL {Type GetSTA} {Type Box} {Name Box1}", GetObjectStates{"Box1"});
    row("a path node", "MOVE {Action Append} {Pathnode PathNode_3} {Type Run}", WalkTo{"PathNode_3", Gait::Run, true});
    row("a pause", "PAUSE {TIME 10}", Pause{Seconds(10)});
}

void tst_CommandReader::readsEveryKind() {
    QFETCH(bool, as_expected);
    QVERIFY(as_expected);
}

/// Every line for the bot port has a struct of its own.
void tst_CommandReader::readsWhatClientsSend() {
    for (const corpus::Line& line : corpus::commandLines()) {
        if (line.source.find("not the bot port") != std::string::npos)
            continue;
        const Taken result = take(line.text);
        QVERIFY2(!std::holds_alternative<RawCommand>(result.command), line.place.c_str());
    }
}

void tst_CommandReader::repairsWhatServersTolerate_data() {
    QTest::addColumn<bool>("as_expected");
    QTest::addColumn<int>("diagnostics");
    QTest::addColumn<int>("expected_diagnostics");
    const auto row = [](const char* name, const char* line, const Command& expected, int diagnostics) {
        const Taken result = take(line);
        QTest::newRow(name) << (result.command == expected) << static_cast<int>(result.diagnostics.size())
                            << diagnostics;
    };
    const auto skid = [](double left_rad_s) { return SkidDrive{.left_rad_s = left_rad_s}; };
    // The rows of protocol.md 1.6.
    row("unknown type word", "HOVER {Left 1}", RawCommand{"HOVER {Left 1}"}, 0);
    row("unknown segment", "DRIVE {Left 1} {Mood good}", skid(1), 0);
    row("repeated key: the first wins", "DRIVE {Left 1} {Left 2}", skid(1), 0);
    row("repeated key where the code walks the list", "MISPKG {Name A} {Link 1} {Value 2} {Link 1} {Value 3}",
        PackageDrive{"A", {{1, 2.0}, {1, 3.0}}}, 0);
    row("segment without a value, and those after it", "DRIVE {abc} {Left 1}", skid(1), 0);
    row("empty value, and those after it", "GETGEO {Name } {Type Sonar}", GetGeometry{"Sonar"}, 0);
    row("no closing brace", "DRIVE {Left 1", skid(1), 1);
    row("stray closing brace", "DRIVE {Left 1} } {Right 2}}", SkidDrive{1.0, 2.0}, 0);
    row("an opening brace inside", "DRIVE {Left 1 {Right 2}", skid(1), 2);
    row("number with junk", "DRIVE {Left 1,00}", skid(1), 1);
    row("a word for a number", "DRIVE {Left abc}", skid(0), 1);
    row("missing number", "DRIVE {Left }", skid(0), 1);
    row("two commands on a line", "DRIVE {Left 1}DRIVE {Left 2}", skid(1), 0);
    // Numbers, 1.7.
    row("signs, leading dots and zeros", "DRIVE {Left +.4} {Right 020}", SkidDrive{0.4, 20.0}, 0);
    row("exponents", "DRIVE {Left 1.5e1} {Right -2E-1}", SkidDrive{15.0, -0.2}, 0);
    row("not a number by Windows", "DRIVE {Left -1.#IND} {Right 1.#QNAN}", SkidDrive{0.0, 0.0}, 2);
    row("endless", "DRIVE {Left inf} {Right 1e999}", SkidDrive{0.0, 0.0}, 2);
    row("a vector with spaces", "GETCLOSESTPATHNODE {Location 3.0 4.0  0}", GetClosestPathNode{{3, -4, 0}}, 0);
    row("a vector with commas and spaces", "GETCLOSESTPATHNODE {Location 3.0, 4.0 ,0}", GetClosestPathNode{{3, -4, 0}},
        0);
    row("a vector by a comma locale", "GETCLOSESTPATHNODE {Location 3,00, 4,00, 0,00}", GetClosestPathNode{{3, 0, -4}},
        1);
    row("booleans in any case and as numbers", "DRIVE {Light TRUE} {Flip 0}", DriveSwitches{true, false}, 0);
    row("a boolean that is none", "DRIVE {Light perhaps}", DriveSwitches{.light_on = false}, 1);
    row("keys and words in any case", "control {TYPE kill} {NAME Box1}", KillObject{"Box1"}, 0);
    row("a name of two words", "CONTROL {Type Kill} {Name Box 1}", KillObject{"Box1"}, 1);
}

void tst_CommandReader::repairsWhatServersTolerate() {
    QFETCH(bool, as_expected);
    QFETCH(int, diagnostics);
    QFETCH(int, expected_diagnostics);
    QVERIFY(as_expected);
    QCOMPARE(diagnostics, expected_diagnostics);
}

void tst_CommandReader::takesNumbersAsServersDo_data() {
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<double>("expected");
    QTest::addColumn<int>("warnings");
    QTest::newRow("plain") << QByteArray("1.25") << 1.25 << 0;
    QTest::newRow("leading dot") << QByteArray(".4") << 0.4 << 0;
    QTest::newRow("leading zeros") << QByteArray("020") << 20.0 << 0;
    QTest::newRow("plus") << QByteArray("+1.5") << 1.5 << 0;
    QTest::newRow("decimal comma") << QByteArray("1,00") << 1.0 << 1;
    QTest::newRow("a unit after the number") << QByteArray("2rad") << 2.0 << 1;
    QTest::newRow("a word is nothing") << QByteArray("fast") << 0.0 << 1;
    QTest::newRow("no value is nothing") << QByteArray("") << 0.0 << 1;
    QTest::newRow("not a number drives nowhere") << QByteArray("nan") << 0.0 << 1;
    QTest::newRow("infinity drives nowhere") << QByteArray("inf") << 0.0 << 1;
}

void tst_CommandReader::takesNumbersAsServersDo() {
    QFETCH(QByteArray, value);
    QFETCH(double, expected);
    QFETCH(int, warnings);
    const auto drive =
        taken<AerialDrive>("DRIVE {LinearVelocity " + value.toStdString() + "}", static_cast<std::size_t>(warnings));
    QCOMPARE(drive.forward_m_s.value(), expected);
}

void tst_CommandReader::keepsTheRestRaw_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<int>("diagnostics");
    const auto row = [](const char* name, const char* line, int diagnostics) {
        QTest::newRow(name) << QByteArray(line) << diagnostics;
    };
    row("unknown word", "FLY {On true} {Interval 0.5}", 0);
    row("a word of another port", "GETSS {Robot R2}", 0);
    row("a spawn without class", "INIT {Robot R1} {Port 6000}", 1);
    row("a question without type", "GETGEO {Name F1}", 1);
    row("a DRIVE of nothing we know", "DRIVE {Spin1 0.5}", 1);
    row("a joint without name", "DRIVE {Name } {Value 1}", 1);
    row("a joint by no order we know", "DRIVE {Name Knee} {Order 7} {Value 1}", 1);
    row("a wheel without number", "DRIVE {WheelSpeed 1} {WheelNumber 0}", 1);
    row("half a wheel", "DRIVE {WheelNumber 0.5} {WheelSpeed 1}", 1);
    row("a package without name", "MISPKG {Link 1} {Value 1}", 1);
    row("a value before its link", "MISPKG {Name Arm} {Value 1} {Link 1}", 1);
    row("an actuator without name", "ACT {Link 1} {Value 1}", 1);
    row("an unknown color", "TRACE {On true} {Color Pink}", 1);
    row("a SET without opcode", "SET {Type Odometry}", 1);
    row("a SET without type", "SET {Opcode LOUD}", 1);
    row("a camera without client", "SET {Type Camera} {Robot R1} {Name Cam}", 1);
    row("a zoom without angle", "SET {Type Camera} {Name Cam} {Opcode Zoom}", 1);
    row("a joint set to nothing", "SET {Type Joint} {Name Knee} {Opcode Angle}", 1);
    row("a joint set by no opcode we know", "SET {Type Joint} {Name Knee} {Opcode Wiggle} {Params 1}", 1);
    row("a tag without number", "SET {Type RFID} {Opcode Write}", 1);
    row("a CONTROL of no type", "CONTROL {Name B1}", 1);
    row("a CONTROL of an unknown type", "CONTROL {Type Paint} {Name B1}", 1);
    row("an object without name", "CONTROL {Type Kill}", 1);
    row("an object without class", "CONTROL {Type Create} {Name B1}", 1);
    row("half a box", "CONTROL {Type KillAll} {MinPos 0,0,0}", 1);
    row("a belt without speed", "CONTROL {Type Conveyor} {Name Belt}", 1);
    row("a way point of two numbers", "CONTROL {Type AddWP} {Name B1} {WP 1,2,3;4,5}", 1);
    row("a way at no pace", "CONTROL {Type SetWP} {Name B1} {Loop true}", 1);
    row("no path node", "GOTO", 1);
    row("no place", "GETCLOSESTPATHNODE", 1);
    row("a walk to nowhere", "MOVE {Action New} {Type Run}", 1);
    row("a walk of an unknown kind", "MOVE {Action Dance}", 1);
    row("nothing", "", 0);
}

void tst_CommandReader::keepsTheRestRaw() {
    QFETCH(QByteArray, line);
    QFETCH(int, diagnostics);
    QCOMPARE(taken<RawCommand>(line.toStdString(), static_cast<std::size_t>(diagnostics)).line, line.toStdString());
}

void tst_CommandReader::everyPrefixOfEveryLineIsTaken() {
    const std::vector<corpus::Line> lines = corpus::commandLines();
    QVERIFY(lines.size() > 20);
    for (const corpus::Line& line : lines) {
        for (std::size_t length = 0; length <= line.text.size(); ++length) {
            const std::string prefix = line.text.substr(0, length);
            const Taken result = take(prefix);
            if (const RawCommand* const raw = std::get_if<RawCommand>(&result.command))
                QCOMPARE(raw->line, prefix);
            for (const Diagnostic& diagnostic : result.diagnostics)
                QVERIFY2(diagnostic.offset <= length, line.place.c_str());
        }
    }
}

void tst_CommandReader::randomBytesAreTaken() {
    const std::string alphabet = "{} ,.-+1e\0\xffINTSDRVELocation"s;
    Random random = seeded(41, 1);
    for (int round = 0; round < 20000; ++round) {
        std::string line = round % 2 == 0 ? "DRIVE {LinearVelocity " : "INIT {ClassName X} {Location ";
        for (std::size_t length = random() % 30; length > 0; --length)
            line += alphabet[random() % alphabet.size()];
        const Taken result = take(line);
        if (const Init* const init = std::get_if<Init>(&result.command)) {
            if (const Pose* const pose = std::get_if<Pose>(&init->start))
                QVERIFY(pose->position_m.allFinite());
        }
    }
}

/// Keys that a command knows, with values that it may refuse: whatever is read from them is written in the same way
/// again.
void tst_CommandReader::whatIsTakenFromAnOddLineIsWrittenSo() {
    const std::vector<std::string> values = {"",     "1",    "-0.5",   "1e9", "1,2,3", "1 2 3", "4,5",
                                             "nan",  "a",    "a b",    "x{",  "true",  "None",  "1,2;3",
                                             "POSE", "GRIP", "Create", "New", "Cam",   "7rad"};
    Random random = seeded(45, 1);
    const auto rules = commandRules();
    for (int round = 0; round < 50000; ++round) {
        const CommandRule& rule = rules[random() % rules.size()];
        std::string line(rule.word);
        for (std::size_t count = rule.segments.empty() ? 0 : random() % 8; count > 0; --count) {
            const SegmentRule& segment = rule.segments[random() % rule.segments.size()];
            const std::string value = segment.words.empty() || random() % 4 == 0
                                          ? values[random() % values.size()]
                                          : std::string(segment.words[random() % segment.words.size()]);
            line += " {" + std::string(segment.key) + " " + value + "}";
        }
        for (const Dialect dialect : {Dialect::Ut2004, Dialect::Udk}) {
            const std::string written = write(take(line, dialect).command, dialect);
            QVERIFY2(write(take(written, dialect).command, dialect) == written, (line + " -> " + written).c_str());
        }
    }
}

USAR_TEST(tst_CommandReader)

} // namespace tst_command_reader

#include "tst_command_reader.moc"
