#include <map>
#include <set>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "tests/mission/session/session_fixture.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_robot_session_trouble {

using namespace usar;
using namespace usar::mission;
using usar::test::hostOf;
using usar::test::Script;
using usar::test::SessionFixture;

namespace {

SpawnRequest requestFor(const std::string& robot_name, const std::string& class_name = "USARBot.AirRobot") {
    return {class_name, robot_name, {}};
}

} // namespace

/// Trouble from outside: for each kind there is one clear message that names the remedy, and no scan is lost.
class tst_RobotSessionTrouble : public QObject {
    Q_OBJECT
private slots:
    void saysSoWhenThereIsNothingToSpawnOn() {
        SessionFixture f;
        f.session.spawn(requestFor("R1"));
        QVERIFY(f.said("There is no connection to spawn R1 on. Connect first."));
        f.session.stop();
        f.session.close();
        QVERIFY(f.notices.size() == 1);
    }

    void saysSoWhenThereIsNoRobotToFly() {
        SessionFixture f;
        QVERIFY(f.connectNow());
        f.session.startBehavior(hostOf(std::make_shared<Script>()), {});
        QVERIFY(f.said("There is no robot to fly. Spawn one first."));
        QVERIFY(!f.session.figures().behavior_running);
    }

    void silenceAfterInitIsAFailedSpawnAndKeepsTheConnection() {
        SessionFixture f;
        f.server.answers_init = false;
        QVERIFY(f.connectNow());
        QSignalSpy failed(&f.session, &RobotSession::spawnFailed);
        f.session.spawn(requestFor("R1", "USARBot.NoSuchRobot"));
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(f.said("Does the server know USARBot.NoSuchRobot"));
        QVERIFY(f.said("Spawn again to try once more"));
        QCOMPARE(f.session.linkStatus().state, link::LinkState::Connected);
        QVERIFY(f.server.hasClient());
    }

    void aLateRobotIsWelcomeAllTheSame() {
        SessionFixture f;
        f.server.answers_init = false;
        QVERIFY(f.connectNow());
        QSignalSpy failed(&f.session, &RobotSession::spawnFailed);
        QSignalSpy spawned(&f.session, &RobotSession::spawned);
        f.session.spawn({});
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(f.saidOn("spawn") && !f.saidOn("spawn", true));
        f.server.tick();
        QTRY_COMPARE(spawned.size(), 1);
        QVERIFY(f.saidOn("spawn", true));
    }

    void aNameThatNoLineCanHoldIsRefused() {
        SessionFixture f;
        QVERIFY(f.connectNow());
        QSignalSpy failed(&f.session, &RobotSession::spawnFailed);
        f.session.spawn({.robot_name = "R1} {Location 0,0,0", .start_in_map = {}});
        QCOMPARE(failed.size(), 1);
        QVERIFY(f.said("a name cannot hold spaces, braces or line ends"));
        f.session.spawn({.robot_name = "R1", .start_in_map = {}}); // on the same connection
        QTRY_COMPARE(f.server.heardOf("INIT").size(), 1);
    }

    void spawningAgainAfterAFailureTakesANewConnection() {
        SessionFixture f;
        f.server.answers_init = false;
        QVERIFY(f.connectNow());
        QSignalSpy failed(&f.session, &RobotSession::spawnFailed);
        QSignalSpy spawned(&f.session, &RobotSession::spawned);
        f.session.spawn(requestFor("R1"));
        QTRY_COMPARE(failed.size(), 1);
        f.server.answers_init = true;
        f.session.spawn(requestFor("R2"));
        QTRY_COMPARE(spawned.size(), 1);
        QCOMPARE(f.server.connectionCount(), 2);
        QCOMPARE(f.server.heardOf("INIT").size(), 2);
    }

    void aServerWithoutStartPosesIsNamed() {
        SessionFixture f;
        f.server.greets = false;
        f.session.open("127.0.0.1", f.server.port(), false);
        QTRY_VERIFY(f.said("No start poses from the server for 0.2 s. Is it USARSim"));
        QCOMPARE(f.session.linkStatus().state, link::LinkState::Connected);
        QVERIFY(f.saidOn("start poses") && !f.saidOn("start poses", true));
        f.server.say("NFO {StartPoses 1} {PlayerStart 1.00,-2.00,-0.50 0.00,0.00,0.00}\r\n");
        QTRY_VERIFY(f.saidOn("start poses", true));
    }

