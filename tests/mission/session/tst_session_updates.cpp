// Updates of a session: what they contain, in which order, and what is counted.
#include <QSignalSpy>
#include <QTest>

#include "core/mission/session/update_order.h"
#include "tests/mission/session/session_fixture.h"
#include "tests/suite/suite.h"

namespace tst_session_updates {

using namespace usar;
using namespace usar::mission;
using usar::test::hostOf;
using usar::test::Script;
using usar::test::SessionFixture;

class tst_SessionUpdates : public QObject {
    Q_OBJECT
private slots:
    void init() {
        f = std::make_unique<SessionFixture>(SessionFixture::patientLimits());
        script = std::make_shared<Script>();
    }

    void cleanup() { f.reset(); }

    void commandsCarryTheirCause() {
        QVERIFY(f->spawnNow());
        QSignalSpy updates(&f->session, &RobotSession::updated);
        script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
            port.send(protocol::AerialDrive{.climb_m_s = 1.5}, "rising");
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        QTRY_COMPARE(f->server.heardOf("DRIVE").size(), 1);
        const auto sent = [&] {
            for (const QList<QVariant>& update : updates)
                if (const auto value = update.at(0).value<std::shared_ptr<const SessionUpdate>>();
                    !value->commands.empty())
                    return value->commands;
            return std::vector<mission::SentCommand>{};
        };
        QTRY_COMPARE(sent().size(), std::size_t(1));
        QCOMPARE(toText(sent().front().cause.source), std::string("test/scripted: rising"));
        QCOMPARE(sent().front().cause.trigger.value, f->session.figures().lines_received); // the STA
    }

    void updatesAreCoalescedAndBounded() {
        QVERIFY(f->spawnNow());
        QSignalSpy updates(&f->session, &RobotSession::updated);
        const std::uint64_t before = f->session.figures().lines_received;
        sayInsLines(20000);
        QTRY_COMPARE(f->session.figures().lines_received, before + 20000);
        std::uint64_t newest = 0;
        QTRY_VERIFY(
            !updates.isEmpty() &&
            (newest = updates.last().at(0).value<std::shared_ptr<const SessionUpdate>>()->figures.lines_received) ==
                before + 20000);
        for (const QList<QVariant>& update : updates)
            QVERIFY(update.at(0).value<std::shared_ptr<const SessionUpdate>>()->lines.size() <= 4000);
        QVERIFY2(updates.size() < 200, qPrintable(QString::number(updates.size())));
        const auto last = updates.last().at(0).value<std::shared_ptr<const SessionUpdate>>();
        QVERIFY(last->lines.empty() || last->lines.back().number.value == newest);
    }

    void theLastFrameComesBeforeTheEnd_data() {
        QTest::addColumn<QString>("end");
        QTest::newRow("finished by itself") << "itself";
        QTest::newRow("finished after an order") << "order";
        QTest::newRow("stopped by the operator") << "stop";
        QTest::newRow("closed by the operator") << "close";
        QTest::newRow("the link was lost") << "lost";
    }

    void theLastFrameComesBeforeTheEnd() {
        QFETCH(QString, end);
        QVERIFY(f->spawnNow());
        QStringList order;
        int finishes_told = 0;
        std::shared_ptr<const SessionUpdate> last;
        connect(&f->session, &RobotSession::updated, &f->session, [&](const auto& update) {
            last = update;
            for (const agent::Published& value : update->published)
                finishes_told += std::holds_alternative<agent::BehaviorFinished>(value);
            order << "updated";
        });
        connect(&f->session, &RobotSession::behaviorFinished, &f->session, [&] {
            order << "finished";
            QCOMPARE(order.value(order.size() - 2), QString("updated"));
            QVERIFY(!last->figures.behavior_running);
            QVERIFY(!last->published.empty());
            QVERIFY(std::holds_alternative<agent::BehaviorFinished>(last->published.back()));
        });
        if (end == "itself")
            script->on_tick = [](const agent::Tick&, agent::CommandPort& port) {
                port.publish(agent::BehaviorFinished{true, "Landed."});
            };
        script->on_order = [](agent::Order, agent::CommandPort& port) {
            port.publish(agent::BehaviorFinished{true, "Landed."});
        };
        f->session.startBehavior(hostOf(script), task);
        QVERIFY(f->tickNow());
        if (end == "order")
            f->session.order(agent::Order::LandNow);
        else if (end == "stop")
            f->session.stop();
        else if (end == "close")
            f->session.close();
        else if (end == "lost")
            f->server.hangUp();
        QTRY_VERIFY(order.contains("finished"));
        QCOMPARE(last->figures.lines_received, f->session.figures().lines_received);
        QCOMPARE(finishes_told, 1);
        QCOMPARE(order.count("finished"), 1);
    }

    void theFirstLineAndTheFirstQuestionsReachObservers() {
        std::vector<protocol::InfoLine> lines;
        std::vector<agent::CausedCommand> commands;
        connect(&f->session, &RobotSession::updated, &f->session, [&](const auto& update) {
            lines.insert(lines.end(), update->lines.begin(), update->lines.end());
            commands.insert(commands.end(), update->commands.begin(), update->commands.end());
        });
        QVERIFY(f->connectNow(true));
        QTRY_COMPARE(lines.size(), std::size_t(3));
        QVERIFY2(lines.front().text.starts_with("NFO {Gametype"), lines.front().text.c_str());
        QCOMPARE(commands.size(), std::size_t(2));
        QVERIFY(std::holds_alternative<protocol::Lockstep>(commands[0].command));
        QVERIFY(std::holds_alternative<protocol::GetStartPoses>(commands[1].command));
        for (const agent::CausedCommand& command : commands)
            QCOMPARE(toText(command.cause.source), std::string("session: connect"));
    }

