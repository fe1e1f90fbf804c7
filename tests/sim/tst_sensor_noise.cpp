// Each sensor's noise against its law, by statistics: mean and standard deviation of thousands of readings at rest.
#include <QObject>
#include <QString>
#include <QTest>

#include <cmath>
#include <functional>
#include <numeric>

#include "core/sim/sensors/sensor.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_sensor_noise {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr int readings = 4000;

struct Statistics {
    double mean = 0.0;
    double sigma = 0.0;
    double lag_one = 0.0; ///< correlation of neighbors
};

Statistics statisticsOf(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    Statistics s;
    s.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0.0;
    double products = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        squares += (values[i] - s.mean) * (values[i] - s.mean);
        products += i > 0 ? (values[i] - s.mean) * (values[i - 1] - s.mean) : 0.0;
    }
    s.sigma = std::sqrt(squares / (n - 1.0));
    s.lag_one = products / squares;
    return s;
}

/// The estimate of sigma from n readings has a standard error of sigma / sqrt(2 n), that of the mean sigma / sqrt(n).
void compareWithLaw(const std::vector<double>& values, double mean, double sigma) {
    const Statistics is = statisticsOf(values);
    const double n = static_cast<double>(values.size());
    const QString told = QString("mean %1, sigma %2, correlation %3").arg(is.mean).arg(is.sigma).arg(is.lag_one);
    QVERIFY2(std::abs(is.mean - mean) < 4.5 * sigma / std::sqrt(n), qPrintable(told));
    QVERIFY2(std::abs(is.sigma - sigma) < 4.5 * sigma / std::sqrt(2.0 * n), qPrintable(told));
    QVERIFY2(std::abs(is.lag_one) < 4.5 / std::sqrt(n), qPrintable(told));
}

/// A robot at rest before a wall, a person, a ball and something that hums, 2 to 4 m away.
class Bench {
public:
    Bench()
        : world_(worldToMeasure())
        , physics_(makePhysics(world_))
        , caster_(world_)
        , scene_(makeScene(world_, *physics_)) {
        refresh(scene_, *physics_);
    }

    std::vector<protocol::InfoMessage> measure(const SensorModel& model, std::uint64_t seed) {
        const RobotModel& robot = *findRobot(*doubles::shippedRobots(), "P2DX");
        const RobotBody body(*physics_, robot, {{0.0, 0.0, 0.2}});
        const WorldRays rays(caster_, *physics_, body.id());
        auto sensor = makeSensor(model, {robot, {}, Seconds{0.2}, true, seeded(seed, 1)});
        std::vector<protocol::InfoMessage> all;
        std::vector<protocol::InfoMessage> lines;
        for (int i = 0; i < readings; ++i) {
            lines.clear();
            (*sensor)->measure({Seconds{0.2 * i}, Seconds{0.2}, body, rays, world_, scene_}, lines);
            for (protocol::InfoMessage& line : lines)
                all.push_back(std::move(line));
        }
        return all;
    }

private:
    static World worldToMeasure() {
        World world = flatWorld();
        world.boxes.push_back({{{4.5, 0.0, 1.0}}, {1.0, 20.0, 4.0}}); // its face is 4 m ahead
        world.victims.push_back({"Becky", "Calm", {{VictimPartKind::Head, {3.0, 0.0, 0.7}}}});
        world.sounds.push_back({"Siren", 60.0, {0.0, 2.0, 0.7}});
        WorldObject ball{"Ball", "USARModels.SoccerBall", {}, {{2.0, 0.5, 0.7}}};
        ball.body.parts.push_back({SphereShape{0.1}, {}});
        world.objects.push_back(ball);
        return world;
    }

    World world_;
    std::unique_ptr<Physics> physics_;
    RayCaster caster_;
    Scene scene_;
};

} // namespace

using Value = std::function<double(const protocol::InfoMessage&)>;

namespace {

SensorModel sensor(const char* type, Numbers numbers = {}) {
    SensorModel model;
    model.type = type;
    model.name = type;
    model.sensor_in_link.position_m = {0.0, 0.0, 0.5};
    model.numbers = std::move(numbers);
    return model;
}

template <class Message>
Value valueOf(double (*value)(const Message&)) {
    return [value](const protocol::InfoMessage& line) { return value(std::get<Message>(line)); };
}

} // namespace

