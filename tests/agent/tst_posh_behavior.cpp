// A plan as a behavior: what its acts send, and what happens when plan, acts or people want it otherwise.
#include <QTest>

#include "core/posh/trace/trace_file.h"
#include "tests/agent/posh_run.h"
#include "tests/doubles/trace_text.h"
#include "tests/suite/suite.h"

namespace tst_posh_behavior {

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
    void anotherPlanRestartsAndTheRobotIsSafeMeanwhile();
    void aPlanOfTheSameShapeIsKeptGoing();
    void aBadPlanIsRefusedWithItsFindings();
    void aPlanThatWasStoppedTakesNoOther();
    void aBreakpointHaltsItWithASafeRobotOnce();
    void whatGoesOnDoesAsItDidBefore();
    void aWrittenKeyHaltsIt();
    void aStepIsOneCycle();
    void haltsWhenAskedTo();
    void landingLetsItGoOn();
    void theSameBreakpointsKeepTheirCounts();
    void aConditionThatIsNoneIsSaid();
    void pinsAnswerForTheRobot();
    void aRobotWhoseActIsPinnedStandsStill();
    void aDriveThatIsOffIsNotTakenEvenFromAnotherPlan();
    void aPlanThatDoesNotFitIsRefusedWithAllItsErrors();
    void theBlackboardIsTraced();
    void aPlanForRealTimeIsRemarkedOnOnce();
    void publishedTracesMakeATraceFile();
    void theEndOfTheBehaviorEndsItsAct();
};

void tst_PoshBehavior::sendsWhatItsActsWantWithTheirPath() {
    Run run(drive_on);
    auto output = run.tick();
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(output.commands.front().cause,
             (Cause{by::Plan{"toy/posh", "rover ▸ work ▸ DriveFor", {}}, LineNumber{1}}));
    QCOMPARE(published<BehaviorStatus>(output).front().state, std::string("rover ▸ work ▸ DriveFor"));
    run.rover->nearest_m = 0.3;
    output = run.tick();
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(1));
}

void tst_PoshBehavior::theLastOfSeveralDriveCommandsLeaves() {
    Run run("((AP p (Tick Turn('right))) (DC d (drives ((a p)))))");
    test::TraceText trace(test::TraceDetail::Full);
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

void tst_PoshBehavior::anotherPlanRestartsAndTheRobotIsSafeMeanwhile() {
    Run run(drive_on);
    run.tick();
    const auto output = run.host->control(ReplacePlan{{"new.lap", "((DC other (drives ((turn Turn)))))"}});
    const auto news = thePublished<PlanReplaced>(output);
    QCOMPARE(news.fate, PlanFate::Restarted);
    QCOMPARE(news.plan_name, std::string("new.lap"));
    QCOMPARE(news.cycle, std::uint64_t(1));
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(1));
    QCOMPARE(run.tick().commands.front().command, wheels(-1.0, 1.0));
}

void tst_PoshBehavior::aPlanOfTheSameShapeIsKeptGoing() {
    Run run(drive_on);
    run.tick();
    const std::string tuned = "((DC rover (goal ((Arrived))) ; slower to worry\n"
                              "(drives ((danger (trigger ((Nearest 0.2 <))) Halt)) ((work DriveFor(10))))))";
    QCOMPARE(replacedBy(run, tuned).fate, PlanFate::Restarted); // it asks another sense
    run.tick();
    const auto init = count(run.rover->calls, "init");
    std::string softer = tuned;
    softer.replace(softer.find("0.2"), 3, "5.0");
    const auto output = run.host->control(ReplacePlan{{"softer.lap", softer}});
    QCOMPARE(thePublished<PlanReplaced>(output).fate, PlanFate::Kept);
    QVERIFY(output.commands.empty());
    QCOMPARE(run.behavior->planText(), softer);
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(count(run.rover->calls, "init"), init);
    run.rover->nearest_m = 4.0;
    QCOMPARE(run.tick().commands.front().command, wheels(0.0, 0.0));
}

void tst_PoshBehavior::aBadPlanIsRefusedWithItsFindings() {
    Run run(drive_on);
    run.tick();
    const auto unknown = replacedBy(run, "((DC other (drives ((turn Trun)))))");
    QCOMPARE(unknown.fate, PlanFate::Refused);
    QCOMPARE(unknown.findings.front().code, posh::Code::UnknownPrimitive);
    QVERIFY(posh::hasErrors(replacedBy(run, "((DC other").findings));
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(count(run.rover->calls, "done"), std::size_t(0));
    QCOMPARE(run.behavior->planText(), drive_on);
}

void tst_PoshBehavior::aPlanThatWasStoppedTakesNoOther() {
    Run run(drive_on);
    run.tick();
    run.host->order(Order::LandNow);
    const auto news = replacedBy(run, "((DC other (drives ((turn Turn)))))");
    QCOMPARE(news.fate, PlanFate::Refused);
    QVERIFY(news.reason.find("land") != std::string::npos);
}

