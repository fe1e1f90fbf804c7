#include <functional>
#include <stdexcept>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/agent/behavior_host.h"
#include "tests/suite/suite.h"

namespace tst_behavior_host {

using namespace usar;
using namespace usar::agent;

namespace {

/// What happened to a scripted behavior; it outlives the behavior.
struct Script {
    std::vector<std::string> calls;
    std::function<void(const Tick&, CommandPort&)> on_tick;
    std::function<void(CommandPort&)> on_info;
    std::function<void()> on_parameters;
    bool safe_throws = false;
};

class ScriptedBehavior : public Behavior {
public:
    explicit ScriptedBehavior(Script& script) : script_(script) {}
    void onInfo(const protocol::InfoLine&, CommandPort& port) override {
        script_.calls.push_back("info");
        if (script_.on_info)
            script_.on_info(port);
    }
    void tick(const Tick& tick, CommandPort& port) override {
        script_.calls.push_back("tick");
        if (script_.on_tick)
            script_.on_tick(tick, port);
    }
    void order(Order, CommandPort& port) override {
        script_.calls.push_back("order");
        port.send(protocol::AerialDrive{0.0, {}, {}, {}}, "ordered");
    }
    void setParameters(const ParameterSet&) override {
        script_.calls.push_back("parameters");
        if (script_.on_parameters)
            script_.on_parameters();
    }
    protocol::Command safeCommand() const override {
        if (script_.safe_throws)
            throw std::runtime_error("not even that");
        return protocol::AerialDrive{0.0, 0.0, 0.0, 0.0};
    }

private:
    Script& script_;
};

protocol::InfoLine state(std::uint64_t number, double time_s) {
    protocol::RobotState state;
    state.time = Seconds(time_s);
    return {LineNumber{number}, "", state, {}};
}

protocol::InfoLine ins(std::uint64_t number) {
    return {LineNumber{number}, "", protocol::InsReading{{}, "INS", Pose{Vec3(1, 2, 3), 0, 0, 0}}, {}};
}

} // namespace

class tst_BehaviorHost : public QObject {
    Q_OBJECT

    Script script;
    std::unique_ptr<BehaviorHost> host;

private slots:
    void init() {
        script = {};
        host = std::make_unique<BehaviorHost>(std::make_unique<ScriptedBehavior>(script), "test/scripted");
    }

    void aBehaviorWithoutAPlanRefusesOne() {
        const auto output = host->control(ReplacePlan{{"new.lap", "((DC d (drives ((a b)))))"}});
        QCOMPARE(output.published.size(), std::size_t(1));
        const auto& news = std::get<PlanReplaced>(output.published.front());
        QCOMPARE(news.fate, PlanFate::Refused);
        QVERIFY(!news.reason.empty());
        QVERIFY(host->control(PlanStep::Halt).published.empty());
        QVERIFY(!host->halted());
    }

    void isHaltedUntilItsPlanGoesOnOrEnds() {
        std::vector<Published> say;
        script.on_tick = [&](const Tick&, CommandPort& port) {
            for (const Published& value : say)
                port.publish(value);
        };
        const auto haltedAfter = [&](std::uint64_t line, std::vector<Published> values) {
            say = std::move(values);
            host->receive(state(line, static_cast<double>(line)));
            return host->halted();
        };
        QVERIFY(haltedAfter(1, {PlanHalted{}}));
        QVERIFY(haltedAfter(2, {}));
        QVERIFY(!haltedAfter(3, {PlanResumed{}}));
        QVERIFY(!haltedAfter(4, {PlanHalted{}, BehaviorFinished{}}));
    }

    void ticksOnEveryStateAndTellsEveryLineFirst() {
        host->receive(ins(1));
        host->receive(state(2, 10.0));
        QCOMPARE(script.calls, (std::vector<std::string>{"info", "info", "tick"}));
    }

    void givesTheTickItsTimeLineAndModules() {
        bool seen = false;
        script.on_tick = [&](const Tick& tick, CommandPort&) {
            QCOMPARE(tick.now.count(), 10.5);
            QCOMPARE(tick.line.value, std::uint64_t(2));
            QVERIFY(tick.robot.sensors.ins());
            QCOMPARE(tick.robot.sensors.ins()->value.base_in_map.position_m.y(), 2.0);
            seen = true;
        };
        host->receive(ins(1));
        host->receive(state(2, 10.5));
        QVERIFY(seen);
    }