class tst_SensorNoise : public QObject {
    Q_OBJECT
private slots:
    void followsItsLaw_data() {
        using namespace protocol;
        QTest::addColumn<QString>("type");
        QTest::addColumn<double>("max_range"); // 0: the sensor's own
        QTest::addColumn<Value>("value");
        QTest::addColumn<double>("mean");
        QTest::addColumn<double>("sigma");
        const Value range = valueOf<RangeReadings>([](const RangeReadings& r) { return r.ranges.at(0).range_m; });
        const Value beam = valueOf<RangeScan>([](const RangeScan& r) { return r.ranges_m.at(r.ranges_m.size() / 2); });
        const Value north = valueOf<GpsReading>(
            [](const GpsReading& r) { return (degrees(*r.latitude_rad) - GpsReference{}.latitude_deg) * 111'200.0; });
        const Value west = valueOf<GpsReading>(
            [](const GpsReading& r) { return -(degrees(*r.longitude_rad) - GpsReference{}.longitude_deg) * 71'670.0; });
        // 0.07 % of the range (robots-and-worlds.md 4.1), at 4 m
        QTest::newRow("IR") << "IR" << 8.0 << range << 4.0 << 0.0028;
        QTest::newRow("single ray") << "Range" << 8.0 << range << 4.0 << 0.0028;
        QTest::newRow("range scanner, a beam") << "RangeScanner" << 20.0 << beam << 4.0 << 0.0028;
        QTest::newRow("IR scanner, a beam") << "IRScanner" << 20.0 << beam << 4.0 << 0.0028;
        // 0.1 % (4.2)
        QTest::newRow("sonar") << "Sonar" << 8.0
                               << valueOf<SonarReadings>([](const SonarReadings& r) { return r.ranges.at(0).range_m; })
                               << 4.0 << 0.004;
        // 0.25 m with all twelve satellites, 0.83 m with four (4.8); the wall hides one
        const double eleven_m = 0.83 + 7.0 / 8.0 * (0.25 - 0.83);
        QTest::newRow("GPS north") << "GPS" << 0.0 << north << 0.0 << eleven_m;
        QTest::newRow("GPS west") << "GPS" << 0.0 << west << 0.0 << eleven_m;
        // The figures of the sensor files (resources/robots/README.md)
        QTest::newRow("victim, ahead") << "VictSensor" << 0.0 << valueOf<VictimReading>([](const VictimReading& r) {
            return r.parts.at(0).part_in_sensor_m->x();
        }) << 3.0 << 0.02;
        QTest::newRow("human motion") << "HumanMotion" << 0.0
                                      << valueOf<HumanMotionReading>(
                                             [](const HumanMotionReading& r) { return r.probability; })
                                      << 0.5 << 0.05;
        QTest::newRow("sound") << "Sound" << 0.0
                               << valueOf<SoundReading>([](const SoundReading& r) { return r.loudness_db; })
                               << 60.0 - 20.0 * std::log10(2.0) << 0.5;
        QTest::newRow("ball, ahead") << "Helper" << 0.0
                                     << valueOf<BallReading>([](const BallReading& r) { return r.position->x(); })
                                     << 2.0 << 0.01 * std::hypot(2.0, 0.5);
        QTest::newRow("acceleration") << "Accel" << 0.0
                                      << valueOf<AccelerationReading>(
                                             [](const AccelerationReading& r) { return r.acceleration_m_s2.y(); })
                                      << 0.0 << 0.02;
        QTest::newRow("accelerometer, upright")
            << "AcceleroMeter" << 0.0 << valueOf<AccelerometerReading>([](const AccelerometerReading& r) {
                   return r.proper_acceleration_m_s2.z();
               })
            << 9.81 << 0.02;
    }
    void followsItsLaw() {
        QFETCH(const QString, type);
        QFETCH(const double, max_range);
        QFETCH(const Value, value);
        QFETCH(const double, mean);
        QFETCH(const double, sigma);
        SensorModel model = sensor(qPrintable(type));
        if (max_range > 0.0)
            model.numbers["max_range"] = max_range;
        model.numbers["false_alarm"] = 0.0;
        Bench bench;
        std::vector<double> values;
        for (const protocol::InfoMessage& line : bench.measure(model, 5))
            values.push_back(value(line));
        QCOMPARE(values.size(), std::size_t(readings));
        compareWithLaw(values, mean, sigma);
    }

    /// A wheel's turn in a tick is counted with a relative error of 0.25 %.
    void encodersErrInProportionToTheTurn() {
        RobotModel robot = *findRobot(*doubles::shippedRobots(), "P2DX");
        for (SensorModel& one : robot.sensors)
            if (one.type == "Encoder")
                one.numbers["resolution"] = 1e-5;
        robot.sensors.push_back(sensor("Tachometer"));
        SimulationOptions options;
        options.robots = std::make_shared<const RobotCatalog>(RobotCatalog{robot});
        options.battery_life = Seconds{1e6};
        const auto simulation = simulationOf(flatWorld(), options);
        Talker talker(*simulation);
        talker.say(init_p2dx);
        talker.say("DRIVE {Left 3} {Right 3}");
        std::vector<double> ratios;
        std::optional<long long> ticks;
        std::optional<double> turned_rad;
        for (int i = 0; i < 1500; ++i) {
            if (i % 200 == 100)
                talker.say(i % 400 == 100 ? "DRIVE {Left -3} {Right -3}"
                                          : "DRIVE {Left 3} {Right 3}"); // stays on the ground
            simulation->step();
            std::optional<long long> ticks_now;
            std::optional<double> turned_now_rad;
            for (const protocol::InfoLine& line : talker.hear()) {
                if (const auto* reading = std::get_if<protocol::EncoderReadings>(&line.message))
                    ticks_now = reading->encoders.at(0).ticks;
                if (const auto* reading = std::get_if<protocol::TachometerReading>(&line.message))
                    turned_now_rad = reading->angles_rad.at(0);
            }
            if (ticks && ticks_now && turned_rad && turned_now_rad && std::abs(*turned_now_rad - *turned_rad) > 0.4)
                ratios.push_back(static_cast<double>(*ticks_now - *ticks) * 1e-5 / (*turned_now_rad - *turned_rad));
            ticks = ticks_now;
            turned_rad = turned_now_rad;
        }
        QVERIFY(ratios.size() > 1000);
        const Statistics is = statisticsOf(ratios);
        const QString told = QString("mean %1, sigma %2").arg(is.mean).arg(is.sigma);
        QVERIFY2(std::abs(std::abs(is.mean) - 1.0) < 0.0005, qPrintable(told));
        QVERIFY2(std::abs(is.sigma - 0.0025) < 0.0003, qPrintable(told)); // the wire's last digit of the angle is in it
    }
};

USAR_TEST(tst_SensorNoise)

} // namespace tst_sensor_noise

#include "tst_sensor_noise.moc"
