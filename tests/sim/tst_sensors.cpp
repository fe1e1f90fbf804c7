#include <QObject>
#include <QString>
#include <QTest>

#include "core/sim/sensors/motion_sensors.h"
#include "core/sim/sensors/range_sensors.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_sensors {

using namespace usar;
using namespace usar::sim;

namespace {

/// A plane x = `distance_m`, or z = 0 when looked at from above.
struct Wall : Rays {
    double distance_m = 1e9;
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const override {
        const double hit_m = (distance_m - origin_m.x()) / direction.x();
        return hit_m > 0.0 ? std::min(hit_m, maximum_m) : maximum_m;
    }
};

struct Floor : Rays {
    double cast(const Vec3& origin_m, const Vec3& direction, double maximum_m) const override {
        const double hit_m = -origin_m.z() / direction.z();
        return hit_m > 0.0 ? std::min(hit_m, maximum_m) : maximum_m;
    }
};

Eigen::Isometry3d atHeight(double z_m) {
    return Pose{{0.0, 0.0, z_m}, 0.0, 0.0, 0.0}.isometry();
}

SensorBirth birth(std::uint64_t seed, std::uint64_t stream, const Pose& base_in_map = {}) {
    static const RobotModel robot;
    return {robot, base_in_map, Seconds{0.2}, true, seeded(seed, stream)};
}

SensorModel quietSonar(double yaw_rad = 0.0, double cones = 2.0) {
    SensorModel model;
    model.sensor_in_link.yaw_rad = yaw_rad;
    model.numbers = {{"sigma", 0.0}, {"cones", cones}};
    return model;
}

/// A belly mount: x down, y left.
SensorModel bellyScanner(double sigma = 0.0) {
    SensorModel model;
    model.sensor_in_link.pitch_rad = pi / 2.0;
    model.numbers = {{"sigma", sigma}};
    return model;
}

double rms(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value * value;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

} // namespace

class tst_Sensors : public QObject {
    Q_OBJECT

private slots:
    void sonarReadsTheNearestPointOfItsCone_data() {
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<double>("wall_m");
        QTest::addColumn<double>("reading_m");
        QTest::newRow("square to the wall") << 0.0 << 2.0 << 2.0;
        QTest::newRow("turned: the cone's edge is nearest") << 30.0 << 2.0 << 2.0 / std::cos(radians(22.5));
        QTest::newRow("turned within half a beam") << 7.5 << 2.0 << 2.0;
        QTest::newRow("too far") << 0.0 << 5.5 << 5.0;
        QTest::newRow("too near") << 0.0 << 0.03 << 0.1;
        QTest::newRow("looking away") << 180.0 << 2.0 << 5.0;
    }
    void sonarReadsTheNearestPointOfItsCone() {
        QFETCH(double, yaw_deg);
        QFETCH(double, wall_m);
        QFETCH(double, reading_m);
        SonarSensor sonar(quietSonar(radians(yaw_deg)), birth(1, 1));
        Wall wall;
        wall.distance_m = wall_m;
        QVERIFY(std::abs(sonar.range_m(Eigen::Isometry3d::Identity(), wall) - reading_m) < 1e-9);
    }

    // The mount of a P2DX, 0.22 m over the ground of a hall, whose posts are even.
    void sonarHearsWhatSendsAnEcho_data() {
        QTest::addColumn<World>("world");
        QTest::addColumn<double>("yaw_deg");
        QTest::addColumn<double>("reading_m");
        QTest::addColumn<double>("tolerance_m");
        const auto with = [](const Box& box) {
            World world = flatWorld();
            world.boxes.push_back(box);
            return world;
        };
        const auto box = [](double x_m, const Vec3& size_m, double yaw_rad = 0.0) {
            const Vec3 center_m{x_m + size_m.x() / 2.0, 0.0, size_m.z() / 2.0};
            return Box{.center_in_map = {.position_m = center_m, .yaw_rad = yaw_rad}, .size_m = size_m};
        };
        QTest::newRow("an empty hall") << flatWorld() << 0.0 << 5.0 << 1e-9;
        const World wall = with(box(2.0, {0.2, 40.0, 3.0}));
        for (const int off_deg : {0, 10, 20, 30, 40}) { // The cone reaches 10 degrees nearer to the wall's normal.
            const double nearest_m = 2.0 / std::cos(radians(std::max(0, off_deg - 10)));
            QTest::addRow("a wall at 2 m, %d degrees off", off_deg) << wall << 1.0 * off_deg << nearest_m << 0.01;
        }
        QTest::newRow("a wall met too flatly") << wall << 75.0 << 5.0 << 1e-9;
        QTest::newRow("a step of 10 cm") << with(box(1.5, {1.0, 4.0, 0.10})) << 0.0 << 1.52 << 0.03;
        QTest::newRow("a leg of a table") << with(box(2.0, {0.05, 0.05, 0.7})) << 0.0 << 2.0 << 0.02;
        QTest::newRow("one that is turned") << with(box(2.0, {0.05, 0.05, 0.7}, pi / 4.0)) << 0.0 << 1.99 << 0.02;
        QTest::newRow("a slope of rubble") << groundOf([](const Vec2& at) {
            const double up_m = 0.03 * std::sin(5.0 * at.x()) * std::cos(6.0 * at.y());
            return at.x() < 2.0 ? 0.0 : (at.x() - 2.0) * std::tan(radians(20.0)) + up_m;
        }) << 0.0 << 2.0 << 0.8;
    }
    void sonarHearsWhatSendsAnEcho() {
        QFETCH(const World, world);
        QFETCH(const double, yaw_deg);
        QFETCH(const double, reading_m);
        QFETCH(const double, tolerance_m);
        const RayCaster still(world);
        const auto physics = makePhysics(world);
        const WorldRays rays(still, *physics, physics->add(airRobotBody(), {.position_m = {-20.0, 0.0, 5.0}}));
        SensorModel model = quietSonar(radians(yaw_deg));
        model.numbers["beam_angle"] = radians(20.0);
        SonarSensor sonar(model, birth(1, 1));
        const double heard_m = sonar.range_m(atHeight(0.22), rays);
        QVERIFY2(std::abs(heard_m - reading_m) <= tolerance_m, qPrintable(QString::number(heard_m)));
    }

