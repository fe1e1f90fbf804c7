// What a behavior gives away: commands and values in their order, and the words and colors of its marks.
#include <algorithm>
#include <set>

#include <QTest>

#include "core/agent/behavior.h"
#include "core/agent/mark_style.h"
#include "core/agent/running_behavior.h"
#include "core/protocol/command_writer.h"
#include "core/protocol/zero_drives.h"
#include "tests/agent/toy_rover.h"
#include "tests/plugins/minimal_plugin.h"
#include "tests/suite/suite.h"

namespace tst_behavior_output {

using namespace usar;
using namespace usar::agent;
using protocol::VehicleKind;

namespace {

/// As a behavior gives it; its host adds the id.
by::Source stateOf(const char* state) {
    return by::Behavior{{}, state};
}

} // namespace

class tst_BehaviorOutput : public QObject {
    Q_OBJECT
private slots:
    void commandsComeInOrderWithTheTriggerOfTheirTime() {
        CommandPort port;
        port.send(protocol::SkidDrive{1.0, 2.0}, "before any line");
        port.setTrigger({7});
        port.send(protocol::SkidDrive{3.0, 4.0}, "first");
        port.send(protocol::SkidDrive{5.0, 6.0}, "second");
        port.setTrigger({8});
        port.send(protocol::RawCommand{"PING"}, "third");
        const std::vector<CausedCommand> expected{{protocol::SkidDrive{1.0, 2.0}, {stateOf("before any line"), {}}},
                                                  {protocol::SkidDrive{3.0, 4.0}, {stateOf("first"), {7}}},
                                                  {protocol::SkidDrive{5.0, 6.0}, {stateOf("second"), {7}}},
                                                  {protocol::RawCommand{"PING"}, {stateOf("third"), {8}}}};
        QVERIFY(port.takeCommands() == expected);
        QVERIFY(port.takeCommands().empty());
        port.send(protocol::RawCommand{"PONG"}, "later"); // the trigger stays
        QVERIFY(port.takeCommands().front().cause.trigger == LineNumber{8});
    }

    void valuesComeInOrderAndOnce() {
        CommandPort port;
        port.publish(BehaviorEvent{Severity::Note, "one"});
        port.publish(PlanResumed{});
        port.publish(BehaviorEvent{Severity::Note, "two"});
        const std::vector<Published> expected{BehaviorEvent{Severity::Note, "one"}, PlanResumed{},
                                              BehaviorEvent{Severity::Note, "two"}};
        QVERIFY(port.takeCommands().empty());
        QVERIFY(port.takePublished() == expected);
        QVERIFY(port.takePublished().empty());
    }

    void outputsAreJoinedInOrder() {
        RunningBehavior::Output first{{{protocol::RawCommand{"A"}, {}}}, {PlanResumed{}}};
        first.append({{{protocol::RawCommand{"B"}, {}}}, {BehaviorFinished{true, "Done."}}});
        first.append({});
        const std::vector<CausedCommand> commands{{protocol::RawCommand{"A"}, {}}, {protocol::RawCommand{"B"}, {}}};
        const std::vector<Published> published{PlanResumed{}, BehaviorFinished{true, "Done."}};
        QVERIFY(first.commands == commands);
        QVERIFY(first.published == published);
    }

    void aBehaviorWithoutAPlanRefusesOneAndIgnoresTheRest_data() {
        QTest::addColumn<PlanControl>("control");
        QTest::addColumn<bool>("answered");
        QTest::newRow("a plan") << PlanControl(ReplacePlan{{"new.lap", "((DC d))"}}) << true;
        QTest::newRow("breakpoints") << PlanControl(SetBreakpoints{{{1, {}}}}) << false;
        QTest::newRow("pins") << PlanControl(SetPins{}) << false;
        QTest::newRow("a step") << PlanControl(PlanStep::Cycle) << false;
    }
    void aBehaviorWithoutAPlanRefusesOneAndIgnoresTheRest() {
        QFETCH(PlanControl, control);
        QFETCH(bool, answered);
        test::IdleBehavior behavior;
        CommandPort port;
        behavior.control(control, port);
        QVERIFY(port.takeCommands().empty());
        const std::vector<Published> values = port.takePublished();
        QCOMPARE(values.size(), std::size_t(answered));
        if (!answered)
            return;
        const auto& refused = std::get<PlanReplaced>(values.front());
        QVERIFY(refused.fate == PlanFate::Refused);
        QCOMPARE(refused.plan_name, std::string("new.lap"));
        QCOMPARE(refused.reason, std::string("No plan decides what this behavior does."));
    }

