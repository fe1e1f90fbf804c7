// A server's own file keeps what our robot files know nothing about.
#include <algorithm>
#include <cstddef>
#include <string>

#include <QObject>
#include <QTest>

#include "core/sim/servers/server_reader.h"
#include "core/sim/servers/server_writer.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/suite/suite.h"

namespace tst_server_merge {

using namespace usar;
using namespace usar::sim;
using protocol::Dialect;

namespace {

/// A made-up file in the manner of UT2004's, with the classes of a server that calls some of its sensors otherwise.
constexpr char ut2004[] = R"([USARBot.USARBot]
bLog=False

[USARBot.SonarSensor]
HiddenSensor=False
BeamAngle=0.349

[USARBot.AirRobot]
bMountByUU=False
batteryLife=1200
Weight=1
JointParts=(PartName="Rotor1",PartClass=class'USARModels.Rotor')
MisPkgs=(PkgName="CameraPanTilt",Location=(X=0,Y=0,Z=0.1),PkgClass=class'USARMisPkg.CameraPanTilt')
Cameras=(ItemClass=class'USARBot.RobotCamera',ItemName="Camera",Parent="CameraPanTilt_Link2")
Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="F1",Position=(X=0,Y=0,Z=0),Direction=(Y=0,Z=-1.57,X=0))
Sensors=(ItemClass=class'USARBot.HumanMotionSensor',ItemName="Motion")
;Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="F9")

[USARBot.P2DX]
JointParts=(PartName="LeftFWheel",PartClass=class'USARModels.P2DXTire')
MisPkgs=(PkgName="CameraPanTilt",PkgClass=class'USARMisPkg.CameraPanTilt')
Sensors=(ItemClass=class'USARModels.SICKLMS',ItemName="Scanner1",Position=(X=0.2,Y=0,Z=0))
Sensors=(ItemClass=class'USARBot.EncoderSensor',ItemName="ECLeft",Parent="LeftFWheel")
Sensors=(ItemClass=class'USARModels.Hokuyo',ItemName="Scanner2")

[USARBot.Zerg]
Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="F1")

[usarbot.AIRROBOT]
HeadLights=2
batteryLife=600
MisPkgs=(PkgName="Second",PkgClass=class'USARMisPkg.CameraPanTilt')
Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName="F1",Position=(X=9,Y=0,Z=0))

[USARBot.SonarSensor]
BeamAngle=0.777
)";

constexpr char udk[] = R"([USARSensor.SICK]
ScanFov=3.14159
Resolution=0.01745
MaxRange=20.000000

[USARSensor.Battery]
batteryLife=1200.0

[USARBot.AirRobot]
AddParts=(ItemClass=class'USARActuator.AirRobotCameraAct',ItemName="cam",Position=(X=0,Y=-0.02,Z=0.02))
AddParts=(ItemClass=class'USARSensor.GPSSensor_FIXED',ItemName="GPS",Position=(X=0,Y=0,Z=-0.15))

[USARBot.P3AT]
AddParts=(ItemClass=class'USARSensor.SICK',ItemName="lms200",Position=(X=0.2085,Y=0.0,Z=-0.2))
AddParts=(ItemClass=class'USARSensor.Battery',ItemName="battery",Position=(X=0.15,Y=0.0,Z=-0.20))
AddParts=(ItemClass=class'USARActuator.P3ATArm',ItemName="PioneerArm",Position=(X=0.1,Y=0,Z=0))
)";

} // namespace

class tst_ServerMerge : public QObject {
    Q_OBJECT

    const RobotCatalog& robots = *doubles::shippedRobots();

