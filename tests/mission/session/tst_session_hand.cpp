// Driving by hand through a session: who has control, and every way in which a hold ends with a stop on the wire.
#include <QTest>

#include "core/mission/hand/hand_driver.h"
#include "tests/mission/session/held_robot.h"
#include "tests/suite/suite.h"

namespace tst_session_hand {

using namespace usar;
using namespace usar::mission;
using namespace usar::test;

class tst_SessionHand : public QObject {
    Q_OBJECT
private slots:
    void theFirstHandThatMovesHasTheRobot() {
        using Verdict = HandControl::Verdict;
        HandControl hands;
        QCOMPARE(hands.accept(holding(HandSource::Keys), Seconds(0)), Verdict::Ignored);
        hands.accept(holding(HandSource::Keys, {}), Seconds(0));
        hands.setOn(true);
        QCOMPARE(hands.accept(holding(HandSource::Pad), Seconds(0)), Verdict::Held);
        QCOMPARE(hands.accept(holding(HandSource::Gamepad), Seconds(0)), Verdict::Ignored);
        QCOMPARE(hands.accept(holding(HandSource::Gamepad, {}), Seconds(0)), Verdict::Ignored); // not its hold
        QVERIFY(hands.holding());
        QCOMPARE(hands.accept(holding(HandSource::Pad, {}), Seconds(0)), Verdict::Released);
        QCOMPARE(hands.accept(holding(HandSource::Gamepad), Seconds(0)), Verdict::Held);
        QVERIFY(!hands.overdue(Seconds(0.2), Seconds(0.3)));
        QVERIFY(hands.overdue(Seconds(0.4), Seconds(0.3)));
    }

    void whatWasHeldHasToBeLetGoBeforeItCounts() {
        using Verdict = HandControl::Verdict;
        HandControl hands;
        QCOMPARE(hands.accept(holding(HandSource::Keys), Seconds(0)), Verdict::Ignored); // before there was control
        hands.setOn(true);
        QCOMPARE(hands.accept(holding(HandSource::Keys), Seconds(0)), Verdict::Ignored);
        hands.accept(holding(HandSource::Keys, {}), Seconds(0));
        QCOMPARE(hands.accept(holding(HandSource::Keys), Seconds(0)), Verdict::Held);
        QCOMPARE(hands.accept(holding(HandSource::Pad), Seconds(0)), Verdict::Ignored); // keys have it
        hands.letGo();
        QCOMPARE(hands.accept(holding(HandSource::Keys), Seconds(0)), Verdict::Ignored);
        QCOMPARE(hands.accept(holding(HandSource::Pad), Seconds(0)), Verdict::Ignored);
        hands.accept(holding(HandSource::Pad, {}), Seconds(0));
        QCOMPARE(hands.accept(holding(HandSource::Pad), Seconds(0)), Verdict::Held);
    }

    void nothingDrivesWithoutControl() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        f.session.drive(holding(HandSource::Keys));
        QVERIFY(f.tickNow());
        QVERIFY(f.answersAQuestion()); // which is sent after it
        QVERIFY(f.server.heardOf("DRIVE").isEmpty());
        QCOMPARE(f.session.figures().control.reins, Reins::Nobody);
    }

    void aHeldStickIsSaidAgainWithEveryState() {
        HeldRobot f;
        QVERIFY(f.ready);
        const qsizetype at_first = f.server.heardOf("DRIVE").size();
        int times = 0;
        const auto isWhole = [&] { // risen to the whole, in per cent
            ++times;
            f.session.drive(holding(HandSource::Keys)); // as the window does it
            return lastDrive(f).contains("{LinearVelocity 100}");
        };
        QVERIFY2(QTest::qWaitFor(isWhole), lastDrive(f));
        const qsizetype said = f.server.heardOf("DRIVE").size();
        QVERIFY2(said > at_first + 1 && said <= at_first + times, "it rises in steps, and not faster than it is said");
        for (int i = 0; i < 3; ++i) {
            f.session.drive(holding(HandSource::Keys));
            QVERIFY(f.tickNow());
        }
        QTRY_VERIFY(f.server.heardOf("DRIVE").size() >= said + 3);
        const ControlState control = f.session.figures().control;
        QCOMPARE(control.reins, Reins::Hand);
        QCOMPARE(control.held, std::optional(HandSource::Keys));
        QCOMPARE(control.sent.forward, 1.0);
    }

    void lettingGoStopsAtOnce() {
        HeldRobot f;
        QVERIFY(f.ready);
        f.session.drive(holding(HandSource::Keys, {}));
        QTRY_VERIFY(stopped(f));
        QVERIFY(!f.session.figures().control.held);
        QCOMPARE(f.session.figures().control.last_stop, std::string("the keys were let go"));
        const qsizetype said = f.server.heardOf("DRIVE").size();
        QVERIFY(f.tickNow());
        QVERIFY(f.answersAQuestion());
        QCOMPARE(f.server.heardOf("DRIVE").size(), said); // one stop is enough
    }

    void everyOtherEndOfAHoldStopsToo_data() {
        using End = std::function<void(SessionFixture&)>;
        QTest::addColumn<End>("end");
        QTest::addColumn<bool>("control_stays");
        QTest::newRow("the focus was lost") << End([](SessionFixture& f) { f.session.stopDriving("lost"); }) << true;
        QTest::newRow("given back") << End([](SessionFixture& f) { f.session.giveControlBack(); }) << false;
        QTest::newRow("stop") << End([](SessionFixture& f) { f.session.stop(); }) << false;
        QTest::newRow("a behavior starts")
            << End([](SessionFixture& f) { f.session.startBehavior(hostOf(std::make_shared<Script>()), {}); }) << false;
    }

