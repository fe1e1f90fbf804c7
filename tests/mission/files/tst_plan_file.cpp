// POSH plans in files of the user, and the robots that can run them.
#include <cstring>

#include <QBuffer>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/files/plan_file.h"
#include "core/posh/language/token.h"
#include "tests/suite/suite.h"

namespace tst_plan_file {

using namespace usar;
using namespace usar::mission;

namespace {

/// A device that never ends, as /dev/zero.
class Endless : public QIODevice {
public:
    Endless() { open(QIODevice::ReadOnly); }
    bool isSequential() const override { return true; }

protected:
    qint64 readData(char* data, qint64 size) override {
        std::memset(data, ' ', static_cast<std::size_t>(size));
        return size;
    }
    qint64 writeData(const char*, qint64) override { return -1; }
};

agent::RobotDescription robot(const char* name, const char* class_name, const char* behavior, bool takes_plans) {
    agent::RobotDescription one;
    one.name = name;
    one.class_name = class_name;
    one.behaviors.emplace_back();
    one.behaviors.back().id = behavior;
    if (takes_plans)
        one.primitives.emplace_back();
    return one;
}

const std::vector<agent::RobotDescription> robots{robot("Submarine", "USARBot.Submarine", "submarine/cpp", false),
                                                  robot("AirRobot", "USARBot.AirRobot", "airrobot/posh", true),
                                                  robot("ERS", "USARBot.ERS", "ers/posh", true)};

} // namespace

class tst_PlanFile : public QObject {
    Q_OBJECT
private slots:
    void aRobotIsFoundByAnyOfItsNames_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("expected");
        QTest::newRow("its name") << "AirRobot"
                                  << "AirRobot";
        QTest::newRow("another case") << "airrobot"
                                      << "AirRobot";
        QTest::newRow("its class") << "usarbot.ers"
                                   << "ERS";
        QTest::newRow("a behavior") << "ERS/POSH"
                                    << "ERS";
    }

    void aRobotIsFoundByAnyOfItsNames() {
        QFETCH(QString, name);
        QFETCH(QString, expected);
        const auto found = robotForPlans(robots, name);
        QVERIFY(found);
        QCOMPARE(QString::fromStdString((*found)->name), expected);
    }

    void whoTakesNoPlanIsRefused_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("unknown") << "P2DX";
        QTest::newRow("nothing") << "";
        QTest::newRow("a robot without senses and acts") << "Submarine";
        QTest::newRow("its behavior") << "submarine/cpp";
    }

    void whoTakesNoPlanIsRefused() {
        QFETCH(QString, name);
        const auto found = robotForPlans(robots, name);
        QVERIFY(!found);
        QCOMPARE(found.error().what, std::string("no plan can run such a robot"));
        QCOMPARE(QString::fromStdString(found.error().where), name);
        QCOMPARE(found.error().mend, std::string("Choose one of AirRobot, ERS"));
    }

    void withoutRobotsThePluginsAreMissing() {
        const auto found = robotForPlans({}, "AirRobot");
        QVERIFY(!found);
        QCOMPARE(found.error().mend, std::string("No robot plugin was found; are they beside the program?"));
    }

    void aPlanIsReadAsItIs() {
        const QByteArray bytes = QByteArray("((C x))\r\n\0\xff", 11).repeated(100'000);
        QBuffer buffer;
        buffer.setData(bytes);
        QVERIFY(buffer.open(QIODevice::ReadOnly));
        QCOMPARE(QByteArray::fromStdString(readPlanText(buffer)), bytes);
        QCOMPARE(readPlanText(buffer), std::string());
    }

    void aPlanWithoutAnEndIsReadJustFarEnoughToBeRefused() {
        Endless endless;
        QCOMPARE(readPlanText(endless).size(), posh::longest_plan_bytes + 1);
    }

    void aPlanIsNamedByItsPath() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("a.lap");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("((C x))");
        file.close();
        const auto plan = readPlanFile(path);
        QVERIFY(plan);
        QCOMPARE(QString::fromStdString(plan->name), path);
        QCOMPARE(plan->text, std::string("((C x))"));
    }

    void aFileThatIsNotThereIsNamed() {
        const QTemporaryDir folder;
        const auto plan = readPlanFile(folder.filePath("missing.lap"));
        QVERIFY(!plan);
        QVERIFY(QString::fromStdString(plan.error().what).startsWith("cannot read the plan: "));
        QCOMPARE(QString::fromStdString(plan.error().where), folder.filePath("missing.lap"));
        QVERIFY(!plan.error().mend.empty());
    }
};

USAR_TEST(tst_PlanFile)

} // namespace tst_plan_file

#include "tst_plan_file.moc"
