#include <atomic>
#include <thread>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/watched_behavior.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/reader.h"
#include "tests/doubles/scripted_behavior.h"
#include "tests/suite/suite.h"

namespace tst_watched_behavior {

using namespace usar;
using namespace usar::agent;
using usar::test::Script;
using usar::test::ScriptedBehavior;

namespace {

protocol::InfoLine stateLine(std::uint64_t number, double time_s) {
    protocol::RobotState state;
    state.time = Seconds(time_s);
    return {LineNumber{number}, "STA", state, {}};
}

WatchedBehavior watched(const std::shared_ptr<Script>& script) {
    return WatchedBehavior(std::make_unique<BehaviorHost>(std::make_unique<ScriptedBehavior>(script), "test/scripted"));
}

/// Lines of two ticks as they come from a server, from number 5 on.
const std::vector<std::string_view> two_ticks{"SEN {Time 1.0} {Type Sonar} {Name F1 Range 4.56}",
                                              "STA {Type AerialVehicle} {Time 1.0}", "this is no line of the protocol",
                                              "STA {Type AerialVehicle} {Time 1.2}"};
constexpr std::uint64_t first_number = 5;

/// What a behavior answers to these lines, each as text; `expected`: it is told before which lines will come.
std::vector<std::string> answersTo(RunningBehavior& behavior, bool expected) {
    std::vector<std::string> answers;
    behavior.begin();
    if (expected)
        behavior.expect({first_number}, two_ticks);
    protocol::Reader reader;
    reader.continueAfter({first_number - 1});
    for (const std::string_view text : two_ticks) {
        std::string all = std::to_string(answers.size());
        const auto output = behavior.receive(reader.read(text));
        for (const CausedCommand& command : output.commands)
            all += " " + protocol::write(command.command) + " " + toText(command.cause.source) + " " +
                   std::to_string(command.cause.trigger.value);
        all += " published " + std::to_string(output.published.size()) + " safe " +
               protocol::write(behavior.safeCommand({}).command);
        answers.push_back(all);
    }
    return answers;
}

/// Climbs faster at each tick, is safe at what it did last, and talks about each line.
void letItClimb(Script& script) {
    script.on_info = [](const protocol::InfoLine& line, CommandPort& port) {
        port.publish(BehaviorEvent{Severity::Note, line.text});
    };
    script.on_tick = [&script](const Tick& tick, CommandPort& port) {
        script.safe = protocol::AerialDrive{tick.now.count(), {}, {}, {}};
        port.send(script.safe, "climbing");
    };
}

} // namespace

class tst_WatchedBehavior : public QObject {
    Q_OBJECT

    std::shared_ptr<Script> script; ///< a new one for each, for one that hangs is not done with the old one

private slots:
    void init() { script = std::make_shared<Script>(); }

    void answersAsInTheThreadOfItsOwner() {
        std::thread::id decided_in;
        script->on_tick = [&](const Tick& tick, CommandPort& port) {
            decided_in = std::this_thread::get_id();
            port.send(protocol::AerialDrive{tick.now.count(), {}, {}, {}}, "climbing");
            port.publish(BehaviorEvent{Severity::Note, "up"});
        };
        auto behavior = watched(script);
        QVERIFY(behavior.begin().commands.empty());
        const auto output = behavior.receive(stateLine(7, 1.5));
        QCOMPARE(output.commands.size(), std::size_t(1));
        QVERIFY(output.commands[0].command == protocol::Command(protocol::AerialDrive{1.5, {}, {}, {}}));
        QCOMPARE(toText(output.commands[0].cause.source), std::string("test/scripted: climbing"));
        QCOMPARE(output.commands[0].cause.trigger.value, std::uint64_t(7));
        QCOMPARE(output.published.size(), std::size_t(1));
        QVERIFY(decided_in != std::this_thread::get_id());
    }

    void aHangingBehaviorIsGivenUpWithItsOwnSafeCommand_data() {
        QTest::addColumn<QString>("call");
        QTest::addColumn<QString>("words");
        QTest::newRow("in a line") << "line"
                                   << "has not come back from line 2";
        QTest::newRow("in a tick") << "tick"
                                   << "has not come back from line 2";
        QTest::newRow("in an order") << "order"
                                     << "has not come back from an order";
        QTest::newRow("in a change of its plan") << "control"
                                                 << "has not come back from a change of its plan";
    }
    void aHangingBehaviorIsGivenUpWithItsOwnSafeCommand() {
        QFETCH(QString, call);
        QFETCH(QString, words);
        const auto let_go = std::make_shared<std::atomic<bool>>(false);
        const auto hang = [let_go] {
            while (!*let_go)
                std::this_thread::yield();
        };
        script->safe = protocol::SkidDrive{0.0, 0.0};
        auto behavior = watched(script);
        behavior.setPatience(Seconds{0.2});
        behavior.begin();
        behavior.receive(stateLine(1, 1.0));
        // Its thread outlives the test, so it shares no text of Qt's with it.
        const bool in_line = call == "line";
        const bool in_tick = call == "tick";
        script->on_info = [=](const protocol::InfoLine&, CommandPort&) { in_line ? hang() : void(); };
        script->on_tick = [=](const Tick&, CommandPort&) { in_tick ? hang() : void(); };
        script->on_order = [=](Order, CommandPort&) { hang(); };
        script->on_control = [=](const PlanControl&, CommandPort&) { hang(); };

        QElapsedTimer timer;
        timer.start();
        const auto output = call == "order"     ? behavior.order(Order::Pause)
                            : call == "control" ? behavior.control(PlanStep::Halt)
                                                : behavior.receive(stateLine(2, 1.2));
        QVERIFY(timer.elapsed() >= 190);
        QVERIFY(behavior.finished());
        QCOMPARE(output.commands.size(), std::size_t(1));
        QVERIFY(output.commands[0].command == protocol::Command(protocol::SkidDrive{0.0, 0.0}));
        const auto& finished = std::get<BehaviorFinished>(output.published.back());
        QVERIFY(!finished.success);
        const QString reason = QString::fromStdString(finished.reason);
        QVERIFY2(reason.contains("test/scripted hangs") && reason.contains(words), qPrintable(reason));
        QVERIFY(behavior.receive(stateLine(3, 1.4)).commands.empty()); // it is left alone
        QVERIFY(behavior.safeCommand(by::Other{"operator"}).command ==
                protocol::Command(protocol::SkidDrive{0.0, 0.0}));
        *let_go = true;
    }

