#include <atomic>
#include <csignal>

#include <QSignalSpy>
#include <QTest>

#include "core/agent/process/isolated_behavior.h"
#include "tests/doubles/own_thread.h"
#include "tests/mission/session/session_fixture.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"

namespace tst_isolated_session {

using namespace usar;
using namespace usar::mission;
using usar::test::SessionFixture;

namespace {

std::shared_ptr<agent::IsolatedBehavior> climbing(const std::string& id) {
    return std::make_shared<agent::IsolatedBehavior>(
        QStringLiteral(USAR_BINARY_DIR "/bin/usar-behavior-host"),
        agent::frames::Start{USAR_BINARY_DIR "/tests/plugins/faulty.so",
                             {id, /*task=*/{}, {{"ticks", 3LL}}, /*plan=*/{}}});
}

constexpr int tick_ms = 200;

bool stops(const QByteArray& drive) {
    return drive.contains("{AltitudeVelocity 0}") && drive.contains("{LinearVelocity 0}");
}

} // namespace

/// A session whose behavior lives in another process.
class tst_IsolatedSession : public QObject {
    Q_OBJECT
private slots:
    void aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SEGV") << SIGSEGV;
        QTest::newRow("KILL") << SIGKILL;
    }

    void aRobotWhoseBehaviorIsKilledStopsWithinATickAnd50Ms() {
        QFETCH(int, signal);
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
        const auto behavior = climbing("faulty/none");
        f.session.startBehavior(behavior, {});
        QVERIFY(f.tickNow());
        QTRY_VERIFY(!f.server.heardOf("DRIVE").isEmpty());
        QVERIFY(!stops(f.server.heardOf("DRIVE").last()));

        QElapsedTimer timer;
        timer.start();
        QVERIFY(test::sendSignal(behavior->processId(), signal)); // between two ticks: nobody asks it anything
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

    void aRobotWhoseBehaviorDiesInItsTickStopsInThatTick_data() {
        QTest::addColumn<QString>("fault");
        QTest::addColumn<QString>("words");
        QTest::addColumn<int>("finding_out_ms"); // at the least: the robot has stopped before
        QTest::newRow("by a signal that it tells of") << "segfault"
                                                      << "died by SIGSEGV" << 0;
        QTest::newRow("by one that nobody can tell of") << "orphan"
                                                        << "died by SIGKILL" << 0;
        QTest::newRow("it ends") << "exit"
                                 << "exit code 3" << 0;
        QTest::newRow("it hangs up and lives on") << "hang up"
                                                  << "broke the connection" << 400;
    }

    void aRobotWhoseBehaviorDiesInItsTickStopsInThatTick() {
        QFETCH(QString, fault);
        QFETCH(QString, words);
        QFETCH(int, finding_out_ms);
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
        f.session.startBehavior(climbing("faulty/" + fault.toStdString()), {});
        for (int i = 0; i < 3; ++i)
            QVERIFY(f.tickNow());
        QTRY_VERIFY(!f.server.heardOf("DRIVE").isEmpty() && !stops(f.server.heardOf("DRIVE").last()));

        // The server goes to a thread of its own, for the session's waits while it finds out the reason.
        QElapsedTimer timer;
        std::atomic<qint64> stopped_ms = -1;
        f.server.on_command = [&](const QByteArray& line) {
            if (stopped_ms < 0 && line.startsWith("DRIVE") && stops(line))
                stopped_ms = timer.elapsed();
        };
        bool told = false;
        {
            const test::OwnThread elsewhere(f.server);
            timer.start();
            link::post(&f.server, [&] { f.server.tick(); });
            told = QTest::qWaitFor([&] { return !finished.isEmpty() && stopped_ms >= 0; });
        }
        QVERIFY(told);
        QVERIFY2(stopped_ms >= 0 && stopped_ms <= tick_ms + 50, qPrintable(QString::number(stopped_ms)));
        QVERIFY2(timer.elapsed() >= finding_out_ms, qPrintable(QString::number(timer.elapsed())));
        QVERIFY2(finished[0][1].toString().contains(words), qPrintable(finished[0][1].toString()));
        QVERIFY(finished[0][1].toString().contains("while it worked on line"));
        QVERIFY(!f.session.figures().behavior_running);
    }

    void whatCannotBeStartedEndsTheBehaviorAndNotTheRobot() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
        f.session.startBehavior(climbing("faulty/unheard of"), {});
        QCOMPARE(finished.size(), 1);
        QVERIFY(finished[0][1].toString().contains("There are: faulty/none"));
        QVERIFY(f.tickNow());
    }
};

USAR_TEST(tst_IsolatedSession)

} // namespace tst_isolated_session

#include "tst_isolated_session.moc"
