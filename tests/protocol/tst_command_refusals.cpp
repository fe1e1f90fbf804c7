// Lines that no command can hold, with the reason that is reported; texts that fit into a line; words for vehicles.
#include <QTest>

#include <string>

#include "core/base/random.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/vehicle_words.h"
#include "core/protocol/zero_drives.h"
#include "tests/suite/suite.h"

namespace tst_command_refusals {

using namespace usar;
using namespace usar::protocol;

namespace {

QString wordsOf(const Diagnostics& diagnostics) {
    QStringList words;
    for (const Diagnostic& diagnostic : diagnostics)
        words << QString::fromStdString(diagnostic.message);
    return words.join(" | ");
}

/// The lines that bring a vehicle of this kind to rest, without their unit.
QString stopsOf(VehicleKind kind) {
    QStringList lines;
    for (const Command& stop : zeroDrives(kind))
        lines << QString::fromStdString(write(stop)).remove(" {Normalized false}");
    return lines.join(" | ");
}

} // namespace

class tst_CommandRefusals : public QObject {
    Q_OBJECT
private slots:
    void aLineThatNoCommandHoldsStaysRawWithAReason_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* line, const char* reason) {
            QTest::newRow(line) << QByteArray(line) << QString(reason);
        };
        row("INIT {Name R1}", "INIT needs a ClassName");
        row("GETGEO", "GETGEO needs a Type");
        row("GETCONF {Name F1}", "GETCONF needs a Type");
        row("DRIVE {WheelSpeed 3}", "DRIVE has no form with these segments");
        row("DRIVE {WheelSpeed 3} {WheelNumber 0}", "WheelSpeed stands before the first WheelNumber");
        row("DRIVE {Name Knee} {Order 7}", "Order does not take '7'");
        row("SET {Type INS} {Opcode POSE} {Params 1,2,3}", "Params takes exactly six numbers");
        row("SET {Type Viewports} {Config TripleView}", "Config does not take 'TripleView'");
        row("SET {Type Joint} {Opcode Angle} {Params 1}", "SET needs a Name");
        row("MISPKG {Name Arm} {Link 1.5} {Value 1}", "Link takes a whole number");
        row("MISPKG {Name Arm} {Link 1e10} {Value 1}", "Link takes a whole number");
        row("ACT {Link 1} {Value 0}", "ACT needs a Name");
        row("CONTROL {Type Create}", "CONTROL needs a ClassName");
        row("CONTROL {Type Explode} {Name B}", "CONTROL has no form with these segments");
        row("CONTROL {Type Rotate} {Name B}", "CONTROL needs a Speed");
        row("CONTROL {Type KillAll} {MinPos 0,0,0}", "MinPos and MaxPos need each other");
        row("CONTROL {Type AddWP} {Name B} {WP 1,2}", "a waypoint does not consist of three numbers");
        row("CONTROL {Type AddWP} {Name B} {WP 1,2,3;;4,5,6}", "a waypoint does not consist of three numbers");
        row("MOVE {Action New} {Type Run}", "MOVE needs a Location or a Pathnode");
        row("MOVE {Action New} {Type Crawl} {Location 1,2}", "Type does not take 'Crawl'");
        row("GOTO {Name }", "GOTO needs a Name");
        row("TRACE {On true} {Color Pink}", "Color does not take 'Pink'");
        row("LOCKSTEP {On perhaps}", "LOCKSTEP needs On true or false");
        row("PAUSE", "PAUSE needs a Time");
    }

    void aLineThatNoCommandHoldsStaysRawWithAReason() {
        QFETCH(QByteArray, line);
        QFETCH(QString, reason);
        for (const Dialect dialect : {Dialect::Ut2004, Dialect::Udk}) {
            Diagnostics diagnostics;
            const Command command = readCommand(line.toStdString(), diagnostics, dialect);
            QVERIFY(command == Command(RawCommand{line.toStdString()}));
            QVERIFY2(wordsOf(diagnostics).contains(reason), qPrintable(wordsOf(diagnostics)));
            for (const Diagnostic& diagnostic : diagnostics)
                QVERIFY(diagnostic.offset <= static_cast<std::size_t>(line.size()));
            QCOMPARE(QByteArray::fromStdString(write(command, dialect)), line);
        }
    }

    void whatIsCorrectedIsReported_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("written");
        QTest::addColumn<QString>("warning");
        const auto row = [](const char* name, const char* line, const char* written, const char* warning) {
            QTest::newRow(name) << QByteArray(line) << QByteArray(written) << QString(warning);
        };
        row("percent beyond 100", "DRIVE {Left 120} {Right -120} {Normalized true}",
            "DRIVE {Left 100} {Right -100} {Normalized true}", "beyond 100 percent; limited to it");
        row("a word instead of a number", "DRIVE {Left fast}", "DRIVE {Left 0} {Normalized false}",
            "not exactly 1 number; read as far as possible");
        row("two numbers of three", "CONTROL {Type Rotate} {Name B} {Speed 1,2}",
            "CONTROL {Type Rotate} {Name B} {Speed 1,2,0}", "not exactly 3 numbers; read as far as possible");
        row("a flag that is neither", "DRIVE {Light dim}", "DRIVE {Light false}",
            "neither true nor false; read as false");
        row("a name with a space", "GOTO {Name Path Node}", "GOTO {Name PathNode}",
            "contains spaces or braces that are not allowed here; read as 'PathNode'");
        row("no closing brace", "GOTO {Name Door1", "GOTO {Name Door1}", "the closing brace is missing");
    }

    void whatIsCorrectedIsReported() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, written);
        QFETCH(QString, warning);
        Diagnostics diagnostics;
        const Command command = readCommand(line.toStdString(), diagnostics);
        QCOMPARE(QByteArray::fromStdString(write(command)), written);
        QVERIFY2(wordsOf(diagnostics).contains(warning), qPrintable(wordsOf(diagnostics)));
    }

    void aTextFitsIfTheWireLeavesItAsItIs_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("token");
        QTest::addColumn<bool>("name");
        QTest::addColumn<bool>("free_text");
        const auto row = [](const char* name, const QByteArray& text, bool token, bool as_name, bool free_text) {
            QTest::newRow(name) << text << token << as_name << free_text;
        };
        row("a word", "USARBot.P2DX", true, true, true);
        row("nothing", "", false, true, true);
        row("two words", "visited by", false, false, true);
        row("a space before", " a", false, false, false);
        row("a space after", "a ", false, false, false);
        row("an opening brace", "a{b", false, false, false);
        row("a closing brace", "a}b", false, false, false);
        row("a line end", "a\nb", false, false, false);
        row("a tab", "a\tb", false, false, false);
        row("a zero byte", QByteArray("a\0b", 3), false, false, false);
        row("delete", "a\x7f", false, false, false);
        row("bytes beyond ASCII", "caf\xe9", true, true, true);
    }

    void aTextFitsIfTheWireLeavesItAsItIs() {
        QFETCH(QByteArray, text);
        QFETCH(bool, token);
        QFETCH(bool, name);
        QFETCH(bool, free_text);
        const std::string bytes = text.toStdString();
        QCOMPARE(fits(TextRule::Token, bytes), token);
        QCOMPARE(fits(TextRule::Name, bytes), name);
        QCOMPARE(fits(TextRule::Text, bytes), free_text);
        QCOMPARE(Token::make(bytes).has_value(), token);
        QCOMPARE(Name::make(bytes).has_value(), name);
        QCOMPARE(Text::make(bytes).has_value(), free_text);
    }

    void whatDoesNotFitIsLeftOut() {
        QCOMPARE(fitted(TextRule::Token, " R {1}\n"), std::string("R1"));
        QCOMPARE(fitted(TextRule::Text, " seen {by}  R1\r\n"), std::string("seen by  R1"));
        QCOMPARE(Name::mended("{ }").text(), std::string());
        Random random = seeded(3, 1);
        std::uniform_int_distribution<int> byte(0, 255);
        for (int i = 0; i < 2000; ++i) {
            std::string bytes;
            for (int length = i % 9; length > 0; --length)
                bytes += static_cast<char>(byte(random));
            for (const TextRule rule : {TextRule::Token, TextRule::Name, TextRule::Text}) {
                const std::string left = fitted(rule, bytes);
                QVERIFY(fits(rule, left) || (rule == TextRule::Token && left.empty()));
                QVERIFY(!fits(rule, bytes) || left == bytes);
            }
        }
    }

    void aMisfitSaysWhatToDo() {
        QCOMPARE(misfit(TextRule::Token, "").text(),
                 std::string("command: a name must not be empty. Give it a name of one word."));
        QCOMPARE(Token::make("a b").error().text(),
                 std::string("'a b': a name cannot hold spaces, braces or line ends. Choose a name of one word."));
        QCOMPARE(Text::make("{").error().text(),
                 std::string("'{': a text cannot hold braces, line ends or spaces around it. Leave them out."));
    }

    void vehiclesHaveWordsOfOldAndNewServers_data() {
        QTest::addColumn<QByteArray>("word");
        QTest::addColumn<int>("kind");
        QTest::addColumn<QByteArray>("ours");
        const auto row = [](const char* word, VehicleKind kind, const char* ours) {
            QTest::newRow(*word ? word : "nothing") << QByteArray(word) << int(kind) << QByteArray(ours);
        };
        row("GroundVehicle", VehicleKind::Ground, "GroundVehicle");
        row("aerialvehicle", VehicleKind::Aerial, "AerialVehicle");
        row("NAUTICVEHICLE", VehicleKind::Nautic, "NauticVehicle");
        row("LeggedRobot", VehicleKind::Legged, "LeggedRobot");
        row("LeggedVehicle", VehicleKind::Legged, "LeggedRobot");
        row("StaticPlatform", VehicleKind::StaticPlatform, "StaticPlatform");
        row("BaseMachine", VehicleKind::StaticPlatform, "StaticPlatform");
        row("GroundVehicles", VehicleKind::Unknown, "");
        row("", VehicleKind::Unknown, "");
    }

    void vehiclesHaveWordsOfOldAndNewServers() {
        QFETCH(QByteArray, word);
        QFETCH(int, kind);
        QFETCH(QByteArray, ours);
        const VehicleKind read = vehicleKindOf(word.toStdString());
        QCOMPARE(int(read), kind);
        QCOMPARE(QByteArray::fromStdString(std::string(wordOf(read))), ours);
    }

    void everyVehicleThatDrivesIsStopped() {
        const QString flight =
            "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}";
        const QString wheels = "DRIVE {Left 0} {Right 0}";
        QCOMPARE(stopsOf(VehicleKind::Ground), wheels);
        QCOMPARE(stopsOf(VehicleKind::Aerial), flight);
        QCOMPARE(stopsOf(VehicleKind::Nautic), QString("DRIVE {Propeller 0} {Rudder 0} {SternPlane 0}"));
        QCOMPARE(stopsOf(VehicleKind::Unknown), flight + " | " + wheels);
        QCOMPARE(stopsOf(VehicleKind::Legged), QString());
        QCOMPARE(stopsOf(VehicleKind::StaticPlatform), QString());
    }
};

USAR_TEST(tst_CommandRefusals)

} // namespace tst_command_refusals

#include "tst_command_refusals.moc"
