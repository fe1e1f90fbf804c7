#include <QTest>

#include "core/base/random.h"
#include "core/protocol/command_reader.h"
#include "corpus.h"

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
    void takesNumbersAsServersDo_data();
    void takesNumbersAsServersDo();
    void keepsTheRestRaw_data();
    void keepsTheRestRaw();
    void everyPrefixOfEveryLineIsTaken();
    void randomBytesAreTaken();
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
    QCOMPARE(init.class_name, std::string("USARBot.AirRobot"));
    QCOMPARE(init.robot_name, std::string("R1"));
    QVERIFY(std::get<Pose>(init.start) == (Pose{{4.5, -1.9, 1.8}, 0.1, -0.2, -0.3}));
    QVERIFY(std::get<Pose>(taken<Init>("INIT {ClassName X}").start) == Pose{});
    // One brace missing, as the pyro driver sends it.
    const auto pyro = taken<Init>("INIT {ClassName X} {Name r} {Location 4.5,1.9,1.8} {Rotation 0,0,1", 1);
    QCOMPARE(std::get<Pose>(pyro.start).yaw_rad, -1.0);
    QVERIFY(std::get<Pose>(taken<Init>("INIT {ClassName X} {Location 1,2}", 1).start).position_m == Vec3(1, -2, 0));
}

void tst_CommandReader::aNamedStartKeepsItsFallback() {
    const auto named = taken<Init>("INIT {ClassName X} {Start playerstart}");
    QCOMPARE(std::get<std::string>(named.start), std::string("playerstart"));
    QVERIFY(!named.fallback_in_map);
    const auto both = taken<Init>("INIT {ClassName X}{Location 1,-2,0}{Rotation 0,0,0}{Start Point1}");
    QCOMPARE(std::get<std::string>(both.start), std::string("Point1"));
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
            (SkidDrive{20, 20, true}));
    QVERIFY(taken<SkidDrive>("DRIVE {Left 1}DRIVE {Left 2}") == (SkidDrive{1.0, std::nullopt, false}));
}

void tst_CommandReader::yawRateFollowsTheDialect() {
    const std::string physical = "DRIVE {RotationalVelocity 90} {Normalized false}";
    QCOMPARE(std::get<AerialDrive>(take(physical).command).yaw_rate_rad_s.value(), -90.0);
    QCOMPARE(std::get<AerialDrive>(take(physical, Dialect::Udk).command).yaw_rate_rad_s.value(), -pi / 2);
    const std::string per_cent = "DRIVE {RotationalVelocity 90} {Normalized true}";
    QCOMPARE(std::get<AerialDrive>(take(per_cent, Dialect::Udk).command).yaw_rate_rad_s.value(), -90.0);
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
            (GetGeometry{type.toStdString(), name.toStdString()}));
    QVERIFY(taken<GetConfiguration>("GetConf" + segments.toStdString()) ==
            (GetConfiguration{type.toStdString(), name.toStdString()}));
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

void tst_CommandReader::takesNumbersAsServersDo_data() {
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<double>("expected");
    QTest::addColumn<int>("warnings");
    QTest::newRow("plain") << QByteArray("1.25") << 1.25 << 0;
    QTest::newRow("leading dot") << QByteArray(".4") << 0.4 << 0;
    QTest::newRow("leading zeros") << QByteArray("020") << 20.0 << 0;
    QTest::newRow("plus") << QByteArray("+1.5") << 1.5 << 0;
    QTest::newRow("decimal comma") << QByteArray("1,00") << 1.0 << 1;
    QTest::newRow("unit behind") << QByteArray("2rad") << 2.0 << 1;
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
    row("Ackerman drive", "DRIVE {Speed 3.0} {FrontSteer 0.523599}", 0);
    row("joint drive", "DRIVE {Name FLFlipper} {Order 1} {Value 0.3}", 0);
    row("lights only", "DRIVE {Light true}", 0);
    row("mission package", "MISPKG {Name CameraPanTilt} {Link 1} {Value 1.5}", 0);
    row("misspelt mission package", "MISSPKG {Name CameraPanTilt} {Link 1} {Value 1.5}", 0);
    row("camera zoom", "SET {Type Camera} {Name Camera} {Opcode Zoom} {0.785398}", 0);
    row("other settings of INS", "SET {Type INS} {Name INS} {Opcode RESET}", 0);
    row("unknown word", "Trace {On true} {Interval 0.5}", 0);
    row("a spawn without class", "INIT {Robot R1} {Port 6000}", 1);
    row("a question without type", "GETGEO {Name F1}", 1);
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

QTEST_APPLESS_MAIN(tst_CommandReader)
#include "tst_command_reader.moc"
