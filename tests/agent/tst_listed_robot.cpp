// A robot as a list of behaviors: what it says of itself, and what it makes.
#include <QTest>

#include "core/agent/listed_robot.h"
#include "core/agent/posh_primitives.h"
#include "tests/plugins/minimal_plugin.h"
#include "tests/suite/suite.h"

namespace tst_listed_robot {

using namespace usar;
using namespace usar::agent;

namespace {

class Rover final : public PoshBody {
public:
    explicit Rover(const BehaviorContext&) {}
    protocol::Command safeCommand() const override { return protocol::SkidDrive{0.0, 0.0}; }
};

class Waiter final : public test::IdleBehavior {
public:
    explicit Waiter(const BehaviorContext& context) : robot_name(context.task.robot_name) {}
    const std::string robot_name;
};

PoshRegistry senses() {
    return registryOf<Rover>(
        {[](PoshPrimitives<Rover>& rover) { rover.act("Halt", [](Rover&) {}); },
         [](PoshPrimitives<Rover>& rover) { rover.sense("Arrived", [](const Rover&) { return true; }); }});
}

const PlanText own_plan{"own.lap", "((DC d (drives ((a Halt)))))"};

class Robot final : public ListedRobot {
public:
    Robot() : ListedRobot("USARBot.Toy", "Toy", {"INS", "Sonar"}) {
        BehaviorDescription waits;
        waits.id = "toy/cpp";
        waits.name = "Wait (C++)";
        waits.help = "It waits.";
        waits.needs_area = true;
        waits.parameters = {{"time_s", "Time", "", "s", 1.0, 0.0, 9.0, "How long.", {}}};
        add<Waiter>(std::move(waits));
        addPlanned<Rover>("toy/posh", "Wait (POSH)", own_plan, senses());
    }
};

BehaviorContext contextWith(std::optional<PlanText> plan) {
    return {{"R1", {}, {}}, {}, std::move(plan)};
}

} // namespace

class tst_ListedRobot : public QObject {
    Q_OBJECT
private slots:
    void describesItselfAndItsBehaviors() {
        const RobotDescription robot = Robot().description();
        QCOMPARE(robot.class_name, std::string("USARBot.Toy"));
        QCOMPARE(robot.name, std::string("Toy"));
        QVERIFY((robot.sensors_needed == std::vector<std::string>{"INS", "Sonar"}));
        QCOMPARE(robot.behaviors.size(), 2u);
        QCOMPARE(robot.behaviors[0].id, std::string("toy/cpp"));
        QVERIFY(robot.behaviors[0].plan_name.empty() && robot.behaviors[0].plan_text.empty());
        QCOMPARE(robot.primitives.size(), 2u);
        QCOMPARE(robot.primitives[0].name, std::string("Arrived"));
        QCOMPARE(robot.primitives[1].name, std::string("Halt"));
    }

    void aPlannedBehaviorHasWhatTheOneBeforeHas() {
        const RobotDescription robot = Robot().description();
        const BehaviorDescription& planned = robot.behaviors[1];
        QCOMPARE(planned.id, std::string("toy/posh"));
        QCOMPARE(planned.name, std::string("Wait (POSH)"));
        QCOMPARE(planned.help, std::string("It waits. Decided by a POSH plan, which can be read and changed."));
        QVERIFY(planned.needs_area);
        QVERIFY(planned.parameters == robot.behaviors[0].parameters);
        QVERIFY((PlanText{planned.plan_name, planned.plan_text} == own_plan));
    }

    void makesEachBehaviorFromItsContext() {
        const auto waiter = Robot().createBehavior("toy/cpp", contextWith({}));
        QVERIFY(waiter);
        const auto* const made = dynamic_cast<const Waiter*>(waiter->get());
        QVERIFY(made);
        QCOMPARE(made->robot_name, std::string("R1"));
    }

    void thePlanOfTheContextReplacesItsOwn_data() {
        QTest::addColumn<QString>("plan");
        QTest::addColumn<QString>("made_with"); // or what is said
        QTest::newRow("its own") << "" << QString::fromStdString(own_plan.text);
        QTest::newRow("another") << "((DC other (drives ((b Halt)))))"
                                 << "((DC other (drives ((b Halt)))))";
        QTest::newRow("one that cannot be read") << "((DC"
                                                 << "plan new.lap: it cannot be used: ";
        QTest::newRow("one with an unknown act") << "((DC d (drives ((a Fly)))))"
                                                 << "the robot has no act";
    }
    void thePlanOfTheContextReplacesItsOwn() {
        QFETCH(QString, plan);
        QFETCH(QString, made_with);
        std::optional<PlanText> replaced;
        if (!plan.isEmpty())
            replaced = PlanText{"new.lap", plan.toStdString()};
        const auto made = Robot().createBehavior("toy/posh", contextWith(replaced));
        const auto* const behavior = made ? dynamic_cast<const PoshBehavior*>(made->get()) : nullptr;
        const std::string said = behavior ? behavior->planText() : made ? "" : made.error().text();
        QVERIFY2(QString::fromStdString(said).startsWith(made_with) || !made, said.c_str());
        QVERIFY2(QString::fromStdString(said).contains(made_with), said.c_str());
    }

    void anUnknownBehaviorListsTheKnownOnes_data() {
        QTest::addColumn<QString>("id");
        QTest::newRow("another") << "toy/lisp";
        QTest::newRow("in another case") << "TOY/CPP";
        QTest::newRow("none") << "";
    }
    void anUnknownBehaviorListsTheKnownOnes() {
        QFETCH(QString, id);
        const auto made = Robot().createBehavior(id.toStdString(), contextWith({}));
        QVERIFY(!made);
        QCOMPARE(QString::fromStdString(made.error().text()),
                 QString("behavior %1: the Toy has no such behavior. Use toy/cpp or toy/posh.").arg(id));
    }

    void aRobotWithoutPreviewsGivesAnEmptyOne() {
        const auto preview = Robot().preview("toy/cpp", contextWith({}));
        QVERIFY(preview);
        QVERIFY(preview->path_in_map_m.empty() && preview->summary.empty());
        QCOMPARE(preview->length_m, 0.0);
        QCOMPARE(preview->duration.count(), 0.0);
    }
};

USAR_TEST(tst_ListedRobot)

} // namespace tst_listed_robot

#include "tst_listed_robot.moc"