    void aSonarOfUdkIsItsCentralRay() {
        SensorBirth born = birth(1, 1);
        born.profile = protocol::Dialect::Udk;
        SonarSensor sonar(quietSonar(radians(30.0)), born);
        QCOMPARE(sonar.rayCount(), 1u);
        Wall wall;
        wall.distance_m = 2.0;
        QVERIFY(std::abs(sonar.range_m(Eigen::Isometry3d::Identity(), wall) - 2.0 / std::cos(radians(30.0))) < 1e-9);
        QVERIFY(std::abs(sonar.range_m(atHeight(0.5), wall) - 2.0 / std::cos(radians(30.0))) < 1e-9);
    }

    void sonarRaysAreOneAndTheCones() {
        QCOMPARE(SonarSensor(quietSonar(0.0, 2.0), birth(1, 1)).rayCount(), 33u);
        QCOMPARE(SonarSensor(quietSonar(0.0, 10.0), birth(1, 1)).rayCount(), 161u);
    }

    void beamsOverAFlatFloorReadHeightOverCosine() {
        ScannerSensor scanner(bellyScanner(), birth(1, 1));
        const auto scan = scanner.scan(atHeight(6.0), Floor());
        QCOMPARE(scan.ranges_m.size(), 181u);
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
            const double expected_m = std::min(20.0, 6.0 / std::cos(scan.beamAngle_rad(i)));
            QVERIFY2(std::abs(scan.ranges_m[i] - expected_m) < 1e-6, qPrintable(QString::number(i)));
        }
    }

    void beamsRunFromRightToLeft() {
        ScannerSensor scanner(bellyScanner(), birth(1, 1));
        Eigen::Isometry3d rolled = Pose{{0.0, 0.0, 6.0}, radians(20.0), 0.0, 0.0}.isometry(); // left side up
        const auto scan = scanner.scan(rolled, Floor());
        QVERIFY(std::abs(scan.ranges_m[90] - 6.0 / std::cos(radians(20.0))) < 1e-6);
        QVERIFY(std::abs(scan.ranges_m[70] - 6.0) < 1e-6); // 20 degrees to the right is straight down
        QVERIFY(scan.ranges_m[60] < scan.ranges_m[120]);   // the lowered right side is nearer
    }

    void scannerNoiseIsSevenHundredthsOfAPercent_data() {
        QTest::addColumn<double>("height_m");
        QTest::newRow("near") << 0.5;
        QTest::newRow("scan altitude") << 6.0;
        QTest::newRow("far") << 18.0;
    }
    void scannerNoiseIsSevenHundredthsOfAPercent() {
        QFETCH(double, height_m);
        ScannerSensor scanner(bellyScanner(0.0007), birth(7, 1));
        std::vector<double> errors;
        double sum = 0.0;
        for (int i = 0; i < 4000; ++i) {
            errors.push_back(scanner.scan(atHeight(height_m), Floor()).ranges_m[90] / height_m - 1.0);
            sum += errors.back();
        }
        QVERIFY(std::abs(rms(errors) - 0.0007) < 0.00004);
        QVERIFY(std::abs(sum / 4000.0) < 0.00005);
    }

    void aMissHasNoNoise() {
        ScannerSensor scanner(bellyScanner(0.0007), birth(7, 1));
        for (int i = 0; i < 100; ++i)
            QCOMPARE(scanner.scan(atHeight(30.0), Floor()).ranges_m[90], 20.0);
    }

