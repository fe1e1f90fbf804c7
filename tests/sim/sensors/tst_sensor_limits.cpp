// Sensors at the ends of what they can measure and of what can be set, and models that no sensor can be made of.
#include <algorithm>
#include <cmath>

#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/sensors/camera_sensor.h"
#include "core/sim/sensors/motion_sensors.h"
#include "core/sim/sensors/range_sensors.h"
#include "tests/sim/driven_robot.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_sensor_limits {

using namespace usar;
using namespace usar::sim;

namespace {

/// The same distance in every direction, as far as one looks.
struct Sphere : Rays {
    explicit Sphere(double all_m) : all_m_(all_m) {}
    double cast(const Vec3&, const Vec3&, double maximum_m) const override { return std::min(all_m_, maximum_m); }

private:
    double all_m_;
};

RobotModel cart() {
    RobotModel model;
    model.class_name = "Cart";
    model.links = {{"left wheel", "LeftWheel"}, {"right wheel", "RightWheel"}};
    return model;
}

SensorBirth birthOn(const RobotModel& robot, bool noise = false) {
    return {robot, {}, Seconds{0.2}, noise, seeded(3, 1)};
}

SensorModel modelOf(const std::string& type, Numbers numbers = {}) {
    SensorModel model;
    model.type = type;
    model.name = "S1";
    model.numbers = std::move(numbers);
    return model;
}

double settingOf(const std::vector<protocol::Setting>& settings, const std::string& key) {
    for (const protocol::Setting& setting : settings)
        if (setting.key == key)
            return setting.number.value_or(-1.0);
    return -2.0;
}

} // namespace

