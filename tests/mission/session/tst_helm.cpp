// Who moves the robot and what is sent for them, without a socket.
#include <QTest>

#include "core/mission/session/helm.h"
#include "tests/doubles/scripted_behavior.h"
#include "tests/mission/session/session_parts.h"
#include "tests/suite/suite.h"

namespace tst_helm {

using namespace usar;
using namespace usar::mission;
using namespace usar::test;

namespace {

constexpr const char* zero = "DRIVE {AltitudeVelocity 0} {LinearVelocity 0} {LateralVelocity 0} {RotationalVelocity 0}";

/// A spawned AirRobot whose lines the test writes, and whose session writes down what it is told.
struct Bridge : HelmOwner, NoticeBook {
    Bridge() {
        incoming.beginConnection();
        spawning.beginConnection();
        helm.beginConnection();
        spawning.ask({.robot_name = "R1", .start_in_map = {}}, true, wall());
        spawning.heard();
        state(1.0);
        lines.clear();
    }

    void writeLine(const agent::CausedCommand& command, std::string text) override {
        lines << QString::fromStdString(text).remove(" {Normalized false}").remove(" {Normalized true}");
        causes << QString::fromStdString(toText(command.cause.source));
    }
    void flush() override {}
    bool connected() const override { return is_connected; }
    bool replaying() const override { return is_replay; }
    bool congested() const override { return is_congested; }
    void takePublished(const std::vector<agent::Published>& published) override {
        for (const agent::Published& value : published) {
            if (std::holds_alternative<agent::PlanReplaced>(value))
                ++plans_refused;
            if (const auto* finished = std::get_if<agent::BehaviorFinished>(&value)) {
                helm.makeSafe(by::Session{"behavior finished"});
                finishBehavior(*finished, true);
            }
        }
    }
    void finishBehavior(const agent::BehaviorFinished& finished, bool) override {
        ended << QString::fromStdString(finished.reason);
        helm.dismiss();
    }
    void touched() override {}
    Seconds wall() const override { return now_by_wall; }

    /// A STA with this time comes.
    void state(double time_s) {
        const std::string text = "STA {Type AerialVehicle} {Time " + std::to_string(time_s) + "} {Battery 1200}";
        const protocol::InfoLine& line = incoming.take(text);
        helm.hear(text, line);
        helm.answer(line);
    }
    /// A behavior that flies forward at this speed at every tick.
    std::shared_ptr<Script> fly(double forward_m_s) {
        auto script = std::make_shared<Script>();
        script->on_tick = [forward_m_s](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{0.0, forward_m_s, 0.0, 0.0}, "flying");
        };
        helm.start(hostOf(script));
        return script;
    }
    void hold(double forward) { helm.drive({.source = HandSource::Keys, .stick = {.forward = forward}}); }
    SessionFigures figures() const {
        SessionFigures figures;
        helm.describe(figures);
        return figures;
    }

    QStringList lines;
    QStringList causes;
    QStringList ended;
    int plans_refused = 0;
    Seconds now_by_wall{100.0};
    bool is_connected = true;
    bool is_replay = false;
    bool is_congested = false;
    QObject thread_owner;
    Incoming incoming;
    SpawnScribe scribe;
    SpawnLife spawning{scribe, notices};
    Vigil vigil{notices};
    Helm helm{thread_owner, *this, {incoming, spawning, notices, vigil}};
};

} // namespace

class tst_Helm : public QObject {
    Q_OBJECT
private slots:
    void aBehaviorDrivesAtEachState() {
        Bridge b;
        b.fly(2.0);
        b.state(1.2);
        b.state(1.4);
        QCOMPARE(b.lines.size(), 2);
        QVERIFY(b.lines.last().contains("{LinearVelocity 2}"));
        QCOMPARE(b.causes.last(), QString("test/scripted: flying"));
        QCOMPARE(b.figures().control.reins, Reins::Behavior);
        QCOMPARE(b.figures().control.behavior_id, std::string("test/scripted"));
        QCOMPARE(b.figures().steps_sent, std::uint64_t(0));
    }

    void lockstepAnswersWithCommandsThenStep() {
        Bridge b;
        b.helm.setLockstep(true);
        b.fly(2.0);
        b.state(1.2);
        QCOMPARE(b.lines.size(), 2);
        QVERIFY(b.lines.front().startsWith("DRIVE"));
        QCOMPARE(b.lines.back(), QString("STEP"));
        QCOMPARE(b.causes.back(), QString("session: lockstep"));
        QCOMPARE(b.figures().steps_sent, std::uint64_t(1));
        b.helm.loseConnection();
        b.state(1.4);
        QVERIFY(b.lines.back() != "STEP");
    }