    void insDriftsAsThePublishedModel_data() {
        QTest::addColumn<double>("way_m");
        QTest::addColumn<double>("horizontal_m");
        QTest::addColumn<double>("height_m");
        QTest::newRow("100 m") << 100.0 << 0.32 << 0.22;
        QTest::newRow("500 m") << 500.0 << 0.73 << 0.53;
        QTest::newRow("1 km") << 1000.0 << 1.07 << 0.76;
        QTest::newRow("3 km") << 3000.0 << 2.17 << 1.52;
    }
    void insDriftsAsThePublishedModel() {
        QFETCH(double, way_m);
        QFETCH(double, horizontal_m);
        QFETCH(double, height_m);
        std::vector<double> horizontal;
        std::vector<double> height;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            InsSensor ins({}, birth(seed, 3));
            Pose truth;
            for (int i = 0; i < 3; ++i)
                ins.estimate(truth);
            Pose estimate;
            for (double flown_m = 0.0; flown_m < way_m; flown_m += 0.2) {
                truth.position_m.x() += 0.2;
                estimate = ins.estimate(truth);
            }
            const Vec3 error_m = estimate.position_m - truth.position_m;
            horizontal.push_back(error_m.head<2>().norm());
            height.push_back(error_m.z());
        }
        QVERIFY2(std::abs(rms(horizontal) / horizontal_m - 1.0) < 0.15, qPrintable(QString::number(rms(horizontal))));
        QVERIFY2(std::abs(rms(height) / height_m - 1.0) < 0.15, qPrintable(QString::number(rms(height))));
    }

    void insHeadingDriftsByTurning() {
        std::vector<double> errors_deg;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            InsSensor ins({}, birth(seed, 3));
            Pose truth;
            for (int i = 0; i < 3; ++i)
                ins.estimate(truth);
            Pose estimate;
            for (double turned_rad = 0.0; turned_rad < pi / 2.0; turned_rad += 0.1) {
                truth.yaw_rad += 0.1;
                estimate = ins.estimate(truth);
            }
            errors_deg.push_back(degrees(normalizedAngle(estimate.yaw_rad - truth.yaw_rad)));
        }
        QVERIFY2(std::abs(rms(errors_deg) / 1.1 - 1.0) < 0.15, qPrintable(QString::number(rms(errors_deg))));
    }

    void insStaysAtTheSpawnPoseUntilTwoScansAtRest() {
        InsSensor ins({}, birth(1, 1, {{1.0, 2.0, 3.0}}));
        Pose truth{{1.0, 2.0, 3.0}, 0.0, 0.0, 0.0};
        for (int i = 0; i < 20; ++i) { // turning all the time
            truth.yaw_rad += 0.05;
            truth.position_m.x() += 0.2;
            QCOMPARE(ins.estimate(truth).position_m, Vec3(1.0, 2.0, 3.0));
        }
        ins.estimate(truth);
        ins.estimate(truth);
        truth.position_m.x() += 0.2;
        QVERIFY(std::abs(ins.estimate(truth).position_m.x() - 1.2) < 0.05);
    }

    void insIsSetOnlyAtRest() {
        InsSensor ins({}, birth(1, 1));
        const Pose wanted{{4.0, 5.0, 6.0}, 0.0, 0.0, 0.5};
        QVERIFY(!ins.setEstimate(wanted, false));
        QCOMPARE(ins.estimate(Pose{}), Pose{});
        QVERIFY(ins.setEstimate(wanted, true));
        QCOMPARE(ins.estimate(Pose{}), wanted);
    }

    void aSetInsHasNoBias() {
        double sum_m = 0.0;
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            SensorModel model;
            model.numbers["precision"] = 50.0; // biases of up to 1 %
            InsSensor reset(model, birth(seed, 1));
            Pose truth;
            for (int i = 0; i < 3; ++i)
                reset.estimate(truth);
            QVERIFY(reset.setEstimate(Pose{}, true));
            for (int i = 0; i < 5000; ++i) {
                truth.position_m.x() += 0.2;
                reset.estimate(truth);
            }
            sum_m += std::abs(reset.estimate(truth).position_m.x() - truth.position_m.x());
        }
        QVERIFY(sum_m / 100.0 < 1.0); // with its bias it would be 5 m
    }

    void raysMeetOtherRobotsButNotTheirOwn() {
        const World world = flatWorld();
        const RayCaster still(world);
        const auto physics = makePhysics(world);
        const Pose self_in_map{.position_m = {0.0, 0.0, 5.0}};
        const BodyId self = physics->add(airRobotBody(), self_in_map);
        physics->add(airRobotBody(), {.position_m = {3.0, 0.0, 5.0}});
        SonarSensor sonar(quietSonar(), birth(1, 1));
        const WorldRays rays(still, *physics, self);
        QVERIFY(std::abs(sonar.range_m(self_in_map.isometry(), rays) - 2.5) < 0.02);
        QVERIFY(std::abs(rays.cast({0.0, 0.0, 5.0}, -Vec3::UnitZ(), 20.0) - 5.0) < 1e-6);
    }
};

USAR_TEST(tst_Sensors)

} // namespace tst_sensors

#include "tst_sensors.moc"