    QString merged(const char* text, Dialect dialect) const {
        const auto result = mergeServerFile(text, robots, dialect);
        return result ? QString::fromStdString(result->text) : QString::fromStdString(result.error().text());
    }

private slots:
    void keepsWhatIsNotOurs_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<bool>("stays");
        QTest::newRow("a setting of the server") << "bLog=False" << true;
        QTest::newRow("a robot's own setting") << "Weight=1" << true;
        QTest::newRow("joints") << "JointParts=(PartName=\"Rotor1\"" << true;
        QTest::newRow("a sensor that we do not know") << "ItemName=\"Motion\"" << true;
        QTest::newRow("a comment") << ";Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName=\"F9\")" << true;
        QTest::newRow("encoders, whose parts the server names") << "EncoderSensor',ItemName=\"ECLeft\"" << true;
        QTest::newRow("another scanner") << "ItemName=\"Scanner2\"" << true;
        QTest::newRow("another robot's sonar")
            << "Sensors=(ItemClass=class'USARBot.SonarSensor',ItemName=\"F1\")" << true;
        QTest::newRow("a class's other setting") << "HiddenSensor=False" << true;
        QTest::newRow("the stock sonar") << "Direction=(Y=0,Z=-1.57,X=0)" << false;
        QTest::newRow("the stock scanner's place") << "Position=(X=0.2,Y=0,Z=0)" << false;
        QTest::newRow("the stock beam") << "BeamAngle=0.349\n" << false;
        QTest::newRow("the stock battery") << "batteryLife=1200" << false;
        QTest::newRow("a second section's own setting") << "HeadLights=2" << true;
        QTest::newRow("a second section's battery") << "batteryLife=600" << false;
        QTest::newRow("a second section's camera") << "PkgName=\"Second\"" << false;
        QTest::newRow("a second section's sonar") << "Position=(X=9,Y=0,Z=0)" << false;
        QTest::newRow("a class's second section") << "BeamAngle=0.777" << false;
    }
    void keepsWhatIsNotOurs() {
        QFETCH(const QString, line);
        const QString text = merged(ut2004, Dialect::Ut2004);
        QVERIFY(QString(ut2004).contains(line));
        QTEST(text.contains(line), "stays");
    }

    /// Its scanner takes the place of the camera; the P2DX keeps its package.
    void theAirRobotLosesItsCamera() {
        const QString text = merged(ut2004, Dialect::Ut2004);
        const QString air_robot = text.section("[USARBot.AirRobot]", 1, 1).section("\n[", 0, 0);
        QVERIFY(!air_robot.contains("MisPkgs") && !air_robot.contains("Cameras"));
        QVERIFY(text.section("[USARBot.P2DX]", 1, 1).section("\n[", 0, 0).contains("MisPkgs"));
        const QString flying = merged(udk, Dialect::Udk).section("[USARBot.AirRobot]", 1, 1).section("\n[", 0, 0);
        QVERIFY(!flying.contains("AirRobotCameraAct"));
        QVERIFY(merged(udk, Dialect::Udk).contains("P3ATArm"));
    }

    void takesTheServersOwnClasses() {
        const QString text = merged(ut2004, Dialect::Ut2004);
        const QString air_robot = text.section("[USARBot.AirRobot]", 1, 1).section("\n[", 0, 0);
        QVERIFY(air_robot.contains("ItemClass=class'USARModels.SICKLMS',ItemName=\"Scanner1\""));
        QVERIFY(text.contains("[USARModels.SICKLMS]\nHiddenSensor=True\n"));
        QVERIFY(!text.contains("[USARBot.RangeScanner]"));
    }

    void learnsTheClassOfASonar_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("class_name");
        const QString own = "[USARBot.P2DX]\nSensors=(ItemClass=class'%1',ItemName=\"F1\")\n";
        const QString other = "[USARBot.Zerg]\nSensors=(ItemClass=class'Other.Thing',ItemName=\"F1\")\n";
        QTest::newRow("of its own") << own.arg("My.Sonar") << "My.Sonar";
        QTest::newRow("not an infrared sensor of that name") << own.arg("USARBot.IRSensor") << "USARBot.SonarSensor";
        QTest::newRow("of another robot") << other << "Other.Thing";
        QTest::newRow("of its own rather than another's") << other + own.arg("My.Sonar") << "My.Sonar";
        QTest::newRow("of another robot rather than infrared") << own.arg("USARBot.IRSensor") + other << "Other.Thing";
        QTest::newRow("in a second section") << "[USARBot.P2DX]\nWeight=1\n" + own.arg("My.Sonar") << "My.Sonar";
    }
    void learnsTheClassOfASonar() {
        QFETCH(const QString, text);
        QFETCH(const QString, class_name);
        const auto made = mergeServerFile(text.toStdString(), robots, Dialect::Ut2004);
        QVERIFY(made);
        const auto server = readServerFile(made->text);
        QVERIFY(server && server->robot("P2DX"));
        const auto& items = server->robot("P2DX")->items;
        const auto found = std::ranges::find(items, std::string("F1"), &ServerItem::name);
        QVERIFY(found != items.end());
        QCOMPARE(std::ranges::count(items, std::string("F1"), &ServerItem::name), std::ptrdiff_t(1));
        QCOMPARE(QString::fromStdString(found->class_name), class_name);
    }

    void sectionsOfOneNameAreReadAsOne() {
        const auto server = readServerFile("[USARBot.P2DX]\nSensors=(ItemClass=class'A.B',ItemName=\"F1\")\nWeight=1\n"
                                           "[usarbot.p2dx]\nSensors=(ItemClass=class'A.B',ItemName=\"F2\")\nSpeed=2\n");
        QVERIFY(server);
        QCOMPARE(server->robots.size(), std::size_t(1));
        QCOMPARE(server->robots.front().items.size(), std::size_t(2));
        QCOMPARE(server->robots.front().numbers.size(), std::size_t(2));
    }

    void theResultLacksNothing_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("is_udk");
        QTest::newRow("UT2004") << ut2004 << false;
        QTest::newRow("UDK") << udk << true;
    }
    void theResultLacksNothing() {
        QFETCH(const QString, text);
        QFETCH(const bool, is_udk);
        const RobotModel& ours = *findRobot(robots, "AirRobot");
        const auto before = readServerFile(text.toStdString());
        QVERIFY(before && !differencesOf(ours, *before).empty());
        const auto made = mergeServerFile(text.toStdString(), robots, is_udk ? Dialect::Udk : Dialect::Ut2004);
        QVERIFY(made);
        const auto after = readServerFile(made->text);
        QVERIFY(after);
        const auto differences = differencesOf(ours, *after);
        QVERIFY2(differences.empty(), differences.empty() ? "" : differences.front().c_str());
        const std::size_t unknown = is_udk ? 0 : 1; // The sensor of motion stays.
        QCOMPARE(after->robot("AirRobot")->items.size(), ours.sensors.size() + unknown);
    }

    void mergingTwiceChangesNothing() {
        const auto once = mergeServerFile(ut2004, robots, Dialect::Ut2004);
        QVERIFY(once);
        const auto twice = mergeServerFile(once->text, robots, Dialect::Ut2004);
        QVERIFY(twice);
        QCOMPARE(QString::fromStdString(twice->text), QString::fromStdString(once->text));
    }

    void keepsTheLineEnds() {
        const auto made = mergeServerFile(QString(ut2004).replace("\n", "\r\n").toStdString(), robots, Dialect::Ut2004);
        QVERIFY(made);
        const QString text = QString::fromStdString(made->text);
        QCOMPARE(text.count("\r\n"), text.count('\n'));
    }

    void refusesUnrealUnits_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("of a robot") << QString(ut2004).replace("bMountByUU=False", "bMountByUU=True");
        QTest::newRow("in a second section") << ut2004 + QString("[USARBot.AirRobot]\nbMountByUU=True\n");
    }
    void refusesUnrealUnits() {
        QFETCH(const QString, text);
        const auto made = mergeServerFile(text.toStdString(), robots, Dialect::Ut2004);
        QVERIFY(!made);
        QVERIFY(made.error().text().find("Unreal units") != std::string::npos);
    }
};

USAR_TEST(tst_ServerMerge)

} // namespace tst_server_merge

#include "tst_server_merge.moc"
