#include <QTest>

#include "core/mission/fleet/robot.h"
#include "core/mission/fleet/roster.h"
#include "tests/suite/suite.h"

namespace tst_roster {

using namespace usar;
using namespace usar::mission;

namespace {

/// Robots without a server: their sessions connect to nothing.
void addRobot(Roster& roster, const QString& name) {
    auto robot = std::make_unique<Robot>();
    robot->becomeReplay(roster.nextId(), name, {});
    roster.add(std::move(robot));
}

SpawnRequest requestFor(const std::string& name, const std::string& class_name = "USARBot.AirRobot") {
    return {.class_name = class_name, .robot_name = name, .start_in_map = {}};
}

} // namespace

class tst_Roster : public QObject {
    Q_OBJECT
private slots:
    void freeKeysAreGivenAgain() {
        Roster roster;
        QCOMPARE(roster.nextId(), RobotId{1});
        for (const char* name : {"a", "b", "c"})
            addRobot(roster, name);
        QCOMPARE(roster.nextId(), RobotId{4});
        QVERIFY(roster.take({2}));
        QVERIFY(!roster.take({2}));
        QCOMPARE(roster.nextId(), RobotId{2});
        QCOMPARE(roster.nextName(), QString("R2"));
    }

    void aRobotWithoutANameGetsOneByItsKey() {
        Roster roster;
        addRobot(roster, "a");
        QCOMPARE(roster.accept(requestFor("")).value().robot_name, std::string("R2"));
        QCOMPARE(roster.accept(requestFor("Rex")).value().robot_name, std::string("Rex"));
    }

    void refusesWhatCannotBeSpawned_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("class_name");
        QTest::addColumn<QString>("said");
        QTest::newRow("no class") << "R5"
                                  << ""
                                  << "R5: no plugin says which robot to spawn. Start with --plugins FOLDER.";
        QTest::newRow("the name of another") << "Rex"
                                             << "USARBot.P2DX"
                                             << "Rex: a robot already has this name. Choose another name.";
        QTest::newRow("another's name, not asked for") << ""
                                                       << "USARBot.P2DX"
                                                       << "R3: a robot already has this name. Choose another name.";
    }

    void refusesWhatCannotBeSpawned() {
        QFETCH(QString, name);
        QFETCH(QString, class_name);
        QFETCH(QString, said);
        Roster roster;
        addRobot(roster, "Rex");
        addRobot(roster, "R3");
        const auto accepted = roster.accept(requestFor(name.toStdString(), class_name.toStdString()));
        QVERIFY(!accepted.has_value());
        QCOMPARE(QString::fromStdString(accepted.error().text()), said);
    }

    void fiftyRobotsAreTheMost() {
        Roster roster;
        while (!roster.full())
            addRobot(roster, roster.nextName());
        QCOMPARE(roster.robots().size(), std::size_t(50));
        const auto another = roster.accept(requestFor("Another"));
        QVERIFY(!another.has_value());
        QCOMPARE(QString::fromStdString(another.error().text()),
                 QString("Another: there can be no more than 50 robots. Remove one first."));
        roster.take({50});
        QVERIFY(roster.accept(requestFor("Another")));
    }

    void aNameThatIsTakenGetsANumber() {
        Roster roster;
        QCOMPARE(roster.unusedName("R1 replay"), QString("R1 replay"));
        addRobot(roster, "R1 replay");
        QCOMPARE(roster.unusedName("R1 replay"), QString("R1 replay 2"));
        addRobot(roster, "R1 replay 2");
        QCOMPARE(roster.unusedName("R1 replay"), QString("R1 replay 3"));
        QCOMPARE(roster.unusedName("R1"), QString("R1"));
    }

    void findsRobotsByIdAndConnection() {
        Roster roster;
        addRobot(roster, "a");
        addRobot(roster, "b");
        Robot* const second = roster.robot({2});
        QVERIFY(second);
        QCOMPARE(nameOf(*second), QString("b"));
        QCOMPARE(roster.on(second->view().connection), second);
        QVERIFY(!roster.robot({3}) && !roster.on({}));
        QCOMPARE(roster.robots().back(), second);
        roster.clear();
        QVERIFY(roster.robots().empty());
    }
};

USAR_TEST(tst_Roster)

} // namespace tst_roster

#include "tst_roster.moc"
