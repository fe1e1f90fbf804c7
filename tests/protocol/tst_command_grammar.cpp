#include <algorithm>

#include <QTest>

#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "corpus.h"
#include "tests/suite/suite.h"

namespace tst_command_grammar {

using namespace usar;
using namespace usar::protocol;

class tst_CommandGrammar : public QObject {
    Q_OBJECT
private slots:
    void everyExampleIsWithoutFault();
    void knowsEveryWordAndKeyThatClientsSend();
    void offersWhatMayStandAtTheCursor_data();
    void offersWhatMayStandAtTheCursor();
    void replacesWhatIsBegun();
    void aKeyIsOfferedOnceUnlessItRepeats();
    void saysWhatAServerWouldNotUnderstand_data();
    void saysWhatAServerWouldNotUnderstand();
    void everyPrefixOfEveryLineIsCheckedAndCompleted();
};

void tst_CommandGrammar::everyExampleIsWithoutFault() {
    for (const CommandRule& rule : commandRules()) {
        QVERIFY2(!rule.help.empty(), rule.word.data());
        QVERIFY2(rule.example.starts_with(rule.word), rule.word.data());
        QVERIFY2(checkCommand(rule.example).empty(), rule.example.data());
        Diagnostics diagnostics;
        readCommand(rule.example, diagnostics);
        QVERIFY2(diagnostics.empty(), rule.example.data());
    }
}

void tst_CommandGrammar::knowsEveryWordAndKeyThatClientsSend() {
    for (const corpus::Line& line : corpus::commandLines()) {
        if (line.source.find("not the bot port") != std::string::npos ||
            line.source.find("our own") != std::string::npos)
            continue;
        for (const Diagnostic& diagnostic : checkCommand(line.text))
            QVERIFY2(diagnostic.message.find("not know") == std::string::npos &&
                         diagnostic.message.find("no server") == std::string::npos,
                     (line.place + ": " + diagnostic.message).c_str());
    }
}

void tst_CommandGrammar::offersWhatMayStandAtTheCursor_data() {
    QTest::addColumn<QByteArray>("before");
    QTest::addColumn<QByteArray>("offered");
    const auto row = [](const char* name, const char* before, const char* offered) {
        QTest::newRow(name) << QByteArray(before) << QByteArray(offered);
    };
    row("a command begun", "GETC", "GETCONF,GETCLOSESTPATHNODE");
    row("a command begun in lower case", "mul", "MULTIDRIVE");
    row("a whole command word", "STEP", "STEP");
    row("segments after a command word", "TRACE ", "{On,{Interval,{Color");
    row("segments after a segment", "TRACE {On true} ", "{Interval,{Color");
    row("segments right after a brace", "TRACE {On true}{Color Red}", "{Interval");
    row("keys after a brace", "TRACE {", "On,Interval,Color");
    row("keys begun", "DRIVE {r", "RotationalVelocity,RollAngle,Right,RearSteer,Rudder");
    row("keys of the second segment", "MOVE {Action New} {", "Type,Location,Pathnode");
    row("words after a key", "LOCKSTEP {On ", "true,false");
    row("words begun", "CONTROL {Type Kill", "Kill,KillAll");
    row("words begun in another case", "DRIVE {Left 1} {NORMALIZED T", "true");
    row("no words for a free value", "DRIVE {Left ", "");
    row("nothing for an unknown command", "FLY {", "");
    row("nothing for an unknown key", "DRIVE {Sideways ", "");
    row("any joint is nothing to offer", "MULTIDRIVE {FR", "FRFlipper");
    row("no segments where there are none", "STEP ", "");
}

void tst_CommandGrammar::offersWhatMayStandAtTheCursor() {
    QFETCH(QByteArray, before);
    QFETCH(QByteArray, offered);
    QByteArrayList texts;
    for (const Completion& completion : completionsAt(before.toStdString(), static_cast<std::size_t>(before.size())))
        texts << QByteArray::fromStdString(completion.text);
    QCOMPARE(texts.join(','), offered);
}

void tst_CommandGrammar::replacesWhatIsBegun() {
    QVERIFY(completionsAt("  dri", 5) ==
            (std::vector<Completion>{{"DRIVE", "moves the robot or one joint until the next DRIVE", 2}}));
    QCOMPARE(completionsAt("DRIVE {Le", 9).at(0).from, std::size_t{7});
    QCOMPARE(completionsAt("DRIVE { Le", 10).at(0).from, std::size_t{8});
    QCOMPARE(completionsAt("LOCKSTEP {On   t", 16).at(0).from, std::size_t{15});
    QCOMPARE(completionsAt("LOCKSTEP ", 9).at(0).from, std::size_t{9});
    // In the middle of a line only what is before the cursor counts.
    QCOMPARE(completionsAt("DRIVE {Left 1}", 2).at(0).text, std::string("DRIVE"));
    QCOMPARE(completionsAt("DRIVE {Left 1}", 9).at(0).text, std::string("Left"));
    QCOMPARE(completionsAt("DR", 99).at(0).from, std::size_t{0});
}

void tst_CommandGrammar::aKeyIsOfferedOnceUnlessItRepeats() {
    const auto offers = [](std::string_view line, std::string_view text) {
        return std::ranges::any_of(completionsAt(line, line.size()),
                                   [text](const Completion& completion) { return completion.text == text; });
    };
    QVERIFY(!offers("MISPKG {name Arm} {", "Name"));
    QVERIFY(offers("MISPKG {Name Arm} {Link 1} {Value 2} {", "Link"));
}

void tst_CommandGrammar::saysWhatAServerWouldNotUnderstand_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("expected");
    const auto row = [](const char* name, const char* line, const char* expected) {
        QTest::newRow(name) << QByteArray(line) << QByteArray(expected);
    };
    row("nothing", "", "");
    row("spaces only", "  ", "");
    row("good", "drive {LEFT 1}{Right -.5} {Light TRUE}", "");
    row("a name of any joint", "MULTIDRIVE {Neck 0.5}", "");
    row("a number without a key", "SET {Type Camera} {Opcode Zoom} {0.785398}", "");
    row("a command misspelt", " drvie {Left 1}",
        "warning at column 2: drvie: no server knows this command. Did you mean DRIVE?");
    row("a key misspelt", "DRIVE {Lfet 1}",
        "warning at column 8: the server does not know Lfet in DRIVE. Did you mean Left?");
    row("a word misspelt", "CONTROL {Type Kil} {Name a}",
        "warning at column 15: Type does not take Kil. Did you mean Kill?");
    row("no closing brace", "DRIVE {Left 1", "error at column 7: the closing brace is missing");
    row("no closing brace in the middle", "DRIVE {Left 1 {Right 1}",
        "warning at column 14: a server reads 1 and leaves out ' {Right 1'; "
        "error at column 15: the closing brace of the segment before is missing");
    row("no opening brace", "DRIVE Left 1}",
        "warning at column 1: DRIVE Left 1}: no server knows this command. Did you mean DRIVE?; "
        "error at column 13: the opening brace is missing");
    row("a word for a number", "DRIVE {Left fast}", "error at column 13: Left needs a number");
    row("no value", "DRIVE {Left}", "error at column 8: Left needs a number");
    row("a comma for a point", "DRIVE {Left 1,5}", "warning at column 14: a server reads 1 and leaves out ',5'");
    row("a word in a vector", "INIT {Location 1,two,3}", "error at column 18: Location needs a number");
    row("a hole in a vector", "INIT {Location 1,,3}",
        "error at column 16: Location has a comma without a number beside it");
    row("an empty vector", "INIT {Location}", "error at column 7: Location needs numbers");
}

void tst_CommandGrammar::saysWhatAServerWouldNotUnderstand() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, expected);
    QByteArrayList said;
    for (const Diagnostic& diagnostic : checkCommand(line.toStdString()))
        said << QByteArray::fromStdString(toText(diagnostic));
    QCOMPARE(said.join("; "), expected);
}

void tst_CommandGrammar::everyPrefixOfEveryLineIsCheckedAndCompleted() {
    for (const corpus::Line& line : corpus::commandLines()) {
        for (std::size_t length = 0; length <= line.text.size(); ++length) {
            const std::string prefix = line.text.substr(0, length);
            for (const Diagnostic& diagnostic : checkCommand(prefix))
                QVERIFY2(diagnostic.offset <= length, line.place.c_str());
            for (const Completion& completion : completionsAt(prefix, length))
                QVERIFY2(completion.from <= length && !completion.text.empty(), line.place.c_str());
        }
    }
}

USAR_TEST(tst_CommandGrammar)

} // namespace tst_command_grammar

#include "tst_command_grammar.moc"
