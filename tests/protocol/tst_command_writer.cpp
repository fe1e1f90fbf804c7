#include <QTest>

#include "core/base/random.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"

using namespace usar;
using namespace usar::protocol;

namespace {

double anyNumber(Random& random) {
    switch (random() % 4) {
    case 0:
        return static_cast<double>(random() % 200) - 100.0;
    case 1:
        return uniform(random, -1, 1) * 1e-9;
    case 2:
        return uniform(random, -1e6, 1e6);
    default:
        return uniform(random, -5, 5);
    }
}

std::optional<double> perhaps(Random& random) {
    return random() % 3 == 0 ? std::nullopt : std::optional(anyNumber(random));
}

std::string anyToken(Random& random) {
    static const std::string letters = "abcXYZ019_.-";
    std::string token(1 + random() % 12, 'a');
    for (char& c : token)
        c = letters[random() % letters.size()];
    return token;
}

Pose anyPose(Random& random) {
    return {{anyNumber(random), anyNumber(random), anyNumber(random)},
            uniform(random, -pi, pi),
            uniform(random, -pi, pi),
            uniform(random, -pi, pi)};
}

Init anyInit(Random& random) {
    Init init{anyToken(random), random() % 2 ? anyToken(random) : std::string(), anyPose(random), std::nullopt};
    if (random() % 2) {
        init.start = anyToken(random);
        if (random() % 2)
            init.fallback_in_map = anyPose(random);
    }
    return init;
}

Command anyCommand(Random& random) {
    switch (random() % 9) {
    case 0:
        return anyInit(random);
    case 1:
        return GetStartPoses{};
    case 2:
        return AerialDrive{perhaps(random), perhaps(random), perhaps(random), perhaps(random), random() % 2 == 0};
    case 3:
        return SkidDrive{anyNumber(random), perhaps(random), random() % 2 == 0};
    case 4:
        return GetGeometry{anyToken(random), random() % 2 ? anyToken(random) : std::string()};
    case 5:
        return GetConfiguration{anyToken(random), random() % 2 ? anyToken(random) : std::string()};
    case 6:
        return SetInsPose{anyToken(random), anyPose(random)};
    case 7:
        return Lockstep{random() % 2 == 0};
    default:
        return Step{};
    }
}

} // namespace

class tst_CommandWriter : public QObject {
    Q_OBJECT
private slots:
    void writingThenReadingIsTheIdentity();
    void spellsLinesAsStrictServersWantThem_data();
    void spellsLinesAsStrictServersWantThem();
    void udkTakesDegreesPerSecond();
    void aNameCannotBreakTheLine();
};

void tst_CommandWriter::writingThenReadingIsTheIdentity() {
    Random random = seeded(42, 1);
    for (int i = 0; i < 20000; ++i) {
        const Command command = anyCommand(random);
        const std::string line = write(command);
        Diagnostics diagnostics;
        const Command again = readCommand(line, diagnostics);
        QVERIFY2(again == command, line.c_str());
        QVERIFY2(diagnostics.empty(), line.c_str());
    }
}

void tst_CommandWriter::spellsLinesAsStrictServersWantThem_data() {
    QTest::addColumn<QByteArray>("line");
    const auto row = [](const char* name, const Command& command, const char* line) {
        QCOMPARE(QByteArray::fromStdString(write(command)), QByteArray(line));
        QTest::newRow(name) << QByteArray(line);
    };
    row("spawn at a pose", Init{"USARBot.AirRobot", "R1", Pose{{4.5, -1.9, 1.8}, 0.5, 0.25, -1.5}, {}},
        "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 4.5,1.9,-1.8} {Rotation 0.5,-0.25,1.5}");
    row("spawn at a name", Init{"USARBot.P3AT", "", "PlayerStart", {}},
        "INIT {ClassName USARBot.P3AT} {Start PlayerStart}");
    row("start poses", GetStartPoses{}, "GETSTARTPOSES");
    row("fly", AerialDrive{0.5, 1.0, 0.25, -0.125, false},
        "DRIVE {AltitudeVelocity 0.5} {LinearVelocity 1} {LateralVelocity -0.25} {RotationalVelocity 0.125} "
        "{Normalized "
        "false}");
    row("only what is said", AerialDrive{.forward_m_s = 100.0, .normalized = true},
        "DRIVE {LinearVelocity 100} {Normalized true}");
    row("roll", SkidDrive{1.0, -1.0, false}, "DRIVE {Left 1} {Right -1} {Normalized false}");
    row("geometry", GetGeometry{"Sonar", ""}, "GETGEO {Type Sonar}");
    row("configuration", GetConfiguration{"Camera", "Cam"}, "GETCONF {Type Camera} {Name Cam}");
    row("INS", SetInsPose{"INS", {{1, -2, 3}, 0.5, 0.25, -1}},
        "SET {Type INS} {Name INS} {Opcode POSE} {Params 1,2,-3,0.5,-0.25,1}");
    row("lockstep", Lockstep{true}, "LOCKSTEP {On true}");
    row("step", Step{}, "STEP");
    row("raw", RawCommand{"Trace {On true}"}, "Trace {On true}");
}

void tst_CommandWriter::spellsLinesAsStrictServersWantThem() {
    QFETCH(QByteArray, line);
    // Compared where the row is made, for the command is no meta type; here: what we send we take.
    Diagnostics diagnostics;
    QCOMPARE(QByteArray::fromStdString(write(readCommand(line.toStdString(), diagnostics))), line);
}

void tst_CommandWriter::udkTakesDegreesPerSecond() {
    Random random = seeded(43, 1);
    QCOMPARE(write(AerialDrive{.yaw_rate_rad_s = -pi / 2}, Dialect::Udk),
             std::string("DRIVE {RotationalVelocity 90} {Normalized false}"));
    QCOMPARE(write(AerialDrive{.yaw_rate_rad_s = -50.0, .normalized = true}, Dialect::Udk),
             std::string("DRIVE {RotationalVelocity 50} {Normalized true}"));
    for (int i = 0; i < 1000; ++i) {
        const double rate_rad_s = uniform(random, -5, 5);
        Diagnostics diagnostics;
        const Command again =
            readCommand(write(AerialDrive{.yaw_rate_rad_s = rate_rad_s}, Dialect::Udk), diagnostics, Dialect::Udk);
        QVERIFY(std::abs(std::get<AerialDrive>(again).yaw_rate_rad_s.value() - rate_rad_s) < 1e-12);
    }
}

void tst_CommandWriter::aNameCannotBreakTheLine() {
    const std::string line = write(Init{"USARBot.P2DX", "R1}\r\nDRIVE {Left 9", Pose{}, {}});
    QVERIFY(line.find('\n') == std::string::npos && line.find('\r') == std::string::npos);
    Diagnostics diagnostics;
    const Command again = readCommand(line, diagnostics);
    QCOMPARE(std::get<Init>(again).robot_name, std::string("R1DRIVE Left 9"));
    QVERIFY(diagnostics.empty());
}

QTEST_APPLESS_MAIN(tst_CommandWriter)
#include "tst_command_writer.moc"