    void staleRobotsAreNamedOnceAndWelcomedBack() {
        SessionFixture f;
        QVERIFY(f.spawnNow());
        QTRY_COMPARE(f.countSaid("its values are stale. Is the simulation paused"), std::size_t(1));
        QVERIFY(f.tickNow());
        QVERIFY(f.said("R1 is sending again."));
        QVERIFY(f.saidOn("silence") && f.saidOn("silence", true));
        QTRY_COMPARE(f.countSaid("its values are stale"), std::size_t(2));
    }

    void nobodyIsCalledSilentWhileTimeIsStopped() {
        SessionFixture f;
        QVERIFY(f.spawnNow());
        f.session.expectSilence(true);
        const test::Beats silences(200); // as long as it may be silent
        QVERIFY(test::holdsUntil([&] { return !f.saidOn("silence"); }, [&] { return silences.count() >= 2; }));
        QElapsedTimer since_it_runs;
        since_it_runs.start();
        f.session.expectSilence(false);
        QTRY_COMPARE(f.countSaid("its values are stale"), std::size_t(1));
        QVERIFY2(since_it_runs.elapsed() >= 150, "the stopped time counts for nothing");
    }

    void aSensorThatStopsIsNamed() {
        SessionFixture f;
        QVERIFY(f.spawnNow());
        f.server.scans = f.server.sonar = false;
        for (int i = 0; i < 17; ++i)
            f.server.tick();
        QTRY_COMPARE(f.countSaid("No reading from Sonar F1 for 3 s"), std::size_t(1));
        QTRY_COMPARE(f.countSaid("No reading from "), std::size_t(3)); // two sonars and a scanner
        QVERIFY(f.saidOn("sensor: RangeScanner Scanner1"));
        f.server.scans = true;
        QVERIFY(f.tickNow());
        QVERIFY(f.saidOn("sensor: RangeScanner Scanner1", true));
        QVERIFY(!f.saidOn("sensor: Sonar F1", true));
    }

