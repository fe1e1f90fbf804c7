#include <QTest>

#include "core/base/geometry.h"
#include "core/protocol/info/configurations.h"
#include "core/protocol/reader.h"
#include "tests/suite/suite.h"

namespace tst_configurations {

using namespace usar;
using namespace usar::protocol;

namespace {

ConfigurationInfo configurationOf(const char* line) {
    Reader reader;
    return std::get<ConfigurationInfo>(reader.read(line).message);
}

} // namespace

class tst_Configurations : public QObject {
    Q_OBJECT
private slots:
    void aRobotOnWheels_data();
    void aRobotOnWheels();
    void aRobotInTheAir();
    void jointsWithTheirLimits();
    void aJointWhoseSmallestIsAboveItsLargestHasNoLimits();
    void camerasInDegreesAndInRadians();
    void effectersWithTheirOpcodes();
    void sensorsOfAnyType();
    void eachKindIsItsOwnAlone_data();
    void eachKindIsItsOwnAlone();
};

void tst_Configurations::aRobotOnWheels_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("UT2004") << QByteArray(
        "CONF {Type GroundVehicle} {Name P2AT} {SteeringType SkidSteered} {Mass 14.5} "
        "{MaxSpeed 5.25} {MaxTorque 60.0} {MaxFrontSteer 0.0} {MaxRearSteer 0.0}");
    QTest::newRow("UDK, Name first") << QByteArray(
        "CONF {Name P2AT} {Type GroundVehicle} {SteeringType SkidSteered} {Mass 14.5} {MaxSpeed 5.25} "
        "{MaxTorque 60} {MaxFrontSteer 0} {MaxRearSteer 0}");
}

void tst_Configurations::aRobotOnWheels() {
    QFETCH(QByteArray, line);
    const auto robot = robotConfigurationOf(configurationOf(line.constData()));
    QVERIFY(robot);
    QVERIFY(*robot == (RobotConfiguration{.robot_class = "P2AT",
                                          .kind = VehicleKind::Ground,
                                          .steering = "SkidSteered",
                                          .mass_kg = 14.5,
                                          .wheel_speed_limit_rad_s = 5.25,
                                          .torque_limit_n_m = 60.0,
                                          .front_steer_limit_rad = 0.0,
                                          .rear_steer_limit_rad = 0.0}));
}

void tst_Configurations::aRobotInTheAir() {
    const auto robot = robotConfigurationOf(configurationOf(
        "CONF {Type AerialVehicle} {Name AirRobot} {Mass 1} {MaxLateralVelocity 4} {MaxLinearVelocity 5} "
        "{MaxAltitudeVelocity 3} {MaxRotationalVelocity 1.5}"));
    QCOMPARE(*robot->forward_limit_m_s, 5.0);
    QCOMPARE(*robot->sideways_limit_m_s, 4.0);
    QCOMPARE(*robot->climb_limit_m_s, 3.0);
    QCOMPARE(*robot->yaw_rate_limit_rad_s, 1.5);
    QVERIFY(!robot->wheel_speed_limit_rad_s);
}

void tst_Configurations::jointsWithTheirLimits() {
    const auto packages = packageConfigurationsOf(configurationOf(
        "CONF {Type Actuator} {Name Arm} {Link 1} {JointType Revolute} {MaxTorque 300.5} {MinValue -1.5} "
        "{MaxValue 1.25} {Link 2} {JointType Prismatic} {MaxTorque 100} {MinValue 0} {MaxValue 0.25}"));
    QCOMPARE(packages.size(), std::size_t(1));
    QCOMPARE(packages[0].name, std::string("Arm"));
    QCOMPARE(packages[0].links.size(), std::size_t(2));
    QVERIFY(packages[0].links[0] == (LinkConfiguration{1, false, std::nullopt, 300.5, -1.5, 1.25}));
    QVERIFY(packages[0].links[1].prismatic);
}

void tst_Configurations::aJointWhoseSmallestIsAboveItsLargestHasNoLimits() {
    const auto packages = packageConfigurationsOf(
        configurationOf("CONF {Type MisPkg} {Name C} {Link 1} {JointType Revolute} {MaxSpeed 0.17} {MaxTorque 20.00} "
                        "{MinRange 1} {MaxRange 0} {Link 2} {JointType Revolute} {MinRange -0.16} {MaxRange 0.40}"));
    QVERIFY(!packages[0].links[0].smallest && !packages[0].links[0].largest);
    QCOMPARE(*packages[0].links[0].speed_limit, 0.17);
    QCOMPARE(*packages[0].links[1].smallest, -0.16);
}