void tst_PoshBehavior::aBreakpointHaltsItWithASafeRobotOnce() {
    Run run(drive_on);
    run.host->control(breakBefore("rover ▸ danger ▸ Halt"));
    QVERIFY(published<PlanHalted>(run.tick()).empty());
    run.rover->nearest_m = 0.1;
    run.tick();
    run.rover->nearest_m = 10.0;
    QVERIFY(run.host->halted());
    for (int i = 0; i < 3; ++i) {
        const auto output = run.tick();
        QVERIFY(output.commands.empty());
        QVERIFY(published<PlanHalted>(output).empty());
    }
    QCOMPARE(run.behavior->engine().cycleNumber(), std::uint64_t(2));
    QCOMPARE(count(run.rover->calls, "begin"), std::size_t(5)); // the body looks on
}

void tst_PoshBehavior::whatGoesOnDoesAsItDidBefore() {
    Run run(drive_on);
    run.host->control(breakBefore("rover ▸ work ▸ DriveFor"));
    auto output = run.tick();
    const auto halted = thePublished<PlanHalted>(output);
    QCOMPARE(halted.breakpoint, std::optional(BreakpointId{7}));
    QCOMPARE(halted.cycle, std::uint64_t(1));
    QCOMPARE(halted.time, Seconds(0.2));
    QCOMPARE(halted.path, std::string("/P:0/DC:0/DE:1/A:0"));
    QCOMPARE(halted.reason, std::string("before rover ▸ work ▸ DriveFor"));
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
    QCOMPARE(toText(output.commands.front().cause.source), std::string("toy/posh: plan halted"));
    output = run.host->control(PlanStep::Continue);
    QCOMPARE(published<PlanResumed>(output).size(), std::size_t(1));
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(toText(output.commands.front().cause.source), std::string("toy/posh: rover ▸ work ▸ DriveFor"));
    QVERIFY(!run.host->halted());
    QVERIFY(run.host->control(PlanStep::Continue).published.empty());
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
    QCOMPARE(count(run.rover->calls, "init"), std::size_t(1));
}

void tst_PoshBehavior::aStepIsOneCycle() {
    Run run(drive_on);
    run.host->control(breakBefore("rover ▸ work ▸ DriveFor"));
    run.tick();
    for (std::uint64_t cycle = 2; cycle <= 4; ++cycle) {
        run.host->control(PlanStep::Cycle);
        const auto halted = thePublished<PlanHalted>(run.tick());
        QCOMPARE(halted.cycle, cycle);
        QVERIFY(!halted.breakpoint);
        run.tick();
        QCOMPARE(run.behavior->engine().cycleNumber(), cycle);
    }
}

void tst_PoshBehavior::haltsWhenAskedTo() {
    Run run(drive_on);
    run.tick();
    QVERIFY(run.host->control(PlanStep::Halt).commands.empty());
    QCOMPARE(thePublished<PlanHalted>(run.tick()).reason, std::string("as asked"));
    run.host->control(PlanStep::Halt); // it does already
    run.host->control(PlanStep::Continue);
    QVERIFY(published<PlanHalted>(run.tick()).empty());
}

void tst_PoshBehavior::landingLetsItGoOn() {
    Run run(drive_on);
    run.rover->lands = true; // by its plan, which must run
    run.host->control(breakBefore("rover ▸ work"));
    run.tick();
    QVERIFY(run.host->halted());
    run.host->order(Order::LandNow);
    QVERIFY(!run.host->halted());
    QVERIFY(!run.tick().commands.empty());
}

void tst_PoshBehavior::theSameBreakpointsKeepTheirCounts() {
    Run run(drive_on);
    SetBreakpoints all = breakBefore("rover ▸ danger ▸ Closer");
    all.breakpoints.front().what.skip = 2;
    run.host->control(all);
    run.tick();
    posh::Breakpoint other;
    other.names = "rover ▸ nothing";
    all.breakpoints.push_back({8, other});
    run.host->control(all);
    run.tick();
    QVERIFY(!run.host->halted());
    run.tick();
    QVERIFY(run.host->halted());
    run.host->control(PlanStep::Continue);
    run.host->control(SetBreakpoints{});
    run.tick();
    QVERIFY(!run.host->halted());
}

void tst_PoshBehavior::aConditionThatIsNoneIsSaid() {
    Run run(drive_on);
    SetBreakpoints all = breakBefore("rover ▸ work");
    all.breakpoints.front().what.condition = "(Nearest 1";
    const auto event = thePublished<BehaviorEvent>(run.host->control(all));
    QCOMPARE(event.severity, Severity::Warning);
    QVERIFY(event.text.find("rover ▸ work") != std::string::npos);
    run.tick();
    QVERIFY(!run.host->halted());
}

