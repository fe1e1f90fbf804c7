#include <QTest>

#include "core/modules/robot_modules.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_robot_modules {

using namespace usar;

class tst_RobotModules : public QObject {
    Q_OBJECT
private slots:
    void oneSessionFillsAllModules();
    void readingsWithoutTimeGetTheClockOfTheState();
    void newStartPosesReplaceTheOld();
};

void tst_RobotModules::oneSessionFillsAllModules() {
    protocol::Reader reader;
    modules::RobotModules robot;
    robot.geometry.query("Robot");
    robot.configuration.query("Sonar");
    for (const char* line :
         {"NFO {Gametype G} {Level L} {TimeLimit 0}", "NFO {StartPoses 1} {A 1,2,3 0,0,0}",
          "STA {Type AerialVehicle} {Time 5.00} {Battery 1200}", "SEN {Time 5.0} {Type Sonar} {Name Front Range 4.5}",
          "GEO {Type AerialVehicle} {Name AirRobot} {Dimensions 1,1,0.2}",
          "CONF {Type Sonar} {Name Front} {MaxRange 5.0}", "RES {Time 5.2} {Type INS} {Name INS} {Status OK}"})
        robot.take(reader.read(line));
    QCOMPARE(robot.game->level, std::string("L"));
    QCOMPARE(robot.start_poses->poses.size(), std::size_t(1));
    QCOMPARE(robot.state.latest()->battery_left->count(), 1200.0);
    QCOMPARE(robot.sensors.sonar("Front")->value.range_m, 4.5);
    QCOMPARE(robot.geometry.answer("Robot")->robot_class, std::string("AirRobot"));
    QVERIFY(robot.configuration.answer("Sonar"));
    QCOMPARE(robot.responses.takeAll().size(), std::size_t(1));
}

void tst_RobotModules::readingsWithoutTimeGetTheClockOfTheState() {
    protocol::Reader reader;
    modules::RobotModules robot;
    robot.take(reader.read("STA {Time 5.00} {Battery 1200}"));
    robot.take(reader.read("SEN {Type INS} {Name INS} {Location 1,2,3} {Orientation 0,0,0}"));
    QCOMPARE(robot.sensors.ins()->time.count(), 5.0);
}

void tst_RobotModules::newStartPosesReplaceTheOld() {
    protocol::Reader reader;
    modules::RobotModules robot;
    robot.take(reader.read("NFO {StartPoses 1} {A 1,2,3 0,0,0}"));
    robot.take(reader.read("NFO {StartPoses 0}"));
    QVERIFY(robot.start_poses && robot.start_poses->poses.empty());
}

USAR_TEST(tst_RobotModules)

} // namespace tst_robot_modules

#include "tst_robot_modules.moc"
