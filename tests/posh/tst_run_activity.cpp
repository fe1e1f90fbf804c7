#include <QObject>
#include <QTest>

#include "core/posh/language/plan_reader.h"
#include "core/posh/run/engine.h"
#include "core/posh/trace/run_activity.h"
#include "tests/doubles/stub_host.h"
#include "tests/suite/suite.h"

namespace tst_run_activity {

using namespace usar::posh;

namespace {

constexpr const char* plan = "((C work (elements ((near (trigger ((Distance 1.0 <))) Halt))"
                             "                     ((far Drive 2))))"
                             " (DC robot (drives ((rare (trigger ((Ready))) Beep (seconds 10)))"
                             "                   ((usual work)))))";

/// The activity of a run, kept while it goes on.
class Run : public TraceObserver {
public:
    Run() : engine(host, *compile(readPlan(plan).plan)) {
        host.setSense("Distance", 5.0);
        engine.watch(this);
    }
    void takeProgram(const std::shared_ptr<const Program>& program) override { activity.start(program); }
    void take(const TraceRecord& record, std::string_view text) override { activity.take(record, text); }

    const PlaceActivity& at(const std::string& name) const {
        const Program& program = *activity.program();
        for (Index place = 0; place < program.places.size(); ++place)
            if (nameOf(program, place) == name)
                return activity.places()[place];
        throw std::runtime_error("no place " + name);
    }

    usar::test::StubHost host;
    RunActivity activity;
    Engine engine;
};

} // namespace

class tst_RunActivity : public QObject {
    Q_OBJECT
private slots:
    void whatRunsRunsFromTheRootDown();
    void aSenseKeepsWhenItsVerdictChanged();
    void whoIsHeldBackSaysWhy();
    void endingsAreCounted();
    void anotherProgramBeginsAnew();
    void theBoardKeepsItsNewestValues();
};

void tst_RunActivity::theBoardKeepsItsNewestValues() {
    Run run;
    run.engine.cycle(Milliseconds(0));
    QVERIFY(run.activity.board().empty());
    for (int i = 0; i < 10; ++i)
        run.activity.take({.time_ms = 100 * i, .place = 4, .event = TraceEvent::Blackboard},
                          "lane: " + std::to_string(i) + " -> " + std::to_string(i + 1));
    run.activity.take({.time_ms = 1000, .place = 5, .event = TraceEvent::Blackboard}, "errand: nil -> 'home");
    run.activity.take({.time_ms = 1000, .place = 5, .event = TraceEvent::Blackboard}, "damaged");
    QCOMPARE(run.activity.board().size(), std::size_t(2));
    QCOMPARE(run.activity.board()[0].key, std::string("errand"));
    const BoardEntry& lane = run.activity.board()[1];
    QCOMPARE(lane.writes, std::uint64_t(10));
    QCOMPARE(lane.values.size(), BoardEntry::most_values);
    QVERIFY(lane.values.back() == (BoardEntry::Written{"10", 900, 4}));
    QCOMPARE(lane.values.front().value, std::string("3"));
    run.activity.start(run.activity.program()); // a plan that is replaced finds what was written
    QCOMPARE(run.activity.board().size(), std::size_t(2));
    run.activity.start(nullptr);
    QVERIFY(run.activity.board().empty());
}

void tst_RunActivity::whatRunsRunsFromTheRootDown() {
    Run run;
    run.engine.cycle(Milliseconds(0));
    for (const char* name : {"robot", "usual", "work", "far", "Drive"})
        QVERIFY2(run.at(name).running, name);
    for (const char* name : {"rare", "near", "Halt"})
        QVERIFY2(!run.at(name).running, name);
    run.host.setSense("Distance", 0.5);
    run.engine.cycle(Milliseconds(200));
    QVERIFY(run.at("Halt").running && !run.at("Drive").running);
    QCOMPARE(*run.at("Drive").last_active_ms, 0);
    QCOMPARE(*run.at("Halt").last_active_ms, 200);
}

void tst_RunActivity::aSenseKeepsWhenItsVerdictChanged() {
    Run run;
    run.engine.cycle(Milliseconds(0));
    run.host.setSense("Distance", 4.0);
    run.engine.cycle(Milliseconds(200));
    const PlaceAnswer far = *run.at("Distance").answer;
    QVERIFY(!far.holds);
    QCOMPARE(std::get<double>(far.value), 4.0);
    QCOMPARE(far.since_ms, 0);
    QCOMPARE(far.asked_ms, 200);
    run.host.setSense("Distance", 0.5);
    run.engine.cycle(Milliseconds(400));
    QVERIFY(run.at("Distance").answer->holds);
    QCOMPARE(run.at("Distance").answer->since_ms, 400);
}

void tst_RunActivity::whoIsHeldBackSaysWhy() {
    Run run;
    run.host.setSense("Ready", true);
    run.engine.cycle(Milliseconds(0)); // beeps
    run.engine.cycle(Milliseconds(1500));
    QCOMPARE(run.at("rare").hold_back, std::string("its frequency: 8.5 s left"));
    QCOMPARE(run.at("rare").skipped, std::uint64_t(1));
    run.engine.cycle(Milliseconds(1700));
    run.engine.cycle(Milliseconds(1900));
    QCOMPARE(run.at("far").hold_back, std::string("its retries are used up"));
    run.engine.cycle(Milliseconds(12'000));
    QCOMPARE(run.at("rare").hold_back, std::string());
}

void tst_RunActivity::endingsAreCounted() {
    Run run;
    run.engine.cycle(Milliseconds(0));
    run.host.setResult("Drive", ActResult::Failed);
    run.engine.cycle(Milliseconds(200));
    QCOMPARE(run.at("Drive").started, std::uint64_t(2));
    QCOMPARE(run.at("Drive").succeeded, std::uint64_t(1));
    QCOMPARE(run.at("Drive").failed, std::uint64_t(1));
    QCOMPARE(run.at("usual").succeeded, std::uint64_t(1));
    QCOMPARE(run.at("usual").failed, std::uint64_t(1));
}

void tst_RunActivity::anotherProgramBeginsAnew() {
    Run run;
    run.engine.cycle(Milliseconds(0));
    run.engine.replace(*compile(readPlan("((DC robot (drives ((only Drive)))))").plan));
    QCOMPARE(run.at("Drive").started, std::uint64_t(0));
    run.engine.cycle(Milliseconds(200));
    QVERIFY(run.at("only").running);
}

USAR_TEST(tst_RunActivity)

} // namespace tst_run_activity

#include "tst_run_activity.moc"
