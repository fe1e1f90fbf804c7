// A plan as a behavior: what its acts send, and what happens when plan, acts or people want it otherwise.
#include <QTest>

#include "core/agent/behavior_host.h"
#include "core/agent/posh_behavior.h"
#include "core/posh/trace_file.h"
#include "core/posh/trace_text.h"
#include "tests/agent/toy_rover.h"

using namespace usar;
using namespace usar::agent;
using usar::test::ToyRover;

namespace {

const std::string drive_on = "((DC rover (goal ((Arrived))) (drives ((danger (trigger ((Closer(0.5)))) Halt)) "
                             "((work DriveFor(10))))))";

/// A behavior in its host, fed with STA lines at 5 Hz.
class Run {
public:
    explicit Run(const std::string& plan) {
        auto body = std::make_unique<ToyRover>();
        rover = body.get();
        auto made = PoshBehavior::make({"rover.lap", plan, test::toyRegistry(), std::move(body), {}});
        if (!made)
            throw std::runtime_error(made.error().text());
        behavior = made->get();
        host = std::make_unique<BehaviorHost>(*std::move(made), "toy/posh");
    }
    BehaviorHost::Output tick() {
        protocol::RobotState state;
        state.time = Seconds(0.2 * static_cast<double>(++ticks_));
        return host->receive({LineNumber{ticks_}, "", state, {}});
    }

    ToyRover* rover = nullptr;
    PoshBehavior* behavior = nullptr;
    std::unique_ptr<BehaviorHost> host;

private:
    std::uint64_t ticks_ = 0;
};

protocol::Command wheels(double left, double right) {
    return protocol::SkidDrive{left, right};
}

template <class T>
std::vector<T> published(const BehaviorHost::Output& output) {
    std::vector<T> found;
    for (const Published& value : output.published)
        if (const auto* const one = std::get_if<T>(&value))
            found.push_back(*one);
    return found;
}

std::size_t count(const std::vector<std::string>& calls, const std::string& what) {
    return static_cast<std::size_t>(std::ranges::count(calls, what));
}

} // namespace

class tst_PoshBehavior : public QObject {
    Q_OBJECT
private slots:
    void sendsWhatItsActsWantWithTheirPath();
    void theLastOfSeveralDriveCommandsLeaves();
    void theGoalFinishesIt();
    void aThrowingActIsReportedOnceAndTheRobotIsSafe();
    void aSpinningPlanIsReportedAndTheRobotIsSafe();
    void aStarvingDriveIsReportedAndTheRobotIsSafe();
    void withoutReadyDriveTheRobotIsSafe();
    void pauseHoldsThePlanAndResumeGoesOn();
    void landingStopsThePlanUnlessTheBodySeesToIt();
    void anotherPlanTakesItsPlace();
    void aBadPlanChangesNothing();
    void aPlanThatDoesNotFitIsRefusedWithAllItsErrors();
    void theBlackboardIsTraced();
    void publishedTracesMakeATraceFile();
    void theEndOfTheBehaviorEndsItsAct();
};

void tst_PoshBehavior::sendsWhatItsActsWantWithTheirPath() {
    Run run(drive_on);
    auto output = run.tick();
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(output.commands.front().cause, (Cause{"toy/posh: rover ▸ work ▸ DriveFor", LineNumber{1}}));
    QCOMPARE(published<BehaviorStatus>(output).front().state, std::string("rover ▸ work ▸ DriveFor"));
    run.rover->nearest_m = 0.3;
    output = run.tick();
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(1));
}

void tst_PoshBehavior::theLastOfSeveralDriveCommandsLeaves() {
    Run run("((AP p (Tick Turn('right))) (DC d (drives ((a p)))))");
    posh::TraceText trace(posh::TraceDetail::Full);
    run.behavior->watch(&trace);
    const auto output = run.tick();
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(1.0, -1.0));
    QCOMPARE(QString::fromStdString(trace.text()).count("  command "), 2);
    run.behavior->watch(nullptr);
}

void tst_PoshBehavior::theGoalFinishesIt() {
    Run run(drive_on);
    run.tick();
    run.rover->arrived = true;
    const auto output = run.tick();
    QCOMPARE(published<BehaviorFinished>(output).size(), std::size_t(1));
    QVERIFY(published<BehaviorFinished>(output).front().success);
    QCOMPARE(output.commands.back().command, wheels(0.0, 0.0));
    QVERIFY(run.host->finished());
}

void tst_PoshBehavior::aThrowingActIsReportedOnceAndTheRobotIsSafe() {
    Run run(drive_on);
    run.rover->broken = true;
    auto output = run.tick();
    QCOMPARE(output.commands.back().command, wheels(0.0, 0.0));
    const auto events = published<BehaviorEvent>(output);
    QCOMPARE(events.size(), std::size_t(1));
    QCOMPARE(events.front().text, std::string("Plan: rover ▸ work ▸ DriveFor: the wheels are off."));
    QCOMPARE(events.front().severity, Severity::Error);
    output = run.tick();
    QVERIFY(published<BehaviorEvent>(output).empty());
    QCOMPARE(output.commands.back().command, wheels(0.0, 0.0));
    QVERIFY(!run.host->finished());
}