class tst_SensorLimits : public QObject {
    Q_OBJECT

private slots:
    void rangesStayWithinTheirLimits_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("reading_m");
        QTest::newRow("touching") << 0.0 << 0.5;
        QTest::newRow("nearer than the minimum") << 0.49 << 0.5;
        QTest::newRow("at the minimum") << 0.5 << 0.5;
        QTest::newRow("between") << 3.25 << 3.25;
        QTest::newRow("just before the maximum") << 7.99 << 7.99;
        QTest::newRow("at the maximum") << 8.0 << 8.0;
        QTest::newRow("beyond the maximum") << 800.0 << 8.0;
    }
    void rangesStayWithinTheirLimits() {
        QFETCH(const double, distance_m);
        QFETCH(const double, reading_m);
        const RobotModel robot = cart();
        const Numbers numbers{{"min_range", 0.5}, {"max_range", 8.0}, {"resolution", 0.5}, {"fov", 1.0}};
        SonarSensor sonar(modelOf("Sonar", numbers), birthOn(robot));
        QCOMPARE(sonar.range_m(Eigen::Isometry3d::Identity(), Sphere(distance_m)), reading_m);
        ScannerSensor scanner(modelOf("RangeScanner", numbers), birthOn(robot));
        const std::vector<double> ranges_m = scanner.scan(Eigen::Isometry3d::Identity(), Sphere(distance_m)).ranges_m;
        QCOMPARE(ranges_m.size(), std::size_t{3});
        for (const double range_m : ranges_m)
            QCOMPARE(range_m, reading_m);
    }

    void noiseNeverLeavesTheLimits() {
        const RobotModel robot = cart();
        SonarSensor sonar(modelOf("Sonar", {{"max_range", 8.0}, {"sigma", 0.5}}), birthOn(robot, true));
        double lowest_m = 100.0;
        double highest_m = 0.0;
        for (int i = 0; i < 500; ++i) {
            const double range_m = sonar.range_m(Eigen::Isometry3d::Identity(), Sphere(6.0));
            lowest_m = std::min(lowest_m, range_m);
            highest_m = std::max(highest_m, range_m);
            QCOMPARE(sonar.range_m(Eigen::Isometry3d::Identity(), Sphere(8.0)), 8.0); // a miss has no noise
        }
        QVERIFY(lowest_m >= 0.1 && lowest_m < 3.0);
        QCOMPARE(highest_m, 8.0);
    }

    void withoutNoiseEverySigmaIsZero() {
        const RobotModel robot = cart();
        SonarSensor sonar(modelOf("Sonar", {{"sigma", 0.5}}), birthOn(robot, false));
        for (int i = 0; i < 20; ++i)
            QCOMPARE(sonar.range_m(Eigen::Isometry3d::Identity(), Sphere(2.0)), 2.0);
        InsSensor ins(modelOf("INS", {{"sigma", 0.5}, {"precision", 1.0}}), birthOn(robot, false));
        Pose truth;
        for (int i = 0; i < 50; ++i) {
            truth.position_m.x() += i > 5 ? 0.5 : 0.0;
            QVERIFY((ins.estimate(truth).position_m - truth.position_m).norm() < 1e-9);
        }
    }

    void aFanHasItsLastBeam_data() {
        QTest::addColumn<double>("fov_deg");
        QTest::addColumn<double>("resolution_deg");
        QTest::addColumn<int>("beams");
        QTest::newRow("half a circle") << 180.0 << 1.0 << 181;
        QTest::newRow("thirds of a degree") << 240.0 << 1.0 / 3.0 << 721;
        QTest::newRow("tenths of a degree") << 270.0 << 0.1 << 2701;
        QTest::newRow("not a whole number of steps") << 10.0 << 3.0 << 4;
        QTest::newRow("a fan narrower than a step") << 0.5 << 1.0 << 1;
        QTest::newRow("a full circle") << 360.0 << 90.0 << 5;
    }
    void aFanHasItsLastBeam() {
        QFETCH(const double, fov_deg);
        QFETCH(const double, resolution_deg);
        QFETCH(const int, beams);
        const RobotModel robot = cart();
        ScannerSensor scanner(
            modelOf("RangeScanner", {{"fov", radians(fov_deg)}, {"resolution", radians(resolution_deg)}}),
            birthOn(robot));
        const protocol::RangeScan scan = scanner.scan(Eigen::Isometry3d::Identity(), Sphere(1.0));
        QCOMPARE(scan.ranges_m.size(), static_cast<std::size_t>(beams));
        QVERIFY(std::abs(scan.beamAngle_rad(0) + radians(fov_deg) / 2.0) < 1e-9);
    }

    void aSonarMayBeASingleRay_data() {
        QTest::addColumn<double>("cones");
        QTest::addColumn<double>("rays_per_cone");
        QTest::addColumn<int>("rays");
        QTest::newRow("no cone") << 0.0 << 16.0 << 1;
        QTest::newRow("cones without rays") << 3.0 << 0.0 << 1;
        QTest::newRow("less than no cone") << -2.0 << 16.0 << 1;
        QTest::newRow("a cone of one ray") << 1.0 << 1.0 << 2;
        QTest::newRow("ten cones") << 10.0 << 16.0 << 161;
    }
    void aSonarMayBeASingleRay() {
        QFETCH(const double, cones);
        QFETCH(const double, rays_per_cone);
        QFETCH(const int, rays);
        const RobotModel robot = cart();
        SonarSensor sonar(modelOf("Sonar", {{"cones", cones}, {"rays_per_cone", rays_per_cone}}), birthOn(robot));
        QCOMPARE(sonar.rayCount(), static_cast<std::size_t>(rays));
        QCOMPARE(sonar.range_m(Eigen::Isometry3d::Identity(), Sphere(2.5)), 2.5);
    }

    void aCameraZoomsWithinItsLimits_data() {
        QTest::addColumn<double>("wanted_rad");
        QTest::addColumn<bool>("ok");
        QTest::addColumn<double>("set_rad");
        QTest::newRow("between") << 1.0 << true << 1.0;
        QTest::newRow("at the largest") << 1.5 << true << 1.5;
        QTest::newRow("above the largest") << 1.6 << false << 1.5;
        QTest::newRow("at the smallest") << 0.5 << false << 0.5;
        QTest::newRow("below the smallest") << 0.1 << false << 0.5;
        QTest::newRow("back to the default") << 0.0 << false << 0.8;
        QTest::newRow("below zero") << -1.0 << false << 0.5;
    }
    void aCameraZoomsWithinItsLimits() {
        QFETCH(const double, wanted_rad);
        QFETCH(const bool, ok);
        QFETCH(const double, set_rad);
        const RobotModel robot = cart();
        CameraSensor camera(modelOf("Camera", {{"fov", 0.8}, {"min_fov", 0.5}, {"max_fov", 1.5}}), birthOn(robot));
        const auto answer = camera.set(protocol::Command(protocol::ZoomCamera{wanted_rad}), false);
        QVERIFY(answer);
        QCOMPARE(answer->ok, ok);
        QCOMPARE(answer->parts.size(), std::size_t{1});
        QCOMPARE(answer->parts.front().fov_rad, std::optional(set_rad));
        QCOMPARE(settingOf(camera.udkSettings(), "CameraFov"), degrees(set_rad));
        QCOMPARE(settingOf(camera.settings(), "CameraDefFov"), 0.8); // the default stays
    }

    void aPictureHasASensibleSize_data() {
        QTest::addColumn<double>("wanted");
        QTest::addColumn<double>("pixels");
        QTest::newRow("none") << 0.0 << 16.0;
        QTest::newRow("less than none") << -640.0 << 16.0;
        QTest::newRow("few") << 15.6 << 16.0;
        QTest::newRow("a fraction") << 640.4 << 640.0;
        QTest::newRow("many") << 1280.0 << 1280.0;
        QTest::newRow("too many") << 1e9 << 1280.0;
    }
    void aPictureHasASensibleSize() {
        QFETCH(const double, wanted);
        QFETCH(const double, pixels);
        const RobotModel robot = cart();
        const CameraSensor camera(modelOf("Camera", {{"width", wanted}, {"height", wanted}}), birthOn(robot));
        QCOMPARE(settingOf(camera.udkSettings(), "TextureResolutionX"), pixels);
        QCOMPARE(settingOf(camera.udkSettings(), "TextureResolutionY"), pixels);
    }

    /// In UDK a touch sensor reports at every second tick.
    void aTouchBetweenTwoReportsIsTold() {
        DrivenRobot dog(flatWorld(), USAR_SOURCE_DIR "/resources/robots", "ERS", 0.0, 0.0);
        dog.run(Seconds{1.0}); // It stands on its paws.
        const auto paw = std::ranges::find_if(dog.model.sensors, [&](const SensorModel& sensor) {
            return sensor.type == "Touch" && dog.body.touched(sensor.link);
        });
        QVERIFY(paw != dog.model.sensors.end());
        const auto sensor = std::move(*makeSensor(*paw, birthOn(dog.model)));
        const RayCaster caster(dog.world);
        const WorldRays rays(caster, *dog.physics, dog.body.id());
        Scene scene;
        const SensorView view{Seconds{1.0}, Seconds{0.1}, dog.body, rays, dog.world, scene};
        const auto told = [&] {
            std::vector<protocol::InfoMessage> lines;
            sensor->measure(view, lines);
            return std::get<protocol::TouchReadings>(lines.at(0)).touches.at(0).touched;
        };
        sensor->passOver(view);
        dog.body.forgetTouches();
        QVERIFY(told());
        QVERIFY(!told());
    }

    void onlyOwnCommandsAreAnswered_data() {
        QTest::addColumn<QString>("type");
        QTest::addColumn<bool>("reset");
        QTest::addColumn<bool>("scan");
        QTest::addColumn<bool>("zoom");
        QTest::newRow("a sonar") << "Sonar" << false << false << false;
        QTest::newRow("a scanner") << "RangeScanner" << false << true << false;
        QTest::newRow("odometry") << "Odometry" << true << false << false;
        QTest::newRow("an encoder") << "Encoder" << true << false << false;
        QTest::newRow("a camera") << "Camera" << false << false << true;
        QTest::newRow("a touch sensor") << "Touch" << false << false << false;
        QTest::newRow("a ground truth") << "GroundTruth" << false << false << false;
    }
    void onlyOwnCommandsAreAnswered() {
        QFETCH(const QString, type);
        QFETCH(const bool, reset);
        QFETCH(const bool, scan);
        QFETCH(const bool, zoom);
        const RobotModel robot = cart();
        SensorModel model = modelOf(type.toStdString());
        model.words = {{"left", "LeftWheel"}, {"right", "RightWheel"}, {"joint", "LeftWheel"}};
        const auto sensor = makeSensor(model, birthOn(robot));
        QVERIFY2(sensor, sensor ? "" : sensor.error().text().c_str());
        const auto answers = [&](const protocol::Command& command) {
            const auto answer = (*sensor)->set(command, true);
            return answer && answer->type == model.type && answer->name == "S1";
        };
        QCOMPARE(answers(protocol::Command(protocol::ResetSensor{"Odometry"})), reset);
        QCOMPARE(answers(protocol::Command(protocol::ScanNow{"RangeScanner"})), scan);
        QCOMPARE(answers(protocol::Command(protocol::ZoomCamera{1.0})), zoom);
    }

    void namesWhatAModelLacks_data() {
        QTest::addColumn<QString>("type");
        QTest::addColumn<QString>("word");
        QTest::addColumn<QString>("joint");
        QTest::addColumn<QString>("text");
        const QString joint = "robot Cart: the sensor \"S1\" needs the name of a joint as usar:%1. Fix its file.";
        QTest::newRow("an unknown type")
            << "Radar"
            << ""
            << ""
            << "robot Cart: there is no sensor of the type Radar. Check usar:type of \"S1\".";
        QTest::newRow("no type") << ""
                                 << ""
                                 << ""
                                 << "robot Cart: there is no sensor of the type . Check usar:type of \"S1\".";
        QTest::newRow("odometry without joints") << "Odometry"
                                                 << ""
                                                 << "" << joint.arg("left");
        QTest::newRow("odometry with one joint") << "odometry"
                                                 << "left"
                                                 << "LeftWheel" << joint.arg("right");
        QTest::newRow("an encoder of a joint that is not there") << "Encoder"
                                                                 << "joint"
                                                                 << "Knee" << joint.arg("joint");
        QTest::newRow("an encoder of a joint in another case") << "Encoder"
                                                               << "joint"
                                                               << "leftwheel" << joint.arg("joint");
    }
    void namesWhatAModelLacks() {
        QFETCH(const QString, type);
        QFETCH(const QString, word);
        QFETCH(const QString, joint);
        QFETCH(const QString, text);
        const RobotModel robot = cart();
        SensorModel model = modelOf(type.toStdString());
        model.words[word.toStdString()] = joint.toStdString();
        const auto sensor = makeSensor(model, birthOn(robot));
        QVERIFY(!sensor);
        QCOMPARE(QString::fromStdString(sensor.error().text()), text);
    }

    void typesReportInTheOrderOfATick_data() {
        QTest::addColumn<protocol::Dialect>("profile");
        QTest::addColumn<QStringList>("order");
        QTest::newRow("UT2004") << protocol::Dialect::Ut2004
                                << QStringList{"Sonar",      "IR",          "Range",   "RangeScanner", "IRScanner",
                                               "INS",        "Odometry",    "Encoder", "Touch",        "RFID",
                                               "VictSensor", "GroundTruth", "GPS"};
        QTest::newRow("UDK") << protocol::Dialect::Udk
                             << QStringList{"GroundTruth", "Odometry",   "INS",     "RangeScanner",
                                            "Camera",      "Tachometer", "Encoder", "Accel"};
    }
    void typesReportInTheOrderOfATick() {
        QFETCH(const protocol::Dialect, profile);
        QFETCH(const QStringList, order);
        const auto at = [profile](const QString& type) { return orderOf(type.toStdString(), profile); };
        for (qsizetype i = 1; i < order.size(); ++i)
            QVERIFY2(at(order[i - 1]) < at(order[i]), qPrintable(order[i]));
        QCOMPARE(at("rangescanner"), at("RangeScanner"));
        QVERIFY(at("no such type") > at("Camera"));
    }
};

USAR_TEST(tst_SensorLimits)

} // namespace tst_sensor_limits

#include "tst_sensor_limits.moc"