    void aBehaviorThatIsDismissedInItsLastTickStillGetsItsStep() {
        Bridge b;
        b.helm.setLockstep(true);
        auto script = b.fly(2.0);
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.publish(agent::BehaviorFinished{true, "Done."});
        };
        b.state(1.2);
        QCOMPARE(b.ended, QStringList{"Done."});
        QCOMPARE(b.lines, (QStringList{zero, "STEP"})); // time stands still until everybody knows of the end
        QVERIFY(!b.helm.hasBehavior());
    }

    void aCongestedLinkHoldsDrivesBack() {
        Bridge b;
        b.is_congested = true;
        b.fly(2.0);
        b.state(1.2);
        b.state(1.4);
        b.helm.look();
        QVERIFY(b.lines.isEmpty());
        QCOMPARE(b.figures().traffic.drives_replaced, std::uint64_t(1));
        b.helm.makeSafe(by::Other{"test"}); // does not wait
        QCOMPARE(b.lines, QStringList{zero});
    }

    void makingSafeDropsWhatWaits() {
        Bridge b;
        b.is_congested = true;
        b.helm.sendForUser(protocol::AerialDrive{0.0, 5.0, 0.0, 0.0}, by::Other{"test"});
        b.is_congested = false;
        b.helm.stopBehavior(by::Operator{"stop"}, "Stopped by the operator.");
        QCOMPARE(b.lines, QStringList{zero});
        QCOMPARE(b.causes, QStringList{"operator: stop"});
        QVERIFY(b.ended.isEmpty()); // there was none
    }

    void nothingIsSentToARobotThatIsNotThere_data() {
        using Case = std::function<void(Bridge&)>;
        QTest::addColumn<Case>("arrange");
        QTest::newRow("a replay") << Case([](Bridge& b) { b.is_replay = true; });
        QTest::newRow("no robot") << Case([](Bridge& b) { b.spawning.end(); });
    }

    void nothingIsSentToARobotThatIsNotThere() {
        QFETCH(std::function<void(Bridge&)>, arrange);
        Bridge b;
        b.helm.takeControl();
        b.hold(1.0);
        b.lines.clear();
        arrange(b);
        b.helm.makeSafe(by::Other{"test"});
        b.helm.endControl("test");
        QVERIFY2(b.lines.isEmpty(), qPrintable(b.lines.join('\n')));
        QCOMPARE(b.figures().control.last_stop, std::string());
        QCOMPARE(b.figures().control.reins, Reins::Nobody);
    }

    void aHandTakesTheReins() {
        Bridge b;
        const auto script = b.fly(2.0);
        b.helm.takeControl();
        QCOMPARE(script->orders, std::vector{agent::Order::Pause});
        QVERIFY(b.saidWords("You are driving. The behavior test/scripted is paused"));
        QVERIFY(b.lines.contains(zero));
        QVERIFY(b.causes.contains("by hand: how it is driven"));
        b.lines.clear();
        b.state(1.2);
        QVERIFY2(b.lines.filter("LinearVelocity").isEmpty(), "the behavior's drives do not come through");
        b.hold(1.0);
        QVERIFY2(!b.lines.filter("LinearVelocity").isEmpty(), "the hand's do");
        QCOMPARE(b.causes.last(), QString("by hand: keys"));
        QCOMPARE(b.figures().control.reins, Reins::Hand);
    }

    void aHoldEndsWithAStop() {
        Bridge b;
        b.helm.takeControl();
        b.hold(1.0);
        b.hold(0.0);
        QCOMPARE(b.causes.last(), QString("by hand: stop, the keys were let go"));
        QVERIFY(b.figures().control.reins == Reins::Hand);
        b.helm.endControl("control was given back");
        QCOMPARE(b.figures().control.reins, Reins::Nobody);
        QCOMPARE(b.causes.last(), QString("by hand: stop, control was given back"));
    }

    void aResumedBehaviorEndsTheControl() {
        Bridge b;
        b.fly(2.0);
        b.helm.takeControl();
        b.helm.order(agent::Order::Pause);
        QCOMPARE(b.figures().control.reins, Reins::Hand);
        b.helm.order(agent::Order::Resume);
        QCOMPARE(b.figures().control.reins, Reins::Behavior);
        QCOMPARE(b.causes.last(), QString("by hand: stop, the behavior test/scripted took over"));
    }

    void withoutABehaviorAPlanIsRefused() {
        Bridge b;
        b.helm.control(agent::ReplacePlan{});
        QCOMPARE(b.plans_refused, 1);
    }

    void replayedStepsAreCounted() {
        Bridge b;
        b.helm.sawSent(protocol::Step{});
        b.helm.sawSent(protocol::GetStartPoses{});
        b.helm.sawSent(protocol::Step{});
        QCOMPARE(b.figures().steps_sent, std::uint64_t(2));
        b.helm.rewind();
        QCOMPARE(b.figures().steps_sent, std::uint64_t(0));
        QVERIFY(b.lines.isEmpty());
    }

    void aStandingClockHoldsNoDrives() {
        Bridge b;
        b.helm.sendForUser(protocol::AerialDrive{0.0, 1.0, 0.0, 0.0}, by::Other{"test"});
        b.helm.sendForUser(protocol::AerialDrive{0.0, 2.0, 0.0, 0.0}, by::Other{"test"});
        QCOMPARE(b.lines.size(), 1);
        b.helm.look();
        QCOMPARE(b.lines.size(), 2);
        QVERIFY(b.lines.last().contains("{LinearVelocity 2}"));
    }
};

USAR_TEST(tst_Helm)

} // namespace tst_helm

#include "tst_helm.moc"