    void stepsAreListedWithTheirCause() {
        std::uint64_t steps = 0;
        connect(&f->session, &RobotSession::updated, &f->session, [&](const auto& update) {
            for (const mission::SentCommand& sent : update->commands)
                if (sent.text == "STEP") {
                    QCOMPARE(toText(sent.cause.source), std::string("session: lockstep"));
                    QCOMPARE(sent.cause.trigger, sent.after); // the STA
                    ++steps;
                }
        });
        QVERIFY(f->spawnNow(true));
        QVERIFY(f->tickNow());
        QVERIFY(f->session.figures().steps_sent >= 2);
        QTRY_COMPARE(steps, f->session.figures().steps_sent);
        QTRY_COMPARE(f->server.heardOf("STEP").size(), qsizetype(steps));
    }

    void commandsSayAfterWhichLineTheyWent() {
        std::vector<mission::SentCommand> commands;
        connect(&f->session, &RobotSession::updated, &f->session, [&](const auto& update) {
            commands.insert(commands.end(), update->commands.begin(), update->commands.end());
        });
        QVERIFY(f->spawnNow());
        const LineNumber newest{f->session.figures().lines_received};
        f->session.sendCommand(protocol::RawCommand{"ZOOM {Level 3}"}, by::Operator{"command box"});
        QTRY_COMPARE(commands.back().text, std::string("ZOOM {Level 3}"));
        QCOMPARE(commands.back().after, newest);
        QCOMPARE(commands.back().time.count(), f->session.figures().now.count());
        QCOMPARE(toText(commands.back().cause.source), std::string("operator: command box"));
    }

    void linesAndCommandsAreToldInTheirOrderOnTheWire() {
        SessionUpdate update;
        for (const std::uint64_t number : {3, 5, 6})
            update.lines.emplace_back().number = {number};
        for (const std::uint64_t after : {2, 3, 4, 6})
            update.commands.emplace_back().after = {after};
        QStringList told;
        inOrder(
            update, [&](const protocol::InfoLine& line) { told << QString::number(line.number.value); },
            [&](const SentCommand& command) { told << QString("after %1").arg(command.after.value); });
        QCOMPARE(told, QStringList({"after 2", "3", "after 3", "after 4", "5", "6", "after 6"}));
    }

    void trafficIsCountedAnewOnEachConnection() {
        QVERIFY(f->spawnNow());
        const QByteArray extra = "XYZ {A 1}\r\nSEN {Time 9\r\n";
        const protocol::TrafficCounts before = f->session.figures().traffic;
        QCOMPARE(before.lines_in, f->session.figures().lines_received);
        f->server.say(extra);
        f->session.sendCommand(protocol::RawCommand{"ZOOM"}, by::Other{"test"});
        QTRY_COMPARE(f->session.figures().traffic.lines_in, before.lines_in + 2);
        const protocol::TrafficCounts after = f->session.figures().traffic;
        QCOMPARE(after.bytes_in, before.bytes_in + static_cast<std::uint64_t>(extra.size()));
        QCOMPARE(after.lines_out, before.lines_out + 1);
        QCOMPARE(after.bytes_out, before.bytes_out + 6);
        QCOMPARE(after.unknown, before.unknown + 2);
        QCOMPARE(after.malformed, before.malformed + 1);
        f->server.hangUp();
        QTRY_VERIFY(f->session.linkStatus().state == link::LinkState::Connected &&
                    f->session.figures().traffic.lines_in > 0 &&
                    f->session.figures().traffic.lines_in < before.lines_in);
        QCOMPARE(f->session.figures().traffic.malformed, std::uint64_t(0));
        QCOMPARE(f->session.figures().traffic.unknown, std::uint64_t(0));
        QVERIFY(f->session.figures().lines_received > after.lines_in); // of all connections
    }

    void aDriveThatANewerOneReplacesIsCounted() {
        QVERIFY(f->spawnNow());
        const auto drive = [&](double climb_m_s) {
            f->session.sendCommand(protocol::AerialDrive{.climb_m_s = climb_m_s}, by::Other{"test"});
        };
        drive(1.0); // goes at once
        drive(2.0); // waits
        QCOMPARE(f->session.figures().traffic.drives_replaced, std::uint64_t(0));
        drive(3.0);
        QCOMPARE(f->session.figures().traffic.drives_replaced, std::uint64_t(1));
    }

    void linesLeftOutOfAFrameAreCounted() {
        std::uint64_t shown = 0, not_shown = 0;
        connect(&f->session, &RobotSession::updated, &f->session, [&](const auto& update) {
            shown += update->lines.size();
            not_shown = update->figures.lines_not_shown;
        });
        QVERIFY(f->spawnNow());
        sayInsLines(60000);
        QTRY_VERIFY(f->session.figures().lines_received > 60000);
        QTRY_COMPARE(shown + not_shown, f->session.figures().lines_received);
        QVERIFY(not_shown > 0);
    }

private:
    void sayInsLines(int count) {
        f->server.say(
            QByteArray("SEN {Type INS} {Name INS} {Location 1.00,-2.00,-3.00} {Orientation 0.00,0.00,0.00}\r\n")
                .repeated(count));
    }

    std::unique_ptr<SessionFixture> f;
    std::shared_ptr<Script> script;
    const agent::Task task{"R1", {}, {{0, 0}, {10, 5}}};
};

USAR_TEST(tst_SessionUpdates)

} // namespace tst_session_updates

#include "tst_session_updates.moc"