    void everyOtherEndOfAHoldStopsToo() {
        QFETCH(std::function<void(SessionFixture&)>, end);
        QFETCH(bool, control_stays);
        HeldRobot f;
        QVERIFY(f.ready);
        end(f);
        QTRY_VERIFY(stopped(f));
        QCOMPARE(f.session.figures().control.reins == Reins::Hand, control_stays);
        for (int i = 0; i < 4; ++i) { // the key is still down
            f.session.drive(holding(HandSource::Keys));
            QVERIFY(f.tickNow());
        }
        QVERIFY2(stopped(f), lastDrive(f));
        QVERIFY(!f.session.figures().control.held);
    }

    void aDeadHandIsNoticed() {
        HeldRobot f;
        QVERIFY(f.ready);
        QTRY_VERIFY(stopped(f));
        QCOMPARE(f.session.figures().control.last_stop, std::string("nothing was heard from the input device"));
    }

    void aSilentRobotIsStopped() {
        HeldRobot f;
        QVERIFY(f.ready);
        const auto isStopped = [&] {
            f.session.drive(holding(HandSource::Keys)); // the hand goes on
            return stopped(f);
        };
        QTRY_VERIFY(isStopped());
        QCOMPARE(f.session.figures().control.last_stop, std::string("R1 is silent"));
    }

    void aLostConnectionEndsTheControl() {
        HeldRobot f;
        QVERIFY(f.ready);
        f.server.hangUp();
        QTRY_COMPARE(f.session.figures().control.reins, Reins::Nobody);
        QVERIFY(!f.session.figures().control.held);
    }

    void aBehaviorIsPausedAndItsDrivesDoNotComeThrough() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        const auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = 0.7}, "climbing");
        };
        f.session.startBehavior(hostOf(script), {});
        QVERIFY(f.tickNow());
        QTRY_VERIFY(lastDrive(f).contains("{AltitudeVelocity 0.7}"));
        f.session.takeControl();
        QTRY_VERIFY(stopped(f));
        QCOMPARE(script->orders, std::vector{agent::Order::Pause});
        QVERIFY(f.said("is paused"));
        const int ticks = script->ticks;
        QVERIFY(f.tickNow() && f.tickNow());
        QVERIFY(script->ticks > ticks); // it goes on seeing
        QVERIFY2(stopped(f), lastDrive(f));
        const ControlState control = f.session.figures().control;
        QCOMPARE(control.reins, Reins::Hand);
        QCOMPARE(control.behavior_id, std::string("test/scripted"));
    }

    void aResumedBehaviorTakesTheRobotBack() {
        SessionFixture f(SessionFixture::patientLimits());
        QVERIFY(f.spawnNow());
        const auto script = std::make_shared<Script>();
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = 0.7}, "climbing");
        };
        f.session.startBehavior(hostOf(script), {});
        f.session.takeControl();
        f.session.drive(holding(HandSource::Pad));
        f.session.order(agent::Order::Resume);
        QTRY_VERIFY(stopped(f));
        QCOMPARE(f.session.figures().control.reins, Reins::Behavior);
        QVERIFY(f.tickNow() && f.tickNow());
        QTRY_VERIFY2(lastDrive(f).contains("{AltitudeVelocity 0.7}"), lastDrive(f));
    }

    void theCauseOnTheRecordNamesTheHand() {
        SessionFixture f(SessionFixture::patientLimits());
        std::vector<std::string> sources;
        QObject::connect(&f.session, &RobotSession::updated, &f.session, [&](const auto& update) {
            for (const SentCommand& command : update->commands)
                if (protocol::isDrive(command.command))
                    sources.push_back(toText(command.cause.source));
        });
        QVERIFY(f.spawnNow());
        f.session.takeControl();
        f.session.drive({.source = HandSource::Gamepad, .device = "Trusty", .stick = {.up = 1.0}});
        f.session.drive({.source = HandSource::Gamepad, .device = "Trusty"});
        QTRY_COMPARE(sources.size(), std::size_t{3});
        QCOMPARE(sources[0], std::string("by hand: control taken"));
        QCOMPARE(sources[1], std::string("by hand: gamepad Trusty"));
        QCOMPARE(sources[2], std::string("by hand: stop, the gamepad was let go"));
    }

    void theRobotIsAskedHowItIsDriven() {
        SessionFixture f(SessionFixture::patientLimits());
        f.server.on_command = [&f](const QByteArray& line) {
            if (line.startsWith("GETCONF"))
                f.server.say(
                    "CONF {Type AerialVehicle} {Name AirRobot} {SteeringType RotaryWing} {MaxLateralVelocity 2} "
                    "{MaxLinearVelocity 3} {MaxAltitudeVelocity 1} {MaxRotationalVelocity 1.5}\r\n");
        };
        QVERIFY(f.spawnNow());
        QVERIFY(f.server.heardOf("GETCONF").isEmpty()); // only who drives has to know
        f.session.takeControl();
        QTRY_COMPARE(f.session.figures().control.top_speed_m_s, std::optional(3.0));
        QCOMPARE(f.server.heardOf("GETCONF"), QList<QByteArray>{"GETCONF {Type Robot}"});
        QVERIFY(f.tickNow());
        QTRY_COMPARE(f.server.heardOf("GETGEO").size(), 1);
    }
};

USAR_TEST(tst_SessionHand)

} // namespace tst_session_hand

#include "tst_session_hand.moc"