    void stampsCommandsWithTheDeciderAndTheLine() {
        script.on_tick = [](const Tick&, CommandPort& port) {
            port.send(protocol::AerialDrive{1.0, {}, {}, {}}, "taking off");
        };
        const auto output = host->receive(state(7, 1.0));
        QCOMPARE(output.commands.size(), std::size_t(1));
        QCOMPARE(toText(output.commands[0].cause.source), std::string("test/scripted: taking off"));
        QCOMPARE(output.commands[0].cause.trigger.value, std::uint64_t(7));
    }

    void stampsOrdersWithTheLastLine() {
        host->receive(state(7, 1.0));
        const auto output = host->order(Order::Pause);
        QCOMPARE(output.commands.size(), std::size_t(1));
        QCOMPARE(output.commands[0].cause.trigger.value, std::uint64_t(7));
    }

    void sendsTheQuestionsOneByOne() {
        script.on_tick = [](const Tick& tick, CommandPort&) {
            tick.robot.geometry.query("Sonar");
            tick.robot.geometry.query("RangeScanner");
        };
        const auto first = host->receive(state(1, 1.0));
        QCOMPARE(first.commands.size(), std::size_t(1));
        QCOMPARE(std::get<protocol::GetGeometry>(first.commands[0].command).type, std::string("Sonar"));
        const auto waiting = host->receive(state(2, 1.2));
        QVERIFY(waiting.commands.empty());
        protocol::GeometryInfo answer;
        answer.type = "Sonar";
        answer.items.push_back({"F1", {}, "HARD"});
        const auto next = host->receive({LineNumber{3}, "", answer, {}});
        QCOMPARE(next.commands.size(), std::size_t(1));
        QCOMPARE(std::get<protocol::GetGeometry>(next.commands[0].command).type, std::string("RangeScanner"));
    }

