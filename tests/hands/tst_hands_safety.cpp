// What no key and no dialog may do while a robot flies (window-review D5-D7).
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_safety {

using namespace usar::hands;

class tst_HandsSafety : public QObject {
    Q_OBJECT
private slots:
    void aLetterTypedElsewhereMovesNoRobot();
    void theStopWorksBesideAFileDialog();
    void quittingInFlightAsks();
};

/// The words at the top of Instruments.
static QString stateOf(const Program& program) {
    const auto status = program.read().find([](const Seen& seen) { return seen.name.startsWith("Status of "); });
    return status ? status->description : QString();
}

void tst_HandsSafety::aLetterTypedElsewhereMovesNoRobot() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    const auto send = program.read().find("push button", "Send");
    QVERIFY(send);
    program.desk().key("F4");
    program.desk().key("Tab"); // The focus is on a button now.
    program.desk().key("l");
    QVERIFY(!program.says("Land R1 where it is?", 1500));
    const auto map = program.read().find([](const Seen& seen) { return seen.name == "Map"; });
    QVERIFY(map);
    program.desk().click(map->at.bottomLeft() + QPoint(30, -60));
    program.desk().key("l");
    QVERIFY(program.says("Land R1 where it is?"));
    program.screenshot("land_question");
    QVERIFY(program.press("Cancel"));
    QVERIFY2(!stateOf(program).contains("landed"), qPrintable(stateOf(program)));
}

void tst_HandsSafety::theStopWorksBesideAFileDialog() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    program.desk().key("ctrl+o");
    QVERIFY(program.says("Open mission"));
    QVERIFY(program.press("Stop all robots"));
    QTRY_VERIFY2_WITH_TIMEOUT(stateOf(program).contains("stopped"), qPrintable(stateOf(program)), 15000);
}

void tst_HandsSafety::quittingInFlightAsks() {
    Program program;
    QVERIFY2(program.trouble().isEmpty(), qPrintable(program.trouble()));
    QVERIFY(program.spawnAt("PlayerStart", "R1"));
    QVERIFY(program.fly());
    program.desk().key("ctrl+q");
    QVERIFY(program.says("A robot is at work."));
    program.screenshot("quit_question");
    QVERIFY(!program.ended(500));
    QVERIFY(program.press("Stop and quit"));
    QCOMPARE(program.ended(20000), std::optional(0));
}

USAR_TEST(tst_HandsSafety)

} // namespace tst_hands_safety

#include "tst_hands_safety.moc"
