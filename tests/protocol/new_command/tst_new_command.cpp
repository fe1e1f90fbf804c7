// Adds commands as anybody would, by a file and an entry of the variant, and uses them everywhere a known one is used.
// The entries are put into a copy of the variant, with which core/protocol is built once more.
#include <QTest>

#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/command_writer.h"
#include "tests/suite/suite.h"

using namespace usar;
using namespace usar::protocol;

namespace {

std::string offered(std::string_view before) {
    std::string texts;
    for (const Completion& completion : completionsAt(before, before.size()))
        texts += (texts.empty() ? "" : ",") + completion.text;
    return texts;
}

std::string complaints(std::string_view line) {
    std::string texts;
    for (const Diagnostic& diagnostic : checkCommand(line))
        texts += toText(diagnostic);
    return texts;
}

} // namespace

class tst_NewCommand : public QObject {
    Q_OBJECT
private slots:
    void isWritten();
    void isRead();
    void isReadWithAllTolerance();
    void isCompleted();
    void isChecked();
    void isExplained();
    void isKnownAmongThoseWithItsWord();
    void theOthersStayAsTheyAre();
};

void tst_NewCommand::isWritten() {
    QCOMPARE(write(SoundHorn{HornTune::Greeting, 440.0, -0.5}),
             std::string("HORN {Tune Greeting} {Pitch 440} {Aim 0.5}"));
    QCOMPARE(write(SoundHorn{}), std::string("HORN {Tune Alarm}"));
    QCOMPARE(write(LiftHatch{"Roof", true}), std::string("SET {Type Hatch} {Name Roof} {Opcode LIFT} {Slowly true}"));
}

void tst_NewCommand::isRead() {
    Diagnostics diagnostics;
    for (const Command& command : {Command(SoundHorn{HornTune::Greeting, 440.0, -0.5}), Command(SoundHorn{}),
                                   Command(LiftHatch{"Roof", true}), Command(LiftHatch{})})
        QVERIFY(readCommand(write(command), diagnostics) == command);
    QVERIFY(diagnostics.empty());
}

void tst_NewCommand::isReadWithAllTolerance() {
    Diagnostics diagnostics;
    QVERIFY(readCommand("horn{pitch 1,5}{TUNE greeting", diagnostics) == Command(SoundHorn{HornTune::Greeting, 1.0}));
    QCOMPARE(diagnostics.size(), std::size_t(2));
    const std::string unknown = "HORN {Tune Waltz}";
    QVERIFY(readCommand(unknown, diagnostics) == Command(RawCommand{unknown}));
    QCOMPARE(diagnostics.size(), std::size_t(3));
}

void tst_NewCommand::isCompleted() {
    QCOMPARE(offered("ho"), std::string("HORN"));
    QCOMPARE(offered("HORN {"), std::string("Tune,Pitch,Aim"));
    QCOMPARE(offered("HORN {Tune A"), std::string("Alarm"));
    QCOMPARE(offered("SET {Type Hat"), std::string("Hatch"));
    QCOMPARE(offered("SET {Type Hatch} {Opcode L"), std::string("LIFT"));
    QCOMPARE(offered("SET {Type Hatch} {Slowly "), std::string("true,false"));
}

void tst_NewCommand::isChecked() {
    QCOMPARE(complaints("HORN {Tune Greeting} {Pitch 440} {Aim 0.5}"), std::string());
    QCOMPARE(complaints("HRON"),
             std::string("warning at column 1: HRON: no server knows this command. Did you mean HORN?"));
    QCOMPARE(complaints("HORN {Ptich 1}"),
             std::string("warning at column 7: the server does not know Ptich in HORN. Did you mean Pitch?"));
    QCOMPARE(complaints("HORN {Pitch high}"), std::string("error at column 13: Pitch needs a number"));
}

void tst_NewCommand::isExplained() {
    const CommandRule& horn = commandRules().back();
    QCOMPARE(horn.word, std::string_view("HORN"));
    QCOMPARE(horn.help, std::string_view("sounds the horn"));
    QCOMPARE(horn.example, std::string_view("HORN {Tune Alarm}"));
    QCOMPARE(horn.segments[2].help, std::string("rad; clockwise is positive"));
}

/// A SET that is not quite the new one is still any other SET.
void tst_NewCommand::isKnownAmongThoseWithItsWord() {
    Diagnostics diagnostics;
    QVERIFY(readCommand("SET {Type Hatch} {Opcode CLOSE}", diagnostics) == Command(SetItem{"Hatch", "CLOSE"}));
    QVERIFY(readCommand("SET {Type Hatch} {Opcode RESET}", diagnostics) == Command(ResetSensor{"Hatch"}));
    QVERIFY(diagnostics.empty());
}

void tst_NewCommand::theOthersStayAsTheyAre() {
    Diagnostics diagnostics;
    QCOMPARE(write(Step{}), std::string("STEP"));
    QVERIFY(readCommand("SET {Type Odometry} {Opcode RESET}", diagnostics) == Command(ResetSensor{"Odometry"}));
    QVERIFY(readCommand("WHISTLE", diagnostics) == Command(RawCommand{"WHISTLE"}));
    QVERIFY(diagnostics.empty());
}

USAR_TEST(tst_NewCommand)
#include "tst_new_command.moc"
