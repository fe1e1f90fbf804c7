// Any moment of a run, from its trace.
#include <algorithm>

#include <QTest>

#include "core/base/random.h"
#include "core/posh/language/plan_writer.h"
#include "core/posh/trace/run_history.h"
#include "core/posh/trace/trace_encoder.h"
#include "tests/posh/random_plan.h"
#include "tests/posh/scripted_host.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_run_history {

using namespace usar;
using namespace usar::posh;

namespace {

/// The activity behind each cycle as it happened, and the trace in one piece for each.
class Recorded final : public TraceObserver {
public:
    Recorded(const Plan& plan, std::uint64_t seed, std::uint64_t cycles) : encoder_(writePlan(plan)) {
        ScriptedHost host({.seed = seed});
        Engine engine(host, *compile(plan));
        engine.watch(this);
        for (std::uint64_t cycle = 1; cycle <= cycles; ++cycle) {
            host.begin(cycle);
            engine.cycle(Milliseconds(200 * cycle));
            activities.push_back(activity_.places());
            pieces.push_back(encoder_.takeBytes());
        }
        engine.watch(nullptr);
    }
    void takeProgram(const std::shared_ptr<const Program>& program) override {
        if (program)
            activity_.start(program);
        encoder_.takeProgram(program);
    }
    void take(const TraceRecord& record, std::string_view text) override {
        activity_.take(record, text);
        encoder_.take(record, text);
    }

    std::vector<std::vector<PlaceActivity>> activities;
    std::vector<std::string> pieces;

private:
    TraceEncoder encoder_;
    RunActivity activity_;
};

Plan somePlan(std::uint64_t number) {
    Random random = seeded(7, number);
    return doubles::randomPlan(random);
}

/// A run that is heard of while it goes on.
class Watched {
public:
    explicit Watched(const std::string& plan) : encoder_(plan), engine(host, programOf(plan)) {
        engine.watch(&encoder_);
    }
    ~Watched() { engine.watch(nullptr); }
    void cycle() {
        engine.cycle(Milliseconds(200 * ++cycles_));
        history.append(encoder_.takeBytes());
    }
    void replace(const std::string& plan, bool same_shape) {
        encoder_.setPlanText(plan);
        same_shape ? engine.retune(programOf(plan)) : engine.replace(programOf(plan));
    }
    static const PlaceActivity& placeIn(const RunActivity& activity, const char* names) {
        return activity.places().at(findPlace(*activity.program(), {}, names));
    }

    TrialHost host;
    RunHistory history;

private:
    TraceEncoder encoder_;
    int cycles_ = 0;

public:
    Engine engine;
};

} // namespace

class tst_RunHistory : public QObject {
    Q_OBJECT
private slots:
    void everyMomentIsAsItWas();
    void aLongRunIsKnownAtEveryMoment();
    void aLargePlanIsKnownAtEveryMomentToo();
    void timesFindTheirMoments();
    void epochsAreStepsWithinACycle();
    void aPlanThatWasKeptGoesOnCounting();
    void aPlanThatWasReplacedIsThatOfItsTime();
    void anotherTraceIsAnotherRun();
};

void tst_RunHistory::everyMomentIsAsItWas() {
    for (std::uint64_t number = 0; number < 60; ++number) {
        const Recorded run(somePlan(number), number, 50);
        RunHistory history;
        for (const std::string& piece : run.pieces)
            history.append(piece);
        QCOMPARE(history.moments().size(), std::size_t(50));
        for (const std::size_t moment : {49, 0, 7, 8, 6, 31, 49, 1})
            QVERIFY(history.at(moment).places() == run.activities[moment]);
        QVERIFY(history.newest().places() == run.activities.back());
    }
}

void tst_RunHistory::aLongRunIsKnownAtEveryMoment() {
    constexpr std::size_t cycles = 40'000; // more than are remembered one by one
    const Recorded run(somePlan(3), 3, cycles);
    RunHistory history;
    for (const std::string& piece : run.pieces)
        history.append(piece);
    for (const std::size_t moment : {0, 255, 256, 257, 16'383, 16'384, 30'000, 29'999, 39'998, 39'999})
        QVERIFY(history.at(moment).places() == run.activities[moment]);
}

