#include <QSignalSpy>
#include <QTest>

#include "tests/mission/session/session_fixture.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_robot_session {

using namespace usar;
using namespace usar::mission;
using usar::test::hostOf;
using usar::test::Script;
using usar::test::SessionFixture;

namespace {

SpawnRequest requestFor(const std::string& robot_name) {
    SpawnRequest request;
    request.robot_name = robot_name;
    request.start_in_map.position_m = {1.0, 2.0, 0.5};
    return request;
}

agent::BehaviorStatus scanningWithCharges(int charges) {
    agent::BehaviorStatus status;
    status.state = "scanning";
    status.charges = charges;
    return status;
}

agent::MapMark lowRiskAt(Seconds time) {
    return {agent::MarkKind::LowRisk, Vec3::Zero(), time, {}};
}

} // namespace

class tst_RobotSession : public QObject {
    Q_OBJECT
private slots:
    void init() {
        f = std::make_unique<SessionFixture>(SessionFixture::patientLimits());
        script = std::make_shared<Script>();
    }

    void cleanup() { f.reset(); }

    void asksForStartPosesAtOnce() {
        QSignalSpy known(&f->session, &RobotSession::startPosesKnown);
        QVERIFY(f->connectNow());
        const auto poses = known.at(0).at(0).value<protocol::StartPoses>().poses;
        QCOMPARE(poses.size(), std::size_t(2));
        QCOMPARE(poses[0].name, std::string("PlayerStart"));
        QCOMPARE(poses[0].pose_in_map.position_m, Vec3(1.0, 2.0, 0.5)); // the wire is y right, z down
        QCOMPARE(known.at(0).at(1).toString(), QString("tall_test"));
        QCOMPARE(f->server.heard(), QList<QByteArray>{"GETSTARTPOSES"});
    }

    void asksForLockstepOnlyWhenTold() {
        QVERIFY(f->connectNow(true));
        QCOMPARE(f->server.heard(), (QList<QByteArray>{"LOCKSTEP {On true}", "GETSTARTPOSES"}));
        QVERIFY(f->session.figures().lockstep);
        QVERIFY(f->server.heardOf("STEP").isEmpty());
    }

    void spawnsByRequestWithOneInit() {
        QSignalSpy spawned(&f->session, &RobotSession::spawned);
        QVERIFY(f->connectNow());
        QVERIFY(f->server.heardOf("INIT").isEmpty());
        f->session.spawn(requestFor("Kite"));
        QTRY_COMPARE(spawned.size(), 1);
        QCOMPARE(spawned.at(0).at(0).toString(), QString("Kite"));
        QCOMPARE(f->server.heardOf("INIT").size(), 1);
        const QByteArray expected = "INIT {ClassName USARBot.AirRobot} {Name Kite} {Location 1,-2,-0.5} {Rotation ";
        QVERIFY2(f->server.heardOf("INIT").at(0).startsWith(expected), f->server.heardOf("INIT").at(0));
        QVERIFY(f->tickNow());
        QCOMPARE(spawned.size(), 1);
    }

    void refusesASecondRobotOnTheConnection() {
        QVERIFY(f->spawnNow());
        f->session.spawn(requestFor("R2"));
        QVERIFY(f->said("R1 is spawned here already"));
        QVERIFY(f->tickNow());
        QCOMPARE(f->server.heardOf("INIT").size(), 1);
    }

    void behaviorTicksOnEveryState() {
        QVERIFY(f->spawnNow());
        std::vector<double> times_s;
        script->on_tick = [&](const agent::Tick& tick, agent::CommandPort&) {
            times_s.push_back(tick.now.count());
            QVERIFY(tick.robot.sensors.scan());
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->session.figures().behavior_running);
        QVERIFY(f->tickNow());
        QVERIFY(f->tickNow());
        QCOMPARE(times_s, (std::vector<double>{0.4, 0.6}));
        QCOMPARE(script->lines.size(), std::size_t(10));
    }