    void stopsABehaviorThatThrows_data() {
        QTest::addColumn<bool>("standard");
        QTest::newRow("a standard exception") << true;
        QTest::newRow("anything else") << false;
    }
    void stopsABehaviorThatThrows() {
        QFETCH(bool, standard);
        script.on_tick = [=](const Tick&, CommandPort& port) {
            port.send(protocol::AerialDrive{2.0, {}, {}, {}}, "wild");
            if (standard)
                throw std::runtime_error("lost my way");
            throw 42;
        };
        const auto output = host->receive(state(5, 1.0));
        QVERIFY(host->finished());
        QCOMPARE(output.commands.size(), std::size_t(1));
        QVERIFY(output.commands[0].command == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        const auto& finished = std::get<BehaviorFinished>(output.published.at(0));
        QVERIFY(!finished.success);
        if (standard)
            QVERIFY(finished.reason.find("lost my way") != std::string::npos);
        QVERIFY(host->receive(state(6, 1.2)).commands.empty());
    }

    void saysAtTheNextCallWhatParametersThrew() {
        script.on_parameters = [] { throw std::runtime_error("too fast"); };
        host->setParameters(*ParameterSet::make({}));
        const auto output = host->receive(state(5, 1.0));
        QCOMPARE(output.published.size(), std::size_t(1));
        QVERIFY(std::get<BehaviorFinished>(output.published[0]).reason.find("too fast") != std::string::npos);
    }

    void isStoppedWhereARobotLacksASensorThatItNeeds_data() {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<bool>("stopped");
        QTest::newRow("the server has none") << "none" << true;
        QTest::newRow("the server says nothing") << "silence" << true;
        QTest::newRow("it is there and has nothing to tell") << "there" << false;
        QTest::newRow("it speaks after all") << "speaks" << false;
    }
    void isStoppedWhereARobotLacksASensorThatItNeeds() {
        QFETCH(QString, answer);
        QFETCH(bool, stopped);
        script.on_tick = [](const Tick&, CommandPort& port) {
            port.send(protocol::AerialDrive{2.0, {}, {}, {}}, "up");
        };
        host = std::make_unique<BehaviorHost>(std::make_unique<ScriptedBehavior>(script), "test/scripted",
                                              std::vector<std::string>{"INS", "Touch"});
        std::vector<Published> said;
        std::vector<CausedCommand> last;
        const auto take = [&](const protocol::InfoLine& line) {
            auto output = host->receive(line);
            said.insert(said.end(), output.published.begin(), output.published.end());
            if (!output.commands.empty())
                last = output.commands;
        };
        take(ins(1));
        for (std::uint64_t tick = 2; tick < 60 && !host->finished(); ++tick) {
            take(state(tick, 0.2 * static_cast<double>(tick)));
            const bool asked = std::ranges::any_of(last, [](const CausedCommand& one) {
                const auto* const question = std::get_if<protocol::GetConfiguration>(&one.command);
                return question && question->type == "Touch";
            });
            if (!asked || answer == "silence")
                continue;
            protocol::ConfigurationInfo configuration;
            configuration.type = "Touch";
            if (answer == "there")
                configuration.items.push_back({"Left", {{"Diameter", "0.1"}}});
            if (answer == "speaks")
                take({LineNumber{100}, "", protocol::TouchReadings{{}, {{"Left", true}}}, {}});
            else
                take({LineNumber{100}, "", configuration, {}});
        }
        QCOMPARE(host->finished(), stopped);
        if (!stopped)
            return;
        QVERIFY(last.front().command == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        const std::string reason = std::get<BehaviorFinished>(said.back()).reason;
        QVERIFY2(reason.find("test/scripted needs the sensor Touch") != std::string::npos, reason.c_str());
    }

    /// The user mounts them in one go, so they are not named one by one.
    void namesAllSensorsThatTheRobotLacks() {
        host = std::make_unique<BehaviorHost>(std::make_unique<ScriptedBehavior>(script), "test/scripted",
                                              std::vector<std::string>{"RangeScanner", "INS", "Sonar"});
        std::optional<BehaviorFinished> end;
        for (std::uint64_t tick = 1; tick < 200 && !end; ++tick) {
            if (tick == 2)
                host->receive(ins(1000));
            const auto output = host->receive(state(tick, 0.2 * static_cast<double>(tick)));
            for (const CausedCommand& one : output.commands)
                if (const auto* const question = std::get_if<protocol::GetConfiguration>(&one.command)) {
                    protocol::ConfigurationInfo nothing;
                    nothing.type = question->type;
                    for (const Published& value : host->receive({LineNumber{2000 + tick}, "", nothing, {}}).published)
                        if (const auto* const finished = std::get_if<BehaviorFinished>(&value))
                            end = *finished;
                }
        }
        QVERIFY(end);
        QCOMPARE(end->sensors_missing, (std::vector<std::string>{"RangeScanner", "Sonar"}));
        QVERIFY2(end->reason.find("needs the sensors RangeScanner, Sonar") != std::string::npos, end->reason.c_str());
    }

    void leavesAFinishedBehaviorAlone() {
        script.on_tick = [](const Tick&, CommandPort& port) { port.publish(BehaviorFinished{true, "Done."}); };
        host->receive(state(1, 1.0));
        QVERIFY(host->finished());
        host->receive(state(2, 1.2));
        host->order(Order::LandNow);
        QCOMPARE(script.calls, (std::vector<std::string>{"info", "tick"}));
    }

    void hasASafeCommandWhateverTheBehaviorSays() {
        host->receive(state(9, 1.0));
        script.safe_throws = true;
        const CausedCommand safe = host->safeCommand(by::Other{"operator"});
        QVERIFY(safe.command == protocol::Command(protocol::AerialDrive{0.0, 0.0, 0.0, 0.0}));
        QCOMPARE(toText(safe.cause.source), std::string("operator"));
        QCOMPARE(safe.cause.trigger.value, std::uint64_t(9));
    }

    void theLastResortStopsARobotOfItsKind() {
        const auto lastResort = [this](protocol::VehicleKind kind) {
            protocol::InfoLine line = state(9, 1.0);
            std::get<protocol::RobotState>(line.message).kind = kind;
            host->receive(line);
            return host->safeCommand(by::Other{"operator"}).command;
        };
        script.safe_throws = true;
        QVERIFY(lastResort(protocol::VehicleKind::Ground) == protocol::Command(protocol::SkidDrive{0.0, 0.0}));
        QVERIFY(lastResort(protocol::VehicleKind::Nautic) == protocol::Command(protocol::NauticDrive{0.0, 0.0, 0.0}));
    }
};

USAR_TEST(tst_BehaviorHost)

} // namespace tst_behavior_host

#include "tst_behavior_host.moc"