void tst_RunHistory::aLargePlanIsKnownAtEveryMomentToo() {
    std::string plan = "((DC d (drives";
    for (int drive = 0; drive < 16'000; ++drive) // of which few moments are remembered
        plan += " ((d" + std::to_string(drive) + " walk (seconds 1)))";
    Watched run(plan + ")))");
    std::vector<std::uint64_t> started;
    for (int cycle = 0; cycle < 2600; ++cycle) {
        run.cycle();
        started.push_back(run.history.newest().places()[1].started);
    }
    for (const std::size_t moment : {0, 255, 256, 700, 2559, 2560, 2599})
        QCOMPARE(run.history.at(moment).places()[1].started, started[moment]);
}

void tst_RunHistory::timesFindTheirMoments() {
    const Recorded run(somePlan(1), 1, 5);
    RunHistory history;
    std::size_t bytes = 0;
    for (const std::string& piece : run.pieces) {
        history.append(piece);
        bytes += piece.size();
        QCOMPARE(history.moments().back().bytes, bytes);
    }
    QCOMPARE(history.momentAt(0), std::size_t(0));
    QCOMPARE(history.momentAt(200), std::size_t(0));
    QCOMPARE(history.momentAt(399), std::size_t(0));
    QCOMPARE(history.momentAt(400), std::size_t(1));
    QCOMPARE(history.momentAt(9999), std::size_t(4));
}

void tst_RunHistory::epochsAreStepsWithinACycle() {
    Watched run("((AP p (note walk)) (DC d (drives ((first p)) ((second rest)))))");
    run.host.setResult("note", ActResult::Finished);
    run.host.setResult("walk", ActResult::Running);
    run.cycle();
    run.cycle();
    const char* const note = "d ▸ first ▸ p ▸ note";
    const char* const walk = "d ▸ first ▸ p ▸ walk";
    QCOMPARE(run.history.epochCount(0), std::size_t(2));
    QCOMPARE(run.history.epochCount(1), std::size_t(1));
    const RunActivity first = run.history.at(0, 0);
    QCOMPARE(Watched::placeIn(first, note).succeeded, std::uint64_t(1));
    QVERIFY(!Watched::placeIn(first, walk).running);
    QVERIFY(Watched::placeIn(run.history.at(0, 1), walk).running);
    QVERIFY(run.history.at(0, 1).places() == run.history.at(0).places());
    QVERIFY(run.history.at(1, 9).places() == run.history.newest().places());
}

void tst_RunHistory::aPlanThatWasKeptGoesOnCounting() {
    Watched run("((DC d (drives ((a (trigger ((near 1 <))) stop)) ((b walk)))))");
    run.cycle();
    run.cycle();
    const std::string tuned = "((DC d (drives ((a (trigger ((near 2 <))) stop)) ((b walk)))))";
    run.replace(tuned, true);
    run.cycle();
    QCOMPARE(Watched::placeIn(run.history.newest(), "d ▸ b").started, std::uint64_t(3));
    QCOMPARE(run.history.planText(2), tuned);
    QVERIFY(run.history.planText(1) != tuned);
}

void tst_RunHistory::aPlanThatWasReplacedIsThatOfItsTime() {
    Watched run("((DC d (drives ((b walk)))))");
    run.cycle();
    run.replace("((DC d (drives ((a stop)) ((b walk)))))", false);
    run.cycle();
    QCOMPARE(run.history.at(0).program()->drives.size(), std::size_t(1));
    QCOMPARE(run.history.at(1).program()->drives.size(), std::size_t(2));
    QCOMPARE(Watched::placeIn(run.history.newest(), "d ▸ b").started, std::uint64_t(0));
}

void tst_RunHistory::anotherTraceIsAnotherRun() {
    RunHistory history;
    for (const std::uint64_t number : {1, 2}) {
        const Recorded run(somePlan(number), number, 10);
        for (const std::string& piece : run.pieces)
            history.append(piece);
        QCOMPARE(history.moments().size(), std::size_t(10));
        QVERIFY(history.newest().places() == run.activities.back());
    }
    history.clear();
    QVERIFY(history.moments().empty() && !history.newest().program());
}

USAR_TEST(tst_RunHistory)

} // namespace tst_run_history

#include "tst_run_history.moc"
