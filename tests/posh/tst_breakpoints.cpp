// Where runs are told to stop.
#include <QTest>

#include "core/posh/run/breakpoints.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_breakpoints {

using namespace usar;
using namespace usar::posh;

namespace {

const std::string plan = "((C c (elements ((fast (trigger ((near(2) 1 <))) run)) ((slow walk)))) "
                         "(DC d (drives ((high (trigger ((danger))) dodge)) ((work c)))))";

/// Cycles (of the ten) in which a breakpoint hits: danger in the fifth, near from the third to the seventh.
QList<int> cyclesOf(const Breakpoint& breakpoint) {
    TrialHost host;
    host.setResult("walk", ActResult::Running);
    host.setResult("run", ActResult::Running);
    Engine engine(host, programOf(plan));
    Breakpoints breakpoints;
    if (!breakpoints.add(breakpoint))
        return {-1};
    engine.watch(&breakpoints);
    QList<int> cycles;
    for (int cycle = 1; cycle <= 10; ++cycle) {
        host.setSense("danger", cycle == 5);
        host.setSense("near", cycle >= 3 && cycle <= 7 ? 0.5 : 4.0);
        engine.cycle(Milliseconds(200 * cycle));
        for (std::size_t hits = breakpoints.takeHits().size(); hits > 0; --hits)
            cycles << cycle;
    }
    engine.watch(nullptr);
    return cycles;
}

Breakpoint at(const std::string& names, BreakOn on) {
    Breakpoint breakpoint;
    breakpoint.names = names;
    breakpoint.on = on;
    return breakpoint;
}

} // namespace

class tst_Breakpoints : public QObject {
    Q_OBJECT
private slots:
    void hitWhere_data();
    void hitWhere();
    void conditionsAreOfTheAnswersThatTheRunGot();
    void hitsAreCountedAndMayBeTheLast();
    void aBreakpointFindsItsPlaceInAChangedPlan();
    void aKeyOfTheBlackboardIsWatched_data();
    void aKeyOfTheBlackboardIsWatched();
    void conditionsThatAreNoneAreRejected();
};

void tst_Breakpoints::hitWhere_data() {
    QTest::addColumn<QByteArray>("names");
    QTest::addColumn<int>("on");
    QTest::addColumn<QList<int>>("cycles");
    const auto row = [](const char* claim, const char* names, BreakOn on, const QList<int>& cycles) {
        QTest::newRow(claim) << QByteArray(names) << static_cast<int>(on) << cycles;
    };
    row("before a drive", "d ▸ work", BreakOn::Before, {1, 6});
    row("after a drive", "d ▸ work", BreakOn::After, {5});
    row("before an element, each time it is chosen", "d ▸ work ▸ c ▸ fast", BreakOn::Before, {3, 4, 6, 7});
    row("before an act", "d ▸ work ▸ c ▸ slow ▸ walk", BreakOn::Before, {1, 8});
    row("after an act", "d ▸ work ▸ c ▸ slow ▸ walk", BreakOn::After, {3});
    row("when an act is interrupted", "d ▸ work ▸ c ▸ fast ▸ run", BreakOn::Interruption, {5, 8});
    row("when a drive is interrupted", "d ▸ work", BreakOn::Interruption, {5});
    row("when a sense is asked", "d ▸ work ▸ c ▸ fast ▸ near", BreakOn::Before, {1, 2, 3, 4, 6, 7, 8, 9, 10});
    row("when a verdict changes", "d ▸ work ▸ c ▸ fast ▸ near", BreakOn::VerdictChange, {3, 8});
    row("on a result that never comes", "d ▸ work ▸ c ▸ slow ▸ walk", BreakOn::Result, {});
    row("where the plan has no place", "d ▸ play", BreakOn::Before, {});
}

void tst_Breakpoints::hitWhere() {
    QFETCH(QByteArray, names);
    QFETCH(int, on);
    QFETCH(QList<int>, cycles);
    QCOMPARE(cyclesOf(at(names.toStdString(), static_cast<BreakOn>(on))), cycles);
}

