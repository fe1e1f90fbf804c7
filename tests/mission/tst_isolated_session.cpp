#include <csignal>

#include <QSignalSpy>
#include <QTest>

#include "core/agent/isolated_behavior.h"
#include "tests/mission/session_fixture.h"

using namespace usar;
using namespace usar::mission;
using usar::test::SessionFixture;

namespace {

std::shared_ptr<agent::IsolatedBehavior> climbing(const std::string& id) {
    return std::make_shared<agent::IsolatedBehavior>(
        QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host"),
        agent::frames::Start{.plugin_file = USAR_BINARY_DIR "/tests/plugins/faulty.so",
                             .behavior_id = id,
                             .task = {},
                             .parameters = {{"ticks", 3LL}},
                             .plan = {}});
}

bool stops(const QByteArray& drive) {
    return drive.contains("{AltitudeVelocity 0}") && drive.contains("{LinearVelocity 0}");
}

} // namespace

/// A session whose behavior lives in another process.
class tst_IsolatedSession : public QObject {
    Q_OBJECT
private slots:
    void aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms_data();
    void aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms();
    void aRobotWhoseBehaviorDiesInItsTickStopsInThatTick();
    void whatCannotBeStartedEndsTheBehaviorAndNotTheRobot();
};

void tst_IsolatedSession::aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("SEGV") << SIGSEGV;
    QTest::newRow("KILL") << SIGKILL;
}

void tst_IsolatedSession::aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms() {
    QFETCH(int, signal);
    SessionFixture f(SessionFixture::patientLimits());
    QVERIFY(f.spawnNow());
    QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
    const auto behavior = climbing("faulty/none");
    f.session.startBehavior(behavior, {});
    QVERIFY(f.tickNow());
    QTRY_VERIFY(!f.server.heardOf("DRIVE").isEmpty());
    QVERIFY(!stops(f.server.heardOf("DRIVE").last()));

    constexpr int tick_ms = 200;
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(::kill(behavior->processId(), signal), 0); // between two ticks: nobody asks it anything
    QTRY_VERIFY(stops(f.server.heardOf("DRIVE").last()));
    QVERIFY2(timer.elapsed() <= tick_ms + 50, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(finished.size(), 1);
    QVERIFY(!finished[0][0].toBool());
    QVERIFY2(finished[0][1].toString().contains(signal == SIGSEGV ? "died by SIGSEGV" : "died by SIGKILL"),
             qPrintable(finished[0][1].toString()));

    QVERIFY(f.tickNow()); // the robot is as well as before
    const qsizetype before = f.server.heardOf("DRIVE").size();
    f.session.startBehavior(climbing("faulty/none"), {});
    QVERIFY(f.tickNow());
    QTRY_VERIFY(f.server.heardOf("DRIVE").size() > before);
}

void tst_IsolatedSession::aRobotWhoseBehaviorDiesInItsTickStopsInThatTick() {
    SessionFixture f(SessionFixture::patientLimits());
    QVERIFY(f.spawnNow());
    QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
    f.session.startBehavior(climbing("faulty/segfault"), {});
    for (int i = 0; i < 4 && finished.isEmpty(); ++i)
        QVERIFY(f.tickNow());
    QTRY_COMPARE(finished.size(), 1);
    QTRY_VERIFY(stops(f.server.heardOf("DRIVE").last()));
    QVERIFY(finished[0][1].toString().contains("while it worked on line"));
    QVERIFY(!f.session.figures().behavior_running);
}

void tst_IsolatedSession::whatCannotBeStartedEndsTheBehaviorAndNotTheRobot() {
    SessionFixture f(SessionFixture::patientLimits());
    QVERIFY(f.spawnNow());
    QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
    f.session.startBehavior(climbing("faulty/unheard of"), {});
    QCOMPARE(finished.size(), 1);
    QVERIFY(finished[0][1].toString().contains("There are: faulty/none"));
    QVERIFY(f.tickNow());
}

QTEST_GUILESS_MAIN(tst_IsolatedSession)
#include "tst_isolated_session.moc"