    void drivesTheNewestOncePerTick() {
        QVERIFY(f->spawnNow());
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = 1.0, .forward_m_s = 1.0}, "first thought");
            port.send(protocol::AerialDrive{.forward_m_s = 2.0}, "second thought");
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        QVERIFY(f->tickNow());
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 2);
        QVERIFY2(f->server.heardOf("DRIVE").at(0).contains("{AltitudeVelocity 1}"), f->server.heardOf("DRIVE").at(0));
        QVERIFY2(f->server.heardOf("DRIVE").at(0).contains("{LinearVelocity 2}"), f->server.heardOf("DRIVE").at(0));
    }

    void lockstepAnswersEachStateWithCommandsThenStep() {
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = 1.0}, "rising");
        };
        connect(&f->session, &RobotSession::spawned, &f->session,
                [this] { f->session.startBehavior(hostOf(script), task); });
        QVERIFY(f->spawnNow(true));
        f->server.ticks_on_step = true;
        QVERIFY(f->tickNow());
        QTRY_VERIFY(f->server.tickCount() >= 20);
        const QList<QByteArray> heard = f->server.heard().mid(3); // LOCKSTEP, GETSTARTPOSES, INIT
        for (qsizetype i = 0; i + 1 < heard.size(); i += 2) {
            QVERIFY2(heard.at(i).startsWith("DRIVE"), heard.at(i));
            QCOMPARE(heard.at(i + 1), QByteArray("STEP"));
        }
    }

    void realServersGetNoStep() {
        f->server.answers_lockstep = false;
        QVERIFY(f->spawnNow(true));
        QVERIFY(f->tickNow());
        f->session.sendCommand(protocol::RawCommand{"GETGEO {Type Robot}"}, by::Other{"test"});
        QTRY_COMPARE(f->server.heardOf("GETGEO").size(), 1);
        QVERIFY(f->server.heardOf("STEP").isEmpty());
    }

    void aPlanThatStandsStillHoldsTheServersTime() {
        f = std::make_unique<SessionFixture>(SessionFixture::quickLimits()); // it would say silence soon
        haltAt(3);
        connect(&f->session, &RobotSession::spawned, &f->session,
                [this] { f->session.startBehavior(hostOf(script), task); });
        f->server.ticks_on_step = true;
        QVERIFY(f->spawnNow(true));
        QTRY_COMPARE(script->ticks, 3);
        const int ticks = f->server.tickCount();
        const test::Beats silences(200); // as long as it may be silent
        QVERIFY(test::holdsUntil([&] { return script->ticks == 3 && f->server.tickCount() == ticks; },
                                 [&] { return silences.count() >= 2; }));
        QVERIFY(f->server.heard().back().startsWith("DRIVE {AltitudeVelocity 0"));
        QVERIFY(!f->saidOn("silence"));
        f->session.control(agent::PlanStep::Continue);
        QTRY_VERIFY(script->ticks > 5);
        const QList<QByteArray> heard = f->server.heard();
        const auto safe = std::ranges::find_if(
            heard, [](const QByteArray& line) { return line.startsWith("DRIVE {AltitudeVelocity 0"); });
        QVERIFY(heard.end() - safe > 2);
        QVERIFY2((safe + 1)->startsWith("DRIVE {AltitudeVelocity 1"),
                 *(safe + 1)); // at the same moment, before its STEP
        QCOMPARE(*(safe + 2), QByteArray("STEP"));
    }

    void aServerThatDoesNotWaitGetsTheSafeCommandAlone() {
        haltAt(2);
        QVERIFY(f->spawnNow());
        f->session.startBehavior(hostOf(script), task);
        for (int i = 0; i < 5; ++i)
            QVERIFY(f->tickNow());
        QTRY_VERIFY(f->server.heard().back().startsWith("DRIVE {AltitudeVelocity 0"));
        QCOMPARE(f->server.heardOf("DRIVE").size(), 2);
        QVERIFY(f->session.figures().behavior_running);
    }

    void aHaltedPlanThatIsStoppedLetsTimeGoOn() {
        haltAt(2);
        connect(&f->session, &RobotSession::spawned, &f->session,
                [this] { f->session.startBehavior(hostOf(script), task); });
        f->server.ticks_on_step = true;
        QVERIFY(f->spawnNow(true));
        QTRY_COMPARE(script->ticks, 2);
        const int ticks = f->server.tickCount();
        f->session.stop();
        QTRY_VERIFY(f->server.tickCount() > ticks + 2);
    }

    void placesTheScanOnTheMap() {
        QVERIFY(f->spawnNow());
        QSignalSpy updates(&f->session, &RobotSession::updated);
        script->on_tick = [](const agent::Tick& tick, agent::CommandPort& port) {
            const Pose down{.position_m = {3.0, 1.0, 5.0}, .pitch_rad = pi / 2};
            port.publish(agent::ScanPlacement{tick.robot.sensors.scan()->line, down});
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        const ScanRecord record = f->session.snapshot();
        QVERIFY(!record.raster.empty());
        const auto range = record.raster.range();
        QVERIFY(range && std::abs(range->maximum_m - 3.0f) < 0.05f);
        const auto last = [&] { return updates.last().at(0).value<std::shared_ptr<const SessionUpdate>>(); };
        QTRY_VERIFY(!updates.isEmpty() && !last()->tiles.empty());
        QCOMPARE(last()->last_hits.size(), std::size_t(3));
        QVERIFY(last()->height_range);
    }

    void keepsPathMarksAndStatus() {
        QVERIFY(f->spawnNow());
        script->on_tick = [](const agent::Tick& tick, agent::CommandPort& port) {
            port.publish(agent::PoseEstimate{tick.now, {.position_m = {tick.now.count(), 0.0, 2.0}}});
            port.publish(agent::PoseEstimate{tick.now, {.position_m = {tick.now.count() + 0.01, 0.0, 2.0}}});
            port.publish(lowRiskAt(tick.now));
            port.publish(scanningWithCharges(2));
            port.publish(agent::BehaviorEvent{Severity::Warning, "Diverted around a tree."});
        };
        f->session.startBehavior(hostOf(script), task);
        for (int i = 0; i < 4; ++i)
            QVERIFY(f->tickNow());
        const ScanRecord& record = f->session.record();
        QCOMPARE(record.robot_name, std::string("R1"));
        QCOMPARE(record.behavior_id, std::string("test/scripted"));
        QCOMPARE(record.level, std::string("tall_test"));
        QCOMPARE(record.area_in_map, task.area_in_map);
        QCOMPARE(record.path_m.size(), std::size_t(2)); // 0.2 m a tick, one point per cell of 0.25 m
        QCOMPARE(record.marks.size(), std::size_t(4));
        QCOMPARE(record.status.charges, 2);
        QCOMPARE(f->countSaid("Diverted around a tree."), std::size_t(4));
    }

    void finishedBehaviorLeavesASafeRobot() {
        QVERIFY(f->spawnNow());
        QSignalSpy finished(&f->session, &RobotSession::behaviorFinished);
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.publish(agent::BehaviorFinished{true, "Landed at the start."});
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        QCOMPARE(finished.size(), 1);
        QCOMPARE(finished.at(0).at(0).toBool(), true);
        QCOMPARE(finished.at(0).at(1).toString(), QString("Landed at the start."));
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 1);
        QVERIFY2(f->server.heardOf("DRIVE").at(0).contains("{AltitudeVelocity 0}"), f->server.heardOf("DRIVE").at(0));
        QVERIFY(!f->session.figures().behavior_running);
        QVERIFY(f->tickNow());
        QCOMPARE(script->ticks, 1);
    }

    /// A limit counts from the start of each behavior, however long the robot has stood before.
    void aBehaviorIsEndedAtItsLimit() {
        QVERIFY(f->spawnNow());
        QSignalSpy finished(&f->session, &RobotSession::behaviorFinished);
        f->session.setFlightLimit(Seconds{2.0});
        for (int flight = 1; flight <= 2; ++flight) {
            for (int i = 0; i < 15; ++i)
                QVERIFY(f->tickNow()); // 3 s without a behavior.
            f->session.startBehavior(hostOf(script), task);
            const double start_s = f->server.time_s();
            while (f->server.time_s() < start_s + 1.9)
                QVERIFY(f->tickNow());
            QCOMPARE(finished.size(), flight - 1);
            for (int i = 0; i < 2; ++i)
                QVERIFY(f->tickNow());
            QCOMPARE(finished.size(), flight);
            QCOMPARE(finished.back().at(0).toBool(), false);
            QVERIFY(finished.back().at(1).toString().contains("longer than its limit of 2 s"));
        }
    }

    void advisesAboutSensorsThatAreMissing_data() {
        QTest::addColumn<QStringList>("missing");
        QTest::addColumn<QString>("advice");
        QTest::addColumn<int>("said");
        QTest::newRow("on a real server") << QStringList{"RangeScanner"} << "Take USARBot.ini." << 1;
        QTest::newRow("nothing is missing") << QStringList() << "Take USARBot.ini." << 0;
        QTest::newRow("nobody has advice") << QStringList{"RangeScanner"} << "" << 0;
    }
    void advisesAboutSensorsThatAreMissing() {
        QFETCH(const QStringList, missing);
        QFETCH(const QString, advice);
        f->session.setEquipmentAdvice(advice.toStdString());
        QVERIFY(f->spawnNow());
        script->on_tick = [&missing](const agent::Tick&, agent::CommandPort& port) {
            agent::BehaviorFinished end{false, "It cannot begin."};
            for (const QString& sensor : missing)
                end.sensors_missing.push_back(sensor.toStdString());
            port.publish(end);
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        QTEST(int(f->countSaid("Take USARBot.ini.")), "said");
    }

    void stopSendsTheSafeCommandAtOnce() {
        QVERIFY(f->spawnNow());
        QSignalSpy finished(&f->session, &RobotSession::behaviorFinished);
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.forward_m_s = 5.0}, "flying");
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        f->session.stop();
        QCOMPARE(finished.size(), 1);
        QCOMPARE(finished.at(0).at(1).toString(), QString("Stopped by the operator."));
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 2); // no waiting for the next tick
        QVERIFY2(f->server.heardOf("DRIVE").at(1).contains("{LinearVelocity 0}"), f->server.heardOf("DRIVE").at(1));
        f->session.stop(); // twice is as safe as once
        QCOMPARE(finished.size(), 1);
    }

    void closeStopsTheRobotFirst() {
        QVERIFY(f->spawnNow());
        f->session.startBehavior(hostOf(script), task);
        f->session.close();
        QTRY_VERIFY(!f->server.hasClient());
        QCOMPARE(f->server.heardOf("DRIVE").size(), 1);
        QVERIFY(!f->session.figures().spawned);
        QVERIFY(!f->said("lost"));
    }

    void aGroundRobotIsStoppedOnBothSides() {
        QVERIFY(f->spawnNow());
        f->server.say("STA {Type GroundVehicle} {Time 0.40} {FrontSteer 0.0000} {RearSteer 0.0000} {LightToggle False} "
                      "{LightIntensity 0} {Battery 1200}\r\n");
        QTRY_COMPARE(f->session.figures().now.count(), 0.4);
        f->session.stop();
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 1);
        const QByteArray drive = f->server.heardOf("DRIVE").at(0);
        QVERIFY2(drive.contains("{Left 0}") && drive.contains("{Right 0}"), drive);
    }

    void ordersAndParametersReachTheBehavior() {
        QVERIFY(f->spawnNow());
        f->session.order(agent::Order::Pause); // nobody to hear it
        script->on_order = [](agent::Order, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = -1.0}, "landing now");
        };
        f->session.startBehavior(hostOf(script), task);
        f->session.order(agent::Order::LandNow);
        QCOMPARE(script->orders, std::vector{agent::Order::LandNow});
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 1);
        const auto set = agent::ParameterSet::make({{"speed_m_s", "", "", "m/s", 2.0, 0.0, 9.0, "", {}}});
        QVERIFY(set);
        f->session.setParameters(*set);
        QCOMPARE(script->parameters, std::vector{*set});
    }

    void operatorCommandsAreSentAsTheyAre() {
        QVERIFY(f->spawnNow());
        f->session.sendCommand(protocol::RawCommand{"Trace {On true} {Interval 0.5} {Color Red}"},
                               by::Operator{"console"});
        QTRY_COMPARE(f->server.heardOf("Trace"), QList<QByteArray>{"Trace {On true} {Interval 0.5} {Color Red}"});
    }

    void handsOutACopyOfAllThatWasScanned() {
        QVERIFY(f->spawnNow());
        QSignalSpy ready(&f->session, &RobotSession::recordReady);
        f->session.requestRecord();
        QCOMPARE(ready.size(), 1);
        const auto record = ready.at(0).at(0).value<std::shared_ptr<const ScanRecord>>();
        QVERIFY(record && record->raster.empty());
        QCOMPARE(record->level, std::string("tall_test"));
    }

    void saysWhereTheSpawnStands() {
        QCOMPARE(f->session.figures().spawn, SpawnState::None);
        f->server.answers_init = false;
        QVERIFY(f->connectNow());
        f->session.spawn(requestFor("R1"));
        QCOMPARE(f->session.figures().spawn, SpawnState::Asked);
        f->server.tick();
        QTRY_COMPARE(f->session.figures().spawn, SpawnState::Done);
        QVERIFY(f->session.figures().spawned);
        f->session.close();
        QCOMPARE(f->session.figures().spawn, SpawnState::None);
        QVERIFY(!f->session.figures().spawned);
    }

    void theRevisionGrowsWithWhatIsWorthSaving() {
        QVERIFY(f->spawnNow());
        const auto publish = [&](const agent::Published& value) {
            script->on_tick = [value](const agent::Tick& tick, agent::CommandPort& port) {
                if (std::holds_alternative<agent::ScanPlacement>(value))
                    port.publish(agent::ScanPlacement{tick.robot.sensors.scan()->line,
                                                      {.position_m = {0, 0, 5}, .pitch_rad = 1.57}});
                else
                    port.publish(value);
            };
            return f->tickNow() ? f->session.record().revision : 0;
        };
        f->session.startBehavior(hostOf(script), task);
        QCOMPARE(publish(lowRiskAt(Seconds{1.0})), std::uint64_t(0)); // without a map there is nothing to save
        const auto scanned = publish(agent::ScanPlacement{});
        QVERIFY(scanned > 0);
        const auto marked = publish(lowRiskAt(Seconds{2.0}));
        QVERIFY(marked > scanned);
        const auto moved = publish(agent::PoseEstimate{Seconds{2.0}, {.position_m = {3.0, 0.0, 2.0}}});
        QVERIFY(moved > marked);
        const auto charged = publish(scanningWithCharges(2));
        QVERIFY(charged > moved);
        agent::BehaviorStatus later = scanningWithCharges(2);
        later.elapsed = Seconds{9.0};
        QCOMPARE(publish(later), charged);
        QCOMPARE(f->session.figures().record_revision, charged);
        QCOMPARE(f->session.snapshot().revision, charged);
        QVERIFY(publish(agent::ScanPlacement{}) > charged);
    }

private:
    std::unique_ptr<SessionFixture> f;
    std::shared_ptr<Script> script;
    const agent::Task task{"R1", {}, {{0, 0}, {10, 5}}};

    /// A behavior that says in that tick that its plan stands still, and goes on when it is told to.
    void haltAt(int at_tick) {
        script->on_tick = [this, at_tick](const agent::Tick&, agent::CommandPort& port) {
            if (script->ticks < at_tick)
                return port.send(protocol::AerialDrive{.climb_m_s = 1.0}, "rising");
            if (script->ticks > at_tick)
                return;
            port.send(script->safe, "halted");
            port.publish(agent::PlanHalted{.reason = "as asked"});
        };
        script->on_control = [](const agent::PlanControl& control, agent::CommandPort& port) {
            if (!std::holds_alternative<agent::PlanStep>(control))
                return;
            port.send(protocol::AerialDrive{.climb_m_s = 1.0}, "rising again");
            port.publish(agent::PlanResumed{});
        };
    }
};

USAR_TEST(tst_RobotSession)

} // namespace tst_robot_session

#include "tst_robot_session.moc"
