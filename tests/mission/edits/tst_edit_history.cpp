#include <QSignalSpy>
#include <QTest>

#include "core/mission/edits/edit_history.h"
#include "tests/suite/suite.h"

namespace tst_edit_history {

using usar::mission::Edit;
using usar::mission::EditHistory;
using usar::mission::valueEdit;

namespace {

/// Numbers that are edited by name.
struct Bench {
    EditHistory history;
    std::map<QString, int> values;

    void set(const QString& name, int value) {
        const int before = std::exchange(values[name], value);
        history.add(valueEdit<int>(name, "set " + name, before, value, [this, name](int now) { values[name] = now; }));
    }
};

} // namespace

class tst_EditHistory : public QObject {
    Q_OBJECT
private slots:
    void anEditIsUndoneAndRedone() {
        Bench bench;
        QVERIFY(!bench.history.canUndo() && !bench.history.canRedo());
        bench.set("a", 1);
        QCOMPARE(bench.history.undoText(), QString("set a"));
        bench.history.undo();
        QCOMPARE(bench.values["a"], 0);
        QCOMPARE(bench.history.redoText(), QString("set a"));
        bench.history.redo();
        QCOMPARE(bench.values["a"], 1);
        QVERIFY(!bench.history.canRedo());
        QVERIFY(bench.history.redoText().isEmpty());
    }

    void consecutiveEditsOfOneSubjectAreOneStep() {
        Bench bench;
        for (int value = 1; value <= 500; ++value)
            bench.set("a", value);
        QCOMPARE(bench.history.stack()->count(), 1);
        bench.history.undo();
        QCOMPARE(bench.values["a"], 0);
        bench.history.redo();
        QCOMPARE(bench.values["a"], 500);
    }

    void whatEndsAStep_data() {
        using Do = std::function<void(Bench&)>;
        QTest::addColumn<Do>("between");
        QTest::addColumn<int>("steps");
        QTest::newRow("nothing") << Do([](Bench&) {}) << 1;
        QTest::newRow("the end of a drag") << Do([](Bench& bench) { bench.history.endStep(); }) << 2;
        QTest::newRow("an edit of something else") << Do([](Bench& bench) { bench.set("b", 1); }) << 3;
        QTest::newRow("a command") << Do([](Bench& bench) { bench.history.note("land R1"); }) << 3;
        QTest::newRow("an edit that is a step of its own")
            << Do([](Bench& bench) { bench.history.addStep(valueEdit<int>("a", "replace a", 1, 3, [](int) {})); }) << 3;
        QTest::newRow("undo and redo") << Do([](Bench& bench) {
            bench.history.undo();
            bench.history.redo();
        }) << 2;
        QTest::newRow("that the thing is gone")
            << Do([](Bench& bench) { bench.history.lock([](const QString&) { return true; }, "gone"); }) << 2;
    }

    void whatEndsAStep() {
        QFETCH(std::function<void(Bench&)>, between);
        QFETCH(int, steps);
        Bench bench;
        bench.set("a", 1);
        between(bench);
        bench.set("a", 2);
        QCOMPARE(bench.history.stack()->count(), steps);
    }

    void anEditThatEndsWhereItBeganLeavesNoStep() {
        Bench bench;
        bench.set("a", 5);
        bench.history.endStep();
        bench.set("a", 7);
        bench.set("a", 5);
        QCOMPARE(bench.history.stack()->count(), 1);
        bench.set("a", 5); // Nothing has changed.
        QCOMPARE(bench.history.stack()->count(), 1);
        bench.history.undo();
        QCOMPARE(bench.values["a"], 0);
    }

    void aCommandThatWasSentIsPassedOver() {
        Bench bench;
        bench.set("a", 1);
        bench.history.note("start R1");
        QCOMPARE(bench.history.undoText(), QString("set a"));
        QVERIFY(bench.history.reasonOf(0).isEmpty());
        QVERIFY(bench.history.reasonOf(1).contains("cannot be undone"));
        bench.history.undo();
        QCOMPARE(bench.values["a"], 0);
        QVERIFY(!bench.history.canUndo());
        bench.history.redo();
        QCOMPARE(bench.values["a"], 1);
    }

    void aCommandTakesAwayNoRedo() {
        Bench bench;
        bench.set("a", 1);
        bench.history.undo();
        bench.history.note("start R1");
        QVERIFY(bench.history.canRedo());
        bench.set("b", 1);
        QVERIFY(!bench.history.canRedo());
    }

    void commandsAloneCannotBeUndone() {
        EditHistory history;
        history.note("start R1");
        QCOMPARE(history.stack()->count(), 1);
        QVERIFY(!history.canUndo());
        history.undo();
        QCOMPARE(history.stack()->index(), 1);
    }

    void whatIsGoneStaysAsItIs() {
        Bench bench;
        bench.set("robot 1/a", 1);
        bench.set("robot 2/a", 1);
        QSignalSpy changes(&bench.history, &EditHistory::changed);
        bench.history.lock([](const QString& subject) { return subject.startsWith("robot 2/"); }, "it is gone");
        QCOMPARE(changes.size(), 1);
        QCOMPARE(bench.history.reasonOf(1), QString("it is gone"));
        bench.history.undo();
        QCOMPARE(bench.values["robot 1/a"], 0);
        QCOMPARE(bench.values["robot 2/a"], 1);
    }

    void theViewsReportOfAnUndoIsNoEdit() {
        EditHistory history;
        const auto report = [&] { history.add(valueEdit<int>("a", "echo", 1, 2, [](int) {})); };
        history.add(Edit{"a", "edit", report, report});
        history.undo();
        QCOMPARE(history.stack()->count(), 1);
        QVERIFY(history.canRedo());
        history.redo();
        QCOMPARE(history.stack()->count(), 1);
    }

    void aClickIntoTheListGoesThere() {
        Bench bench;
        for (const char* const name : {"a", "b", "c"})
            bench.set(name, 1);
        bench.history.stack()->setIndex(1); // As QUndoView does.
        QCOMPARE(bench.values["a"] + bench.values["b"] + bench.values["c"], 1);
        bench.history.stack()->setIndex(3);
        QCOMPARE(bench.values["a"] + bench.values["b"] + bench.values["c"], 3);
    }
};

USAR_TEST(tst_EditHistory)

} // namespace tst_edit_history

#include "tst_edit_history.moc"
