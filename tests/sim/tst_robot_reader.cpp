#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include <QObject>
#include <QString>
#include <QTemporaryDir>
#include <QTest>

#include "core/sim/robots/footprint.h"
#include "core/sim/robots/robot_reader.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/suite/suite.h"

namespace tst_robot_reader {

using namespace usar;
using namespace usar::sim;

namespace {

/// A robot of two links, with places to spoil.
QString sample() {
    return R"(<?xml version="1.0"?>
<sdf version="1.9" xmlns:usar="urn:usar-mission-control:robot">
  <model name="Sample">
    <usar:robot>
      <usar:kind>GroundVehicle</usar:kind>
      <usar:steering>SkidSteered</usar:steering>
      <usar:dimensions>0.5 0.4 0.3</usar:dimensions>
      <usar:battery>600</usar:battery>
      <usar:drive kind="skid"><usar:joint>Wheel</usar:joint><usar:wheel_radius>0.1</usar:wheel_radius></usar:drive>
      <usar:package name="Arm"><usar:joint>Lift</usar:joint></usar:package>
    </usar:robot>
    <link name="arm">
      <pose>0.2 0 0.1 0 0 0</pose>
      <inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
      <sensor name="Eye" type="custom" usar:type="IR"><pose>0.1 0 0 0 0 0</pose><usar:max_range>3</usar:max_range></sensor>
    </link>
    <link name="body">
      <inertial><pose>0.1 0 -0.1 0 0 0</pose><mass>4</mass><inertia><ixx>1</ixx><iyy>2</iyy><izz>3</izz></inertia></inertial>
      <collision name="hull"><pose>0.1 0 0 0 0 0</pose><geometry><box><size>0.5 0.4 0.3</size></box></geometry></collision>
      <usar:friction>0.4</usar:friction>
      <sensor name="F1" type="custom" usar:type="Sonar"><pose>0.2 0 0 0 0 0.5</pose><usar:max_range>4</usar:max_range></sensor>
    </link>
    <link name="wheel">
      <pose>0 0.2 -0.1 0 0 0</pose>
      <inertial><mass>0.5</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
      <collision name="tyre"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
    </link>
    <joint name="Wheel" type="continuous"><parent>body</parent><child>wheel</child>
      <axis><xyz>0 1 0</xyz><limit><effort>5</effort><velocity>16</velocity></limit></axis></joint>
    <joint name="Lift" type="prismatic"><pose>0 0 -0.05 0 0 0</pose><parent>body</parent><child>arm</child>
      <axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>0.3</upper><effort>20</effort><velocity>0.1</velocity></limit></axis></joint>
  </model>
</sdf>)";
}

Result<RobotModel> readText(const QString& text) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath("robot.sdf").toStdString();
    std::ofstream(file) << text.toStdString();
    return readRobot(file);
}

} // namespace

class tst_RobotReader : public QObject {
    Q_OBJECT

private slots:
    void readsBodyJointsSensorsAndPackages() {
        const auto robot = readText(sample());
        QVERIFY2(robot, robot ? "" : robot.error().text().c_str());
        QCOMPARE(robot->class_name, std::string("Sample"));
        QCOMPARE(robot->kind, protocol::VehicleKind::Ground);
        QCOMPARE(robot->battery_life, Seconds{600.0});
        QCOMPARE(robot->mass_kg(), 5.5);
        QCOMPARE(robot->body.base.friction, 0.4);
        QCOMPARE(robot->body.base.inertia_kg_m2, Vec3(1, 2, 3));
        QCOMPARE(robot->center_of_mass_in_base_m, Vec3(0.1, 0, -0.1));
        // Parts lie around the center of mass.
        QCOMPARE(robot->body.base.parts.at(0).part_in_body.position_m, Vec3(0, 0, 0.1));
        QCOMPARE(robot->links.size(), std::size_t(2));
        const LinkDescription& wheel = robot->body.links.at(0);
        QCOMPARE(robot->links.at(0).name, std::string("wheel"));
        QVERIFY(wheel.link_in_parent.position_m.isApprox(Vec3(-0.1, 0.2, 0.0)));
        QVERIFY(wheel.lower > wheel.upper); // turns without limits
        const LinkDescription& arm = robot->body.links.at(1);
        QCOMPARE(arm.kind, JointKind::Prismatic);
        QCOMPARE(arm.pivot_in_link_m, Vec3(0, 0, -0.05));
        QCOMPARE(arm.upper, 0.3);
        QCOMPARE(robot->links.at(1).torque_limit, 20.0);
        QCOMPARE(robot->sensors.size(), std::size_t(2));
        QCOMPARE(robot->sensors.at(0).mount, std::string("HARD"));
        QCOMPARE(robot->sensors.at(1).mount, std::string("arm"));
        QCOMPARE(robot->sensors.at(1).link, 1);
        QCOMPARE(numberOr(robot->sensors.at(1).numbers, "max_range", 0.0), 3.0);
        QCOMPARE(robot->packages.at(0).joints, std::vector<std::string>{"Lift"});
        QCOMPARE(numberOr(robot->drive.numbers, "wheel_radius", 0.0), 0.1);
    }