    void linesThatItExpectsAreAnsweredAsIfTheyCameAlone() {
        letItClimb(*script);
        BehaviorHost in_this_thread(std::make_unique<ScriptedBehavior>(script), "test/scripted");
        const auto answers = answersTo(in_this_thread, false);
        QVERIFY2(answers[3].find("climbing") != std::string::npos, answers[3].c_str());
        const auto lines = std::exchange(script->lines, {});
        script->safe = Script().safe;
        auto behavior = watched(script);
        QCOMPARE(answersTo(behavior, true), answers);
        QCOMPARE(script->lines, lines);
    }

    void anExpectedLineInWhichItHangsIsNamed() {
        const auto let_go = std::make_shared<std::atomic<bool>>(false);
        script->on_tick = [let_go](const Tick& tick, CommandPort& port) {
            port.send(protocol::AerialDrive{1.0, {}, {}, {}}, "climbing");
            while (tick.now > Seconds{1.1} && !*let_go)
                std::this_thread::yield();
        };
        auto behavior = watched(script);
        behavior.setPatience(Seconds{0.2});
        behavior.begin();
        behavior.expect({first_number}, two_ticks);
        protocol::Reader reader;
        reader.continueAfter({first_number - 1});
        for (int i = 0; i < 3; ++i) {
            behavior.receive(reader.read(two_ticks[static_cast<std::size_t>(i)]));
            QVERIFY(!behavior.finished());
        }
        const auto output = behavior.receive(reader.read(two_ticks[3]));
        QVERIFY(behavior.finished() && behavior.broke());
        const QString reason = QString::fromStdString(std::get<BehaviorFinished>(output.published.back()).reason);
        QVERIFY2(reason.contains("has not come back from line 8"), qPrintable(reason));
        behavior.expect({9}, two_ticks); // It is left alone.
        QVERIFY(behavior.receive(reader.read(two_ticks[3])).commands.empty());
        *let_go = true;
    }

    void expectedLinesThatDoNotComeAreNoAnswerToOthers() {
        letItClimb(*script);
        auto behavior = watched(script);
        behavior.begin();
        behavior.expect({first_number}, two_ticks);
        protocol::Reader reader;
        reader.continueAfter({first_number - 1});
        behavior.receive(reader.read(two_ticks[0]));
        QVERIFY(behavior.order(Order::Pause).commands.empty());
        reader.continueAfter({19});
        const auto output = behavior.receive(reader.read("STA {Type AerialVehicle} {Time 7}"));
        QCOMPARE(output.commands.size(), std::size_t(1));
        QVERIFY(output.commands[0].command == protocol::Command(protocol::AerialDrive{7.0, {}, {}, {}}));
        QCOMPARE(output.commands[0].cause.trigger.value, std::uint64_t(20));
    }

    void newParametersReachItAndAThrowAfterThemIsSaid() {
        auto behavior = watched(script);
        behavior.begin();
        script->on_tick = [](const Tick&, CommandPort&) { throw std::runtime_error("lost my way"); };
        behavior.setParameters(*ParameterSet::make({}));
        QCOMPARE(script->parameters.size(), std::size_t(1));
        const auto output = behavior.receive(stateLine(1, 1.0));
        QVERIFY(std::get<BehaviorFinished>(output.published.back()).reason.find("lost my way") != std::string::npos);
        QVERIFY(behavior.finished());
    }

    void isHaltedAsItsBehaviorIs() {
        script->on_tick = [](const Tick&, CommandPort& port) { port.publish(PlanHalted{}); };
        auto behavior = watched(script);
        behavior.begin();
        QVERIFY(!behavior.halted());
        behavior.receive(stateLine(1, 1.0));
        QVERIFY(behavior.halted());
    }
};

USAR_TEST(tst_WatchedBehavior)

} // namespace tst_watched_behavior

#include "tst_watched_behavior.moc"