void tst_Breakpoints::conditionsAreOfTheAnswersThatTheRunGot() {
    Breakpoint breakpoint = at("d ▸ work ▸ c ▸ slow", BreakOn::Before);
    breakpoint.condition = "(near(2) 3 >) (danger false)";
    QCOMPARE(cyclesOf(breakpoint), (QList<int>{1, 2, 8, 9, 10}));
    breakpoint.condition = "(danger)";
    QCOMPARE(cyclesOf(breakpoint), QList<int>());
    breakpoint.condition = "(never-asked false)";
    QCOMPARE(cyclesOf(breakpoint), QList<int>());
}

void tst_Breakpoints::hitsAreCountedAndMayBeTheLast() {
    Breakpoint breakpoint = at("d ▸ work ▸ c ▸ slow", BreakOn::Before);
    breakpoint.skip = 3;
    QCOMPARE(cyclesOf(breakpoint), (QList<int>{9, 10}));
    breakpoint.once = true;
    QCOMPARE(cyclesOf(breakpoint), QList<int>{9});
    breakpoint.enabled = false;
    QCOMPARE(cyclesOf(breakpoint), QList<int>());
}

void tst_Breakpoints::aBreakpointFindsItsPlaceInAChangedPlan() {
    Breakpoints breakpoints;
    breakpoints.takeProgram(programOf(plan));
    const auto number = breakpoints.add(at("d ▸ work", BreakOn::Before));
    QVERIFY(number);
    const Index before = breakpoints.placeOf(*number);
    breakpoints.takeProgram(programOf("((DC d (drives ((new sing)) ((high dodge)) ((work walk)))))"));
    QVERIFY(breakpoints.placeOf(*number) != before);
    QCOMPARE(breakpoints.all().at(*number).path, std::string("/P:0/DC:0/DE:2"));
    breakpoints.takeProgram(programOf("((DC d (drives ((high dodge)))))"));
    QCOMPARE(breakpoints.placeOf(*number), nowhere);
    breakpoints.remove(*number);
    QVERIFY(breakpoints.all().empty());
}

void tst_Breakpoints::aKeyOfTheBlackboardIsWatched_data() {
    QTest::addColumn<QByteArray>("key");
    QTest::addColumn<QByteArray>("condition");
    QTest::addColumn<QList<int>>("writes");
    const auto row = [](const char* claim, const char* key, const char* condition, const QList<int>& writes) {
        QTest::newRow(claim) << QByteArray(key) << QByteArray(condition) << writes;
    };
    row("whenever it is written", "lane", "", {0, 1, 3, 5});
    row("another key", "note", "", {2, 4});
    row("where its value is large enough", "lane", "(lane 3 >=)", {3, 5});
    row("with one value", "note", "(note \"a: 1 -> 2\")", {4});
    row("where another key has a value", "lane", "(note \"b\")", {3});
    row("a key that nobody writes", "height", "", {});
}

void tst_Breakpoints::aKeyOfTheBlackboardIsWatched() {
    QFETCH(QByteArray, key);
    QFETCH(QByteArray, condition);
    QFETCH(QList<int>, writes);
    Breakpoints breakpoints;
    breakpoints.takeProgram(programOf(plan));
    Breakpoint breakpoint = at("d", BreakOn::Written);
    breakpoint.key = key.toStdString();
    breakpoint.condition = condition.toStdString();
    QVERIFY(breakpoints.add(breakpoint));
    QList<int> hits;
    int number = 0;
    for (const char* const text : {"lane: nil -> 1", "lane: 1 -> 2", "note: nil -> \"b\"", "lane: 2 -> 3",
                                   "note: \"b\" -> \"a: 1 -> 2\"", "lane: 3 -> 4", "no change at all"}) {
        breakpoints.take({.place = 3, .event = TraceEvent::Blackboard}, text);
        for (const BreakHit& hit : breakpoints.takeHits()) {
            QCOMPARE(hit.text, std::string(text));
            hits << number;
        }
        ++number;
    }
    QCOMPARE(hits, writes);
}

void tst_Breakpoints::conditionsThatAreNoneAreRejected() {
    Breakpoints breakpoints;
    for (const char* const text : {"(near", "near 1 <", "(near 1 <))", "(near($x))", ")) a)) ((b c"}) {
        Breakpoint breakpoint = at("d ▸ work", BreakOn::Before);
        breakpoint.condition = text;
        QVERIFY2(!breakpoints.add(breakpoint), text);
    }
}

USAR_TEST(tst_Breakpoints)

} // namespace tst_breakpoints

#include "tst_breakpoints.moc"