void tst_PoshBehavior::aSpinningPlanIsReportedAndTheRobotIsSafe() {
    Run run("((DC d (drives ((spin Tick)))))");
    const auto output = run.tick();
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QVERIFY(published<BehaviorEvent>(output).front().text.find("d ▸ spin") != std::string::npos);
}

void tst_PoshBehavior::aStarvingDriveIsReportedAndTheRobotIsSafe() {
    Run run("((C c (elements ((e (trigger ((Arrived))) Halt)))) (DC d (drives ((work c)))))");
    BehaviorHost::Output output;
    for (int tick = 0; tick < 10; ++tick) {
        QVERIFY(published<BehaviorEvent>(output).empty());
        output = run.tick();
    }
    QVERIFY(published<BehaviorEvent>(output).front().text.find("starving") != std::string::npos);
    QCOMPARE(output.commands.back().command, wheels(0.0, 0.0));
}

void tst_PoshBehavior::withoutReadyDriveTheRobotIsSafe() {
    Run run("((DC d (drives ((work (trigger ((Closer(5) false))) DriveFor)))))");
    run.tick();
    run.rover->nearest_m = 1.0;
    QCOMPARE(run.tick().commands.back().command, wheels(0.0, 0.0));
    QVERIFY(run.tick().commands.empty());
}

void tst_PoshBehavior::pauseHoldsThePlanAndResumeGoesOn() {
    Run run(drive_on);
    run.tick();
    QCOMPARE(run.host->order(Order::Pause).commands.front().command, wheels(0.0, 0.0));
    const auto paused = run.tick();
    QVERIFY(paused.commands.empty());
    QVERIFY(published<BehaviorStatus>(paused).front().paused);
    run.host->order(Order::Resume);
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(count(run.rover->calls, "init"), std::size_t(1));
}

void tst_PoshBehavior::landingStopsThePlanUnlessTheBodySeesToIt() {
    Run run(drive_on);
    run.tick();
    run.rover->lands = true;
    QVERIFY(run.host->order(Order::LandNow).commands.empty());
    QVERIFY(!run.tick().commands.empty());
    run.rover->lands = false;
    const auto output = run.host->order(Order::LandNow);
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(1));
    QVERIFY(run.tick().commands.empty());
}

void tst_PoshBehavior::anotherPlanTakesItsPlace() {
    Run run(drive_on);
    run.tick();
    QVERIFY(!posh::hasErrors(run.behavior->replacePlan("((DC other (drives ((turn Turn)))))")));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(1));
    QCOMPARE(run.tick().commands.front().command, wheels(-1.0, 1.0));
}

void tst_PoshBehavior::aBadPlanChangesNothing() {
    Run run(drive_on);
    run.tick();
    QVERIFY(posh::hasErrors(run.behavior->replacePlan("((DC other (drives ((turn Trun)))))")));
    QVERIFY(posh::hasErrors(run.behavior->replacePlan("((DC other")));
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(0));
    QCOMPARE(run.behavior->planText(), drive_on);
}

void tst_PoshBehavior::aPlanThatDoesNotFitIsRefusedWithAllItsErrors() {
    const auto made = PoshBehavior::make(
        {"rover.lap", "((DC d (drives ((a Fly)) ((b Swim)))))", test::toyRegistry(), std::make_unique<ToyRover>(), {}});
    QVERIFY(!made);
    QVERIFY(made.error().text().find("plan rover.lap") != std::string::npos);
    QVERIFY(made.error().text().find("Fly") != std::string::npos);
    QVERIFY(made.error().text().find("Swim") != std::string::npos);
}

void tst_PoshBehavior::theBlackboardIsTraced() {
    Run run("((DC d (drives ((a (trigger ((Count 3 !=))) Tick)) ((b Halt)))))");
    posh::TraceText trace(posh::TraceDetail::Full);
    run.behavior->watch(&trace);
    run.tick();
    const QString text = QString::fromStdString(trace.text());
    QVERIFY(text.contains("write /P:0/DC:0/DE:0/A:0 count: nil -> 1"));
    QVERIFY(text.contains("count: 2 -> 3"));
    QVERIFY(text.contains("init /P:0/DC:0/DE:1/A:0 Halt"));
    run.behavior->watch(nullptr);
}

void tst_PoshBehavior::publishedTracesMakeATraceFile() {
    Run run(drive_on);
    std::string bytes;
    for (int i = 0; i < 20; ++i)
        for (const PlanTrace& piece : published<PlanTrace>(run.tick()))
            bytes += piece.bytes;
    const auto file = posh::TraceFile::open(bytes);
    QVERIFY(file);
    QCOMPARE(file->damage(), std::string());
    QCOMPARE(file->planText(0), drive_on);
    // An encoder says what a cycle was when the next begins, so the last may be on its way.
    QVERIFY(file->cycleCount() >= 19);
}

void tst_PoshBehavior::theEndOfTheBehaviorEndsItsAct() {
    posh::TraceText trace;
    {
        Run run(drive_on);
        run.behavior->watch(&trace);
        run.tick();
    }
    QVERIFY(QString::fromStdString(trace.text()).endsWith("DriveFor(10) stopped\n"));
}

QTEST_APPLESS_MAIN(tst_PoshBehavior)
#include "tst_posh_behavior.moc"