void tst_PoshBehavior::pinsAnswerForTheRobot() {
    Run run(drive_on);
    run.host->control(SetPins{.senses = {{"Closer(0.5)", true}}, .acts = {}, .drives_off = {}});
    QCOMPARE(run.tick().commands.front().command, wheels(0.0, 0.0));
    run.host->control(SetPins{});
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
}

void tst_PoshBehavior::aRobotWhoseActIsPinnedStandsStill() {
    Run run(drive_on);
    run.tick();
    run.host->control(SetPins{.senses = {}, .acts = {{"DriveFor(10)", posh::ActResult::Running}}, .drives_off = {}});
    const auto output = run.tick();
    QCOMPARE(output.commands.size(), std::size_t(1));
    QCOMPARE(output.commands.front().command, wheels(0.0, 0.0));
}

void tst_PoshBehavior::aDriveThatIsOffIsNotTakenEvenFromAnotherPlan() {
    Run run(drive_on);
    run.host->control(SetPins{.senses = {}, .acts = {}, .drives_off = {{"/P:0/DC:0/DE:1", "rover ▸ work"}}});
    QCOMPARE(run.tick().commands.front().command, wheels(0.0, 0.0)); // nothing is ready
    QCOMPARE(replacedBy(run, "((DC rover (drives ((work DriveFor(3))))))").fate, PlanFate::Restarted);
    QCOMPARE(run.tick().commands.front().command, wheels(0.0, 0.0));
    run.host->control(SetPins{});
    QCOMPARE(run.tick().commands.front().command, wheels(1.0, 1.0));
}

void tst_PoshBehavior::aPlanThatDoesNotFitIsRefusedWithAllItsErrors() {
    const auto made = PoshBehavior::make(
        {"rover.lap", "((DC d (drives ((a Fly)) ((b Swim)))))", test::toyRegistry(), std::make_unique<ToyRover>(), {}});
    QVERIFY(!made);
    QVERIFY(made.error().text().find("plan rover.lap") != std::string::npos);
    QVERIFY(made.error().text().find("Fly") != std::string::npos);
    QVERIFY(made.error().text().find("Swim") != std::string::npos);
}

void tst_PoshBehavior::aWrittenKeyHaltsIt() {
    Run run("((DC d (drives ((a (trigger ((Count 3 !=))) Tick)) ((b Halt)))))");
    posh::Breakpoint breakpoint;
    breakpoint.names = "d";
    breakpoint.on = posh::BreakOn::Written;
    breakpoint.key = "count";
    breakpoint.condition = "(count 2 =)";
    run.host->control(SetBreakpoints{{{7, breakpoint}}});
    const PlanHalted halted = thePublished<PlanHalted>(run.tick());
    QCOMPARE(halted.breakpoint, std::optional(BreakpointId{7}));
    QCOMPARE(halted.reason, std::string("d ▸ a ▸ Tick wrote count: 1 -> 2"));
}

void tst_PoshBehavior::theBlackboardIsTraced() {
    Run run("((DC d (drives ((a (trigger ((Count 3 !=))) Tick)) ((b Halt)))))");
    test::TraceText trace(test::TraceDetail::Full);
    run.behavior->watch(&trace);
    run.tick();
    const QString text = QString::fromStdString(trace.text());
    QVERIFY(text.contains("write /P:0/DC:0/DE:0/A:0 count: nil -> 1"));
    QVERIFY(text.contains("count: 2 -> 3"));
    QVERIFY(text.contains("init /P:0/DC:0/DE:1/A:0 Halt"));
    run.behavior->watch(nullptr);
}

void tst_PoshBehavior::aPlanForRealTimeIsRemarkedOnOnce() {
    Run run("((RDC d (drives ((a Halt)))))");
    const auto said = [](const BehaviorHost::Output& output) {
        return std::ranges::count_if(published<BehaviorEvent>(output), [](const BehaviorEvent& event) {
            return event.severity == Severity::Note && event.text.find("real time") != std::string::npos;
        });
    };
    QCOMPARE(said(run.tick()), 1);
    QCOMPARE(said(run.tick()), 0);
    QCOMPARE(said(run.host->control(ReplacePlan{{"b.lap", "((DC d (drives ((a Halt)))))"}})), 0);
    QCOMPARE(said(run.host->control(ReplacePlan{{"c.lap", "((SRDC d (drives ((a Halt)))))"}})), 1);
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
    test::TraceText trace;
    {
        Run run(drive_on);
        run.behavior->watch(&trace);
        run.tick();
    }
    QVERIFY(QString::fromStdString(trace.text()).endsWith("DriveFor(10) stopped\n"));
}

USAR_TEST(tst_PoshBehavior)

} // namespace tst_posh_behavior

#include "tst_posh_behavior.moc"