    void damagedLinesAreCountedAndSaidOncePerKind() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        const std::uint64_t before = f.session.figures().lines_received;
        for (int i = 0; i < 5; ++i)
            f.server.say("1.2,3.4,,} Range 2}\r\n");
        QTRY_COMPARE(f.session.figures().lines_malformed, std::uint64_t(5));
        QCOMPARE(f.session.figures().lines_received, before + 5);
        QCOMPARE(f.countSaid("is damaged"), std::size_t(1));
        QVERIFY(f.tickNow()); // and life goes on
    }

    void anEndlessLineIsLeftOut() {
        SessionFixture f;
        QVERIFY(f.spawnNow());
        f.server.say("SEN {Type Kinect} {Data " + QByteArray(5 << 20, '7'));
        QTRY_VERIFY(f.said("a line longer than 4 MiB. It was skipped"));
        QCOMPARE(f.session.figures().lines_overlong, std::uint64_t(1));
        f.server.say("7}\r\n");
        QVERIFY(f.tickNow());
    }

    void aNanRangeStaysOutOfTheMap() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick& tick, agent::CommandPort& port) {
            port.publish(
                agent::ScanPlacement{tick.robot.sensors.scan()->line, {.position_m = {0, 0, 5}, .pitch_rad = 1.57}});
        };
        f.session.startBehavior(hostOf(script), {});
        f.server.scans = false;
        f.server.say("SEN {Time 0.40} {Type RangeScanner} {Name Scanner1} {Resolution 0.1000} {FOV 0.2000} "
                     "{Range nan,2.0000,1.#QNAN}\r\n");
        QVERIFY(f.tickNow());
        const auto range = f.session.snapshot().raster.range();
        QVERIFY(range);
        QVERIFY(std::isfinite(range->minimum_m) && std::isfinite(range->maximum_m));
    }

    void aServerThatClosesInTheMiddleCostsTheRobotButNotTheScan() {
        SessionFixture f;
        QVERIFY(f.spawnNow());
        auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick& tick, agent::CommandPort& port) {
            port.publish(
                agent::ScanPlacement{tick.robot.sensors.scan()->line, {.position_m = {0, 0, 5}, .pitch_rad = 1.57}});
        };
        f.session.startBehavior(hostOf(script), {});
        QVERIFY(f.tickNow());
        QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
        f.server.say("SEN {Type RangeScanner} {Name Scanner1} {Ran");
        f.server.hangUp();
        QTRY_COMPARE(finished.size(), 1);
        QCOMPARE(finished.at(0).at(0).toBool(), false);
        QVERIFY(f.said("The connection is lost, and R1 with it. What was scanned is kept"));
        QVERIFY(!f.session.snapshot().raster.empty());
    }

    void afterAReconnectTheRobotIsSpawnedOnlyByRequest() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        const std::uint64_t lines = f.session.figures().lines_received;
        QSignalSpy known(&f.session, &RobotSession::startPosesKnown);
        f.server.hangUp();
        QTRY_COMPARE(known.size(), 1);
        QVERIFY(f.saidOn("link") && f.saidOn("link", true));
        QVERIFY(!f.session.figures().spawned);
        QCOMPARE(f.server.heardOf("INIT").size(), 1);
        f.session.spawn({});
        QTRY_VERIFY(f.session.figures().spawned);
        QVERIFY(f.session.figures().lines_received > lines); // numbers go on, so that every line has its own
    }

    void aPlacementOfAnUnknownScanIsSaidOnce() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.publish(agent::ScanPlacement{{9999}, {}});
        };
        f.session.startBehavior(hostOf(script), {});
        QVERIFY(f.tickNow());
        QVERIFY(f.tickNow());
        QCOMPARE(f.countSaid("placed a scan that is too old"), std::size_t(1));
    }

    void aBehaviorThatThrowsIsStoppedSafely() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick&, agent::CommandPort&) { throw std::runtime_error("no geometry"); };
        QSignalSpy finished(&f.session, &RobotSession::behaviorFinished);
        f.session.startBehavior(hostOf(script), {});
        QVERIFY(f.tickNow());
        QCOMPARE(finished.size(), 1);
        QVERIFY(finished.at(0).at(1).toString().contains("no geometry"));
        QTRY_VERIFY(!f.server.heardOf("DRIVE").isEmpty());
        QVERIFY(f.tickNow());
        QCOMPARE(script->ticks, 1);
    }

    void foreignPortsAreTold() {
        SessionFixture f;
        f.server.greets = f.server.answers_lockstep = false;
        f.server.on_command = [&](const QByteArray&) { f.server.say("HTTP/1.1 400 Bad Request\r\n\r\n"); };
        QSignalSpy changes(&f.session, &RobotSession::linkChanged);
        f.session.open("127.0.0.1", f.server.port(), true);
        QTRY_COMPARE(f.session.linkStatus().state, link::LinkState::Waiting);
        QVERIFY(f.session.linkStatus().reason.contains("does not speak USARSim"));
    }

    void aServerThatHangsUpOnInitIsAFailedSpawn() {
        SessionFixture f(SessionFixture::patientLimits());
        f.server.answers_init = false;
        f.server.on_command = [&](const QByteArray& line) {
            if (line.startsWith("INIT"))
                f.server.hangUp();
        };
        QVERIFY(f.connectNow());
        QSignalSpy failed(&f.session, &RobotSession::spawnFailed);
        f.session.spawn(requestFor("R1"));
        QTRY_COMPARE(failed.size(), 1);
        QCOMPARE(f.session.figures().spawn, SpawnState::None);
        QVERIFY(f.said("closed the connection before R1 sent anything"));
        QVERIFY(f.saidOn("spawn"));
    }

    void spawnsAgainOnTheConnectionThatCameBack() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        for (int round = 2; round <= 3; ++round) {
            f.server.hangUp();
            QTRY_COMPARE(f.session.figures().spawn, SpawnState::None);
            QTRY_COMPARE(f.session.linkStatus().state, link::LinkState::Connected);
            f.session.spawn(requestFor("R1"));
            QTRY_COMPARE(f.session.figures().spawn, SpawnState::Done);
            QCOMPARE(f.server.heardOf("INIT").size(), round);
            auto script = std::make_shared<Script>();
            f.session.startBehavior(hostOf(script), {});
            QVERIFY(f.tickNow());
            QTRY_VERIFY(script->ticks >= 1);
        }
    }

    void spawnsAgainAfterBothFailureAndALostLink() {
        SessionFixture f;
        f.server.answers_init = false;
        QVERIFY(f.connectNow());
        f.session.spawn(requestFor("R1"));
        QTRY_COMPARE(f.session.figures().spawn, SpawnState::Failed);
        f.server.hangUp();
        QTRY_COMPARE(f.session.figures().spawn, SpawnState::None);
        QTRY_COMPARE(f.session.linkStatus().state, link::LinkState::Connected);
        f.session.spawn(requestFor("R1"));
        QTRY_COMPARE(f.session.figures().spawn, SpawnState::Failed);
        f.server.answers_init = true;
        f.session.spawn(requestFor("R1")); // on a new connection, for the old one has had its INIT
        QCOMPARE(f.session.figures().spawn, SpawnState::Asked);
        QTRY_COMPARE(f.session.figures().spawn, SpawnState::Done);
        QVERIFY(f.saidOn("spawn", true));
        QCOMPARE(f.server.heardOf("INIT").size(), 3);
    }

    void commandsWithoutAConnectionAreSaidOnce() {
        SessionFixture f;
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 1.0}, by::Operator{"stick"});
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 2.0}, by::Operator{"stick"});
        QCOMPARE(f.countSaid("There is no connection to send DRIVE"), std::size_t(1));
        QVERIFY(f.connectNow());
        QVERIFY(f.saidOn("no connection", true));
        QVERIFY(f.server.heardOf("DRIVE").isEmpty()); // not kept for later either
    }

    void aServerThatReadsSlowlyGetsEveryCommandAndTheNewestDrive() {
        SessionFixture f(SessionFixture::quickLimits());
        QVERIFY(f.spawnNow());
        f.server.forget();
        f.server.setDeaf(true);
        const auto waits = [&] {
            return f.countSaid("reads more slowly than commands are sent") ==
                   f.countSaid("The server reads commands again.") + 1;
        };
        qsizetype sent = 0;
        int rounds_waiting = 0;
        const auto nothing_leaves = [&] { // the network takes some megabytes before it is full
            rounds_waiting = waits() ? rounds_waiting + 1 : 0;
            for (int i = 0; i < 1000; ++i)
                f.session.sendCommand(protocol::RawCommand{"SET {Type RFID} {Name Dropper} {Opcode Release} {Params " +
                                                           std::to_string(sent++) + "}"},
                                      by::Operator{"command box"});
            return rounds_waiting > 10;
        };
        QTRY_VERIFY_WITH_TIMEOUT(nothing_leaves(), 20000);
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 1.0}, by::Operator{"stick"});
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 2.0}, by::Operator{"stick"});
        QVERIFY(f.tickNow()); // reading goes on meanwhile
        f.session.sendCommand(protocol::AerialDrive{.climb_m_s = 3.0}, by::Operator{"stick"});
        QVERIFY(waits()); // and is said once
        f.server.setDeaf(false);
        QTRY_VERIFY_WITH_TIMEOUT(!waits(), 20000);
        QTRY_COMPARE(f.server.heardOf("DRIVE").size(), 1);
        QVERIFY(f.server.heardOf("DRIVE").at(0).contains("{AltitudeVelocity 3"));
        const QList<QByteArray> heard = f.server.heardOf("SET");
        QCOMPARE(heard.size(), sent);
        for (qsizetype i = 0; i < sent; ++i)
            QVERIFY(heard.at(i).endsWith("{Params " + QByteArray::number(i) + "}"));
    }

    void everyNoticeHasATopicAndDifferentOnesDiffer() {
        SessionFixture f;
        f.session.spawn(requestFor("R1"));
        f.server.answers_init = false;
        QVERIFY(f.connectNow());
        f.session.startBehavior(hostOf(std::make_shared<Script>()), {});
        f.session.spawn(requestFor("R1"));
        QTRY_VERIFY(f.saidOn("spawn"));
        f.server.tick();
        QTRY_VERIFY(f.session.figures().spawned);
        f.session.spawn(requestFor("R2"));
        auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.publish(agent::ScanPlacement{{9999}, {}});
            port.publish(agent::BehaviorEvent{Severity::Note, "Took off."});
            port.publish(agent::BehaviorEvent{Severity::Note, "Charging."});
        };
        f.session.startBehavior(hostOf(script), {});
        f.server.say("1.2,3.4,,} Range 2}\r\nSEN {Type Sonar} {Name F1 Range 1.#QNAN}\r\n");
        QVERIFY(f.tickNow());
        std::map<std::string, std::set<std::string>> texts_by_topic;
        for (const Notice& notice : f.notices)
            if (!notice.over)
                texts_by_topic[notice.topic].insert(notice.text);
        QVERIFY(!texts_by_topic.contains(""));
        QVERIFY2(texts_by_topic.size() >= 8, qPrintable(QString::number(texts_by_topic.size())));
        for (const auto& [topic, texts] : texts_by_topic)
            QVERIFY2(texts.size() == 1, topic.c_str());
    }
};

USAR_TEST(tst_RobotSessionTrouble)

} // namespace tst_robot_session_trouble

#include "tst_robot_session_trouble.moc"
