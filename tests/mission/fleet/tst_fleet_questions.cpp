// Questions about the robots of a fleet, and words about plugins.
#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include "core/mission/fleet/plugin_words.h"
#include "core/mission/fleet/roster.h"
#include "tests/suite/suite.h"

namespace tst_fleet_questions {

using namespace usar;
using namespace usar::mission;

class tst_FleetQuestions : public QObject {
    Q_OBJECT
private slots:
    void aReplayIsNoRobotOfTheServer() {
        Robot live, replay;
        live.spawn({1}, {"USARBot.P2DX", "R1", {}});
        replay.becomeReplay({2}, "R2", {});
        const Robots robots{&replay, &live};
        QCOMPARE(liveNames({&live}), QStringList("R1"));
        QVERIFY(!anyRunning(robots));
        QVERIFY(!anyHalted(robots));
        QVERIFY(!brokenRobot(robots, nullptr));
    }

    void aRobotForAMissionIsOfItsClass() {
        Robot one, two;
        one.spawn({1}, {"USARBot.P2DX", "R1", {}});
        two.spawn({2}, {"USARBot.P2DX", "R2", {}});
        const Robots robots{&one, &two};
        QCOMPARE(robotFor(robots, &two, "USARBot.P2DX"), &two);
        QCOMPARE(robotFor(robots, nullptr, "USARBot.P2DX"), &one);
        QVERIFY(!robotFor(robots, &two, "USARBot.AirRobot"));
    }

    void aStartIsNamedByItsPlace() {
        protocol::StartPose first{"First", {}}, second{"Second", {}};
        second.pose_in_map.position_m.x() = 5.0;
        Robot robot;
        robot.spawn({1}, {"USARBot.P2DX", "R1", second.pose_in_map});
        QCOMPARE(startName({first, second}, &robot, "none"), std::string("Second"));
        QCOMPARE(startName({first, second}, nullptr, "none"), std::string("First"));
        QCOMPARE(startName({}, &robot, "none"), std::string("none"));
    }

    void changesOfPluginsAreTold_data() {
        QTest::addColumn<int>("news");
        QTest::addColumn<QStringList>("running");
        QTest::addColumn<QString>("words");
        QTest::newRow("moved") << int(agent::PluginNews::Moved) << QStringList() << "runs in the program now";
        QTest::newRow("gone") << int(agent::PluginNews::Removed) << QStringList() << "is gone";
        QTest::newRow("loaded") << int(agent::PluginNews::Added) << QStringList() << "was loaded: hop/up, hop/down.";
        QTest::newRow("rebuilt") << int(agent::PluginNews::Rebuilt) << QStringList{"R1", "R2"} << "R1, R2 goes on";
    }

    void changesOfPluginsAreTold() {
        QFETCH(int, news);
        QFETCH(QStringList, running);
        QFETCH(QString, words);
        agent::PluginRecord record;
        record.file = "/plugins/hop.so";
        record.metadata = QJsonObject{{"name", "Hop"}, {"behaviors", QJsonArray{"hop/up", "hop/down"}}};
        QCOMPARE(nameOf(record), QString("Hop"));
        const QString text = changeText({static_cast<agent::PluginNews>(news), record}, running);
        QVERIFY2(text.contains("hop.so") && text.contains(words), qPrintable(text));
    }

    void whatNeedsNoSentenceHasNone() {
        QCOMPARE(changeText({agent::PluginNews::Asked, {}}, {}), QString());
        QCOMPARE(changeText({agent::PluginNews::Described, {}}, {}), QString());
    }
};

USAR_TEST(tst_FleetQuestions)

} // namespace tst_fleet_questions

#include "tst_fleet_questions.moc"