void tst_Configurations::camerasInDegreesAndInRadians() {
    const auto udk = cameraConfigurationsOf(configurationOf(
        "CONF {Type Camera} {Name A}{TextureOffsetX 0}{TextureOffsetY 240}{TextureResolutionX 320}"
        "{TextureResolutionY 200}{CameraDefFov 90.0}{CameraMinFov 20.0}{CameraMaxFov 120.0}{CameraFov 45.0} "
        "{Name B}{TextureResolutionX 640}"));
    QCOMPARE(udk.size(), std::size_t(2));
    QCOMPARE(*udk[0].default_fov_rad, pi / 2);
    QCOMPARE(*udk[0].fov_rad, pi / 4);
    QCOMPARE(*udk[0].picture_y_px, 240);
    QCOMPARE(*udk[0].picture_height_px, 200);
    QCOMPARE(*udk[1].picture_width_px, 640);
    const auto ut2004 = cameraConfigurationsOf(
        configurationOf("CONF {Type Camera} {Name A} {CameraDefFov 0.75} {CameraMinFov 0.25} {CameraMaxFov 2.0}"));
    QCOMPARE(*ut2004[0].default_fov_rad, 0.75);
    QVERIFY(!ut2004[0].picture_x_px);
}

void tst_Configurations::effectersWithTheirOpcodes() {
    const auto effecters = effecterConfigurationsOf(configurationOf(
        "CONF {Type Gripper} {Name G} {Opcode Grip} {MaxVal 1} {MinVal 0} {Opcode Close} {Opcode Open}"));
    QCOMPARE(effecters.size(), std::size_t(1));
    QCOMPARE(effecters[0].type, std::string("Gripper"));
    QVERIFY(effecters[0].opcodes == (std::vector<EffecterOpcode>{{"Grip", 0.0, 1.0},
                                                                 {"Close", std::nullopt, std::nullopt},
                                                                 {"Open", std::nullopt, std::nullopt}}));
}

void tst_Configurations::sensorsOfAnyType() {
    const auto sonars = sensorConfigurationsOf(configurationOf(
        "CONF {Type Sonar} {Name A} {MaxRange 5} {MinRange 0.1} {BeamAngle 0.35} {Name B} {MaxRange 4}"));
    QCOMPARE(sonars.size(), std::size_t(2));
    QCOMPARE(*sonars[0].beam_angle_rad, 0.35);
    QCOMPARE(*sonars[1].range_max_m, 4.0);
    for (const char* pans : {"Paning", "Panning"}) {
        const std::string line = std::string("CONF {Type RangeScanner} {Name S} {MaxRange 20} {MinRange 0.1} "
                                             "{Resolution 0.0174} {Fov 3.1415} {") +
                                 pans + " True} {Tilting False}";
        const auto scanner = sensorConfigurationsOf(configurationOf(line.c_str()));
        QCOMPARE(*scanner[0].fov_rad, 3.1415);
        QCOMPARE(*scanner[0].pans, true);
        QCOMPARE(*scanner[0].tilts, false);
    }
    const auto odometry = sensorConfigurationsOf(
        configurationOf("CONF {Type Odometry} {Name O} {ScanInterval 0.2} {EncoderResolution 0.01}"));
    QCOMPARE(odometry[0].scan_interval->count(), 0.2);
    QCOMPARE(*odometry[0].resolution_rad, 0.01);
}

void tst_Configurations::eachKindIsItsOwnAlone_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<QByteArray>("kinds");
    QTest::newRow("robot") << QByteArray("CONF {Type GroundVehicle} {Name P} {Mass 1}") << QByteArray("robot");
    QTest::newRow("package") << QByteArray("CONF {Type MisPkg} {Name P} {Link 1}") << QByteArray("package");
    QTest::newRow("camera") << QByteArray("CONF {Type Camera} {Name C} {CameraDefFov 1}") << QByteArray("camera");
    QTest::newRow("effecter") << QByteArray("CONF {Type Gripper} {Name G} {Opcode Open}") << QByteArray("effecter");
    QTest::newRow("sensor") << QByteArray("CONF {Type Touch} {Name T} {Diameter 0.05}") << QByteArray("sensor");
}

void tst_Configurations::eachKindIsItsOwnAlone() {
    QFETCH(QByteArray, line);
    QFETCH(QByteArray, kinds);
    const ConfigurationInfo info = configurationOf(line.constData());
    QByteArray found;
    found += robotConfigurationOf(info) ? "robot" : "";
    found += packageConfigurationsOf(info).empty() ? "" : "package";
    found += cameraConfigurationsOf(info).empty() ? "" : "camera";
    found += effecterConfigurationsOf(info).empty() ? "" : "effecter";
    found += sensorConfigurationsOf(info).empty() ? "" : "sensor";
    QCOMPARE(found, kinds);
}

USAR_TEST(tst_Configurations)

} // namespace tst_configurations

#include "tst_configurations.moc"