    void theLastResortSuitsTheVehicle_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<std::string>("command");
        const std::string hover = protocol::write(protocol::no_flight);
        QTest::newRow("ground") << int(VehicleKind::Ground) << protocol::write(protocol::no_spin);
        QTest::newRow("water") << int(VehicleKind::Nautic) << protocol::write(protocol::no_thrust);
        QTest::newRow("air") << int(VehicleKind::Aerial) << hover;
        QTest::newRow("legs") << int(VehicleKind::Legged) << hover;
        QTest::newRow("a platform") << int(VehicleKind::StaticPlatform) << hover;
        QTest::newRow("unknown") << int(VehicleKind::Unknown) << hover;
    }
    void theLastResortSuitsTheVehicle() {
        QFETCH(int, kind);
        QFETCH(std::string, command);
        QCOMPARE(protocol::write(lastResort(static_cast<VehicleKind>(kind))), command);
    }

    void everyKindOfMarkLooksAndReadsDifferent() {
        std::set<std::uint32_t> colors;
        std::set<std::string_view> names;
        std::set<std::string_view> words;
        std::set<MarkShape> shapes;
        for (std::size_t i = 0; i < all_mark_kinds.size(); ++i) {
            QCOMPARE(static_cast<std::size_t>(all_mark_kinds[i]), i);
            const MarkStyle& style = styleOf(all_mark_kinds[i]);
            colors.insert(style.rgb);
            names.insert(style.name);
            words.insert(style.word);
            shapes.insert(style.shape);
            QVERIFY(style.rgb <= 0xffffff);
            QVERIFY(style.word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string_view::npos);
        }
        for (const std::size_t different : {colors.size(), names.size(), words.size(), shapes.size()})
            QCOMPARE(different, all_mark_kinds.size());
    }

    void theRegistryFindsByNameAndKeepsTheLastOfAName() {
        PoshRegistry registry = test::toyRegistry();
        const std::size_t before = registry.all().size();
        QVERIFY(registry.find("Halt") && !registry.find("halt") && !registry.find(""));
        PoshPrimitives<test::ToyRover>(registry)
            .sense("Halt", [](const test::ToyRover&) { return 5; })
            .describe("Now a sense.")
            .unit("m")
            .within(1.0, 6.0)
            .oneOf({"a", "b"})
            .needs("Sonar")
            .needs("INS");
        QCOMPARE(registry.all().size(), before);
        const PoshPrimitive* const halt = registry.find("Halt");
        QVERIFY(halt->sense && !halt->make_act);
        const PrimitiveDescription& description = halt->description;
        QVERIFY(description.kind == PrimitiveKind::Sense && description.answer == AnswerType::Integer);
        QCOMPARE(description.help, std::string("Now a sense."));
        QCOMPARE(description.unit, std::string("m"));
        QVERIFY(description.minimum == 1.0 && description.maximum == 6.0);
        QVERIFY((description.choices == std::vector<std::string>{"a", "b"}));
        QVERIFY((description.needs == std::vector<std::string>{"Sonar", "INS"}));
        const std::vector<PrimitiveDescription> all = registry.descriptions();
        QVERIFY(std::ranges::is_sorted(all, {}, &PrimitiveDescription::name));
    }
};

USAR_TEST(tst_BehaviorOutput)

} // namespace tst_behavior_output

#include "tst_behavior_output.moc"
