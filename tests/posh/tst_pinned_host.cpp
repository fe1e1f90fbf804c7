// Fixed answers in place of the robot's.
#include <QTest>

#include "core/posh/run/pinned_host.h"
#include "tests/posh/trial.h"
#include "tests/suite/suite.h"

namespace tst_pinned_host {

using namespace usar;
using namespace usar::posh;

class tst_PinnedHost : public QObject {
    Q_OBJECT
private slots:
    void aPinnedSenseAnswersForTheRobot();
    void onlyTheCallWithThoseArgumentsIsPinned();
    void aPinnedActDoesNotReachTheRobot();
    void anActThatWasBegunOnTheRobotIsEndedThere();
    void anActReleasedInTheMiddleIsBegunOnTheRobot();
    void pinsOutliveThePlan();
    void saysWhenAnActDidNotReachTheRobot();
};

void tst_PinnedHost::saysWhenAnActDidNotReachTheRobot() {
    TrialHost robot;
    PinnedHost host(robot);
    Engine engine(host, programOf("((DC d (drives ((a (trigger ((near))) walk)) ((b swim)))))"));
    host.pinSense("near", true);
    engine.cycle(Milliseconds(0));
    QVERIFY(!host.takeActed());
    host.pinAct("walk", ActResult::Running);
    engine.cycle(Milliseconds(1));
    QVERIFY(host.takeActed());
    QVERIFY(!host.takeActed());
    host.releaseAll();
    QVERIFY(!host.isPinned("walk") && !host.isPinned("near"));
    engine.cycle(Milliseconds(2));
    QVERIFY(!host.takeActed());
    QCOMPARE(robot.calls.back(), std::string("done swim"));
}

void tst_PinnedHost::aPinnedSenseAnswersForTheRobot() {
    TrialHost robot;
    PinnedHost host(robot);
    Engine engine(host, programOf("((DC d (drives ((a (trigger ((near))) walk)))))"));
    host.pinSense("near", true);
    QCOMPARE(engine.cycle(Milliseconds(0)), Outcome::Fired);
    QCOMPARE(robot.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
    host.release("near");
    QCOMPARE(engine.cycle(Milliseconds(1)), Outcome::Idle);
    QCOMPARE(robot.calls.back(), std::string("sense near"));
}

void tst_PinnedHost::onlyTheCallWithThoseArgumentsIsPinned() {
    TrialHost robot;
    PinnedHost host(robot);
    Engine engine(host,
                  programOf("((DC d (drives ((a (trigger ((near(1)))) walk)) ((b (trigger ((near(2)))) swim)))))"));
    host.pinSense("near(2)", 5.0);
    engine.cycle(Milliseconds(0));
    QCOMPARE(robot.calls, (std::vector<std::string>{"sense near", "init swim", "run swim", "done swim"}));
}

void tst_PinnedHost::aPinnedActDoesNotReachTheRobot() {
    TrialHost robot;
    PinnedHost host(robot);
    host.pinAct("walk", ActResult::Running);
    Engine engine(host, programOf("((DC d (drives ((a walk)))))"));
    engine.cycle(Milliseconds(0));
    QVERIFY(engine.currentAct() != nowhere);
    host.pinAct("walk", ActResult::Failed);
    engine.cycle(Milliseconds(1));
    QVERIFY(engine.currentAct() == nowhere);
    QVERIFY(robot.calls.empty());
}

void tst_PinnedHost::anActThatWasBegunOnTheRobotIsEndedThere() {
    TrialHost robot;
    robot.setResult("walk", ActResult::Running);
    PinnedHost host(robot);
    Engine engine(host, programOf("((DC d (drives ((a walk)))))"));
    engine.cycle(Milliseconds(0));
    host.pinAct("walk", ActResult::RunningOnce);
    engine.cycle(Milliseconds(1));
    QCOMPARE(robot.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_PinnedHost::anActReleasedInTheMiddleIsBegunOnTheRobot() {
    TrialHost robot;
    PinnedHost host(robot);
    host.pinAct("walk", ActResult::Running);
    Engine engine(host, programOf("((DC d (drives ((a walk)))))"));
    engine.cycle(Milliseconds(0));
    host.release("walk");
    engine.cycle(Milliseconds(1));
    QCOMPARE(robot.calls, (std::vector<std::string>{"init walk", "run walk", "done walk"}));
}

void tst_PinnedHost::pinsOutliveThePlan() {
    TrialHost robot;
    PinnedHost host(robot);
    host.pinSense("near", true);
    Engine engine(host, programOf("((DC d (drives ((a walk)))))"));
    engine.replace(programOf("((DC d (drives ((a (trigger ((far) (near))) walk)) ((b (trigger ((near))) swim)))))"));
    engine.cycle(Milliseconds(0));
    QVERIFY(host.isPinned("near"));
    QCOMPARE(robot.calls[1], std::string("init swim"));
}

USAR_TEST(tst_PinnedHost)

} // namespace tst_pinned_host

#include "tst_pinned_host.moc"
