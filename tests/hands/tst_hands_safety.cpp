// What no stray key and no dialog may do while a robot flies.
#include <QTest>

#include "tests/hands/program.h"
#include "tests/suite/suite.h"

namespace tst_hands_safety {

using namespace usar::hands;

class tst_HandsSafety : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void lettersTypedElsewhereCommandNothing_data();
    void lettersTypedElsewhereCommandNothing();
    void aLetterOnTheMapAsksFirst();
    void allRobotsCanBeStoppedBesideAFileDialog();

private:
    /// True if R2 flies; it is made to if it does not.
    bool flies();
    /// What differs from a flight of R2 that nobody disturbs; empty if nothing does.
    QString disturbance() const;

    Program program_;
};

void tst_HandsSafety::initTestCase() {
    QVERIFY2(program_.trouble().isEmpty(), qPrintable(program_.trouble()));
    QVERIFY(program_.spawnByKeys("HillTop", "R1"));
    QVERIFY(program_.spawnByKeys("PlayerStart", "R2"));
}

bool tst_HandsSafety::flies() {
    const QString row = program_.row("R2");
    return (row.contains("drives") && !row.contains("nobody drives")) || program_.fly();
}

QString tst_HandsSafety::disturbance() const {
    QStringList found;
    const QString row = program_.row("R2");
    for (const QString& word : QStringList{"land", "paus", "you drive", "done", "ended early"})
        if (row.contains(word))
            found << row;
    for (const Seen& seen : program_.read().all([](const Seen& one) { return one.checked() || one.selected(); })) {
        if (seen.role == "check box" && seen.name.startsWith("Draw"))
            found << "the area tool is on";
        if (seen.role == "list item" && seen.name.startsWith("R1,"))
            found << "R1 is selected";
    }
    for (const Seen& seen : program_.read().all([](const Seen& one) { return one.name.startsWith("Land R2"); }))
        found << seen.name;
    return found.join("; ");
}

void tst_HandsSafety::lettersTypedElsewhereCommandNothing_data() {
    QTest::addColumn<QString>("role"); // of what has the focus
    QTest::newRow("on a button") << "push button";
    QTest::newRow("in a text") << "text";
}

void tst_HandsSafety::lettersTypedElsewhereCommandNothing() {
    QFETCH(QString, role);
    QVERIFY(flies());
    QCOMPARE(disturbance(), QString());
    program_.desk().key("F4"); // the line for raw commands
    QVERIFY(program_.read().find([](const Seen& seen) { return seen.name == "Raw command" && seen.focused(); }));
    if (role != "text")
        QVERIFY2(program_.tabTo(role), "Tab does not reach one.");
    for (const char* const letter : {"g", "p", "a", "1", "l"}) {
        program_.desk().key(letter);
        QVERIFY2(disturbance().isEmpty(), qPrintable(QString(letter) + ": " + disturbance()));
    }
    program_.desk().key("F4");
    program_.desk().key("ctrl+a");
    program_.desk().type("x");
    const auto line = program_.read().find("text", "Raw command");
    QVERIFY(line);
    QTRY_COMPARE_WITH_TIMEOUT(program_.read().textOf(*line), QStringLiteral("x"), 30000);
    // All keys were taken by now. Had one of them moved the robot, it would show in the next seconds.
    const QString then = program_.figure("elapsed");
    QTRY_VERIFY_WITH_TIMEOUT(program_.figure("elapsed") > then, 30000);
    QCOMPARE(disturbance(), QString());
    program_.desk().key("BackSpace");
}

void tst_HandsSafety::aLetterOnTheMapAsksFirst() {
    QVERIFY(flies());
    QVERIFY(program_.lookAtWorld());
    program_.desk().key("l");
    QVERIFY(program_.says("Land R2 here and now?"));
    program_.screenshot("land_question");
    QVERIFY2(!program_.row("R2").contains("land"), qPrintable(program_.row("R2")));
    QVERIFY(program_.press("Cancel"));
    QTRY_COMPARE_WITH_TIMEOUT(disturbance(), QString(), 30000);
}

void tst_HandsSafety::allRobotsCanBeStoppedBesideAFileDialog() {
    QVERIFY(flies());
    program_.desk().key("ctrl+o");
    QTRY_VERIFY_WITH_TIMEOUT(!program_.desk().windows("Open mission").isEmpty(), 30000);
    program_.screenshot("file_dialog");
    QVERIFY(program_.press("Stop all robots"));
    QTRY_VERIFY2_WITH_TIMEOUT(program_.row("R2").contains("ended early"), qPrintable(program_.row("R2")), 15000);
    QVERIFY(!program_.desk().windows("Open mission").isEmpty());
}

USAR_TEST(tst_HandsSafety)

} // namespace tst_hands_safety

#include "tst_hands_safety.moc"