    void whatOtherSimulatorsUseDoesNotMatter_data() {
        QTest::addColumn<QString>("version");
        QTest::addColumn<QString>("in_link");
        const QString visual = R"(<visual name="skin"><geometry><sphere><radius>1</radius></sphere></geometry>
                                  <material><ambient>1 0 0 1</ambient></material></visual>)";
        QTest::newRow("as we write it") << "1.9"
                                        << "";
        QTest::newRow("an older version") << "1.6" << visual;
        QTest::newRow("a skin") << "1.9" << visual;
        QTest::newRow("a light") << "1.9"
                                 << R"(<light name="lamp" type="point"><diffuse>1 1 1 1</diffuse></light>)";
        QTest::newRow("a surface") << "1.9"
                                   << R"(<collision name="c"><geometry><sphere><radius>0.1</radius></sphere></geometry>
                                         <surface><friction><ode><mu>1</mu></ode></friction></surface></collision>)";
    }

    void whatOtherSimulatorsUseDoesNotMatter() {
        QFETCH(QString, version);
        QFETCH(QString, in_link);
        const auto robot = readText(sample()
                                        .replace("version=\"1.9\"", "version=\"" + version + '"')
                                        .replace("<link name=\"wheel\">", "<link name=\"wheel\">" + in_link));
        QVERIFY2(robot, robot ? "" : robot.error().text().c_str());
        QCOMPARE(robot->mass_kg(), 5.5);
        QCOMPARE(robot->sensors.size(), std::size_t(2));
        QCOMPARE(robot->links.size(), std::size_t(2));
    }

    void refusesWhatCannotBeBuilt_data() {
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("words");
        QTest::newRow("no facts") << "usar:robot>"
                                  << "usar:thing>"
                                  << "no usar:robot";
        QTest::newRow("unknown kind") << "GroundVehicle"
                                      << "Hovercraft"
                                      << "usar:kind is";
        QTest::newRow("two dimensions") << "0.5 0.4 0.3</usar:dimensions>"
                                        << "0.5 0.4</usar:dimensions>"
                                        << "length, width and height";
        QTest::newRow("no drive") << "usar:drive"
                                  << "usar:drove"
                                  << "no usar:drive";
        QTest::newRow("drive of a joint that is not there") << "<usar:joint>Wheel"
                                                            << "<usar:joint>Weel"
                                                            << "no joint \"Weel\"";
        QTest::newRow("two bases") << "<parent>body</parent><child>wheel"
                                   << "<parent>body</parent><child>arm"
                                   << "hangs on a joint";
        QTest::newRow("base off the origin") << "<link name=\"body\">"
                                             << "<link name=\"body\"><pose>1 0 0 0 0 0</pose>"
                                             << "at the model's origin";
        QTest::newRow("shape that is none of ours") << "<sphere><radius>0.1</radius></sphere>"
                                                    << "<ellipsoid><radii>1 1 1</radii></ellipsoid>"
                                                    << "neither box";
        QTest::newRow("joint of another kind") << "type=\"continuous\""
                                               << "type=\"ball\""
                                               << "must be revolute";
        QTest::newRow("sensor without a type") << "usar:type=\"IR\""
                                               << ""
                                               << "no usar:type";
        QTest::newRow("package without joints") << "<usar:joint>Lift</usar:joint>"
                                                << ""
                                                << "at least one usar:joint";
        QTest::newRow("broken XML") << "</model>"
                                    << "</modle>"
                                    << "XML";
    }
    void refusesWhatCannotBeBuilt() {
        QFETCH(QString, from);
        QFETCH(QString, to);
        QFETCH(QString, words);
        const auto robot = readText(sample().replace(from, to));
        QVERIFY(!robot);
        const QString text = QString::fromStdString(robot.error().text());
        QVERIFY2(text.contains(words) && text.contains("robot.sdf"), qPrintable(text));
    }

    void aSpoiltFileOfAFolderCostsThatRobotOnly() {
        const QTemporaryDir folder;
        std::ofstream(folder.filePath("a.sdf").toStdString()) << sample().toStdString();
        std::ofstream(folder.filePath("b.sdf").toStdString()) << "<sdf";
        std::ofstream(folder.filePath("c.sdf").toStdString()) << sample().toStdString();
        const RobotsRead read = readRobots(folder.path().toStdString());
        QCOMPARE(read.robots.size(), std::size_t(1));
        QCOMPARE(read.refused.size(), std::size_t(2));
        QVERIFY(read.refused.at(1).text().find("there is a Sample already") != std::string::npos);
        QCOMPARE(readRobots(folder.filePath("nowhere").toStdString()).refused.size(), std::size_t(1));
    }

    void aFileThatWasWrittenSinceIsReadAgain_data() {
        QTest::addColumn<QString>("mass"); // in place of 4
        QTest::newRow("as long") << "6";
        QTest::newRow("longer") << "6.0";
    }
    void aFileThatWasWrittenSinceIsReadAgain() {
        QFETCH(QString, mass);
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("robot.sdf").toStdString();
        std::ofstream(file) << sample().toStdString();
        for (int i = 0; i < 2; ++i)
            QCOMPARE(readRobot(file)->mass_kg(), 5.5);
        std::ofstream(file) << sample().replace("<mass>4<", "<mass>" + mass + "<").toStdString();
        std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(1));
        for (int i = 0; i < 2; ++i)
            QCOMPARE(readRobot(file)->mass_kg(), 7.5);
        std::filesystem::remove(file);
        QVERIFY(!readRobot(file));
    }

    void shipsTheRobotsOfTheThesisAndMore() {
        for (const char* name : {"AirRobot", "USARBot.P2DX", "usarbot.submarine", "ERS", "P2AT", "Sedan"})
            QVERIFY2(findRobot(*doubles::shippedRobots(), name), name);
        QCOMPARE(findRobot(*doubles::shippedRobots(), "ERS")->drive.joints.size(), std::size_t(15));
        QVERIFY(!findRobot(*doubles::shippedRobots(), "USARBot.Fountain"));
    }

    /// In the frame of the base, which is neither that of the center of mass nor that of a link.
    void footprintIsWhereTheCollisionsAre() {
        const auto robot = readText(sample());
        QVERIFY(robot);
        const std::vector<Outline> outlines = footprintOf(*robot);
        QCOMPARE(outlines.size(), std::size_t(2)); // The arm collides with nothing.
        Rectangle hull{outlines[0][0], outlines[0][0]};
        for (const Vec2& corner_m : outlines[0])
            hull = {hull.min_m.cwiseMin(corner_m), hull.max_m.cwiseMax(corner_m)};
        QVERIFY(hull.min_m.isApprox(Vec2(-0.15, -0.2)) && hull.max_m.isApprox(Vec2(0.35, 0.2)));
        for (const Vec2& corner_m : outlines[1])
            QVERIFY(std::abs((corner_m - Vec2(0.0, 0.2)).norm() - 0.1) < 1e-9);
    }

    void everyShippedRobotCoversWhatItsFileSays() {
        for (const RobotModel& robot : *doubles::shippedRobots()) {
            double longest_m = 0.0;
            for (const Outline& outline : footprintOf(robot))
                for (const Vec2& corner_m : outline)
                    longest_m = std::max(longest_m, corner_m.norm());
            const double said_m = robot.dimensions_m.head<2>().norm() / 2.0;
            if (robot.drive.kind == "none")
                continue; // An arm on a floor stretches far beyond its foot.
            // UDK's dimensions of the P3AT are the distances between its wheels, without tires and bumpers.
            QVERIFY2(longest_m > 0.5 * said_m && longest_m < 2.0 * said_m, robot.class_name.c_str());
        }
    }
};

USAR_TEST(tst_RobotReader)

} // namespace tst_robot_reader

#include "tst_robot_reader.moc"
