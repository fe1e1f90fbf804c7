#include <QObject>
#include <QString>
#include <QTest>

#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_finding_sensors {

using namespace usar;
using namespace usar::sim;

namespace {

/// A P2DX of which sensors are added that it does not have, at the origin of a world, looking along x.
struct Finder {
    std::unique_ptr<Simulation> simulation;
    Talker talker;

    Finder(World world, std::vector<SensorModel> sensors, bool noise = false)
        : simulation(simulationOf(std::move(world), optionsWith(std::move(sensors), noise)))
        , talker(*simulation) {
        talker.hearText();
        talker.say("INIT {ClassName P2DX} {Name R1} {Location 0,0,-0.12}");
    }

    static SimulationOptions optionsWith(std::vector<SensorModel> sensors, bool noise) {
        RobotModel robot = *findRobot(*doubles::shippedRobots(), "P2DX");
        std::erase_if(robot.sensors, [](const SensorModel& one) { return one.type == "VictSensor"; });
        robot.sensors.insert(robot.sensors.end(), sensors.begin(), sensors.end());
        SimulationOptions options;
        options.noise = noise;
        options.robots = std::make_shared<const RobotCatalog>(RobotCatalog{robot});
        return options;
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i)
            simulation->step();
    }
    template <class Message>
    std::vector<Message> hearAll() {
        std::vector<Message> all;
        for (const protocol::InfoLine& line : talker.hear())
            if (const auto* const message = std::get_if<Message>(&line.message))
                all.push_back(*message);
        return all;
    }
};

SensorModel sensor(const char* type, Numbers numbers = {}) {
    SensorModel model;
    model.type = type;
    model.name = type;
    model.sensor_in_link.position_m = {0.0, 0.0, 0.5};
    model.numbers = std::move(numbers);
    return model;
}

World worldWithVictim(const Vec3& head_m, const std::string& status = "Calm") {
    World world = flatWorld();
    world.victims.push_back({"Becky", status, {{VictimPartKind::Head, head_m}}});
    return world;
}

} // namespace

class tst_FindingSensors : public QObject {
    Q_OBJECT

private slots:
    void tagsAreToldOnceAndWhenTheListChanges() {
        World world = flatWorld();
        world.rfid_tags = {{7, "near", {1.0, 0.5, 0.0}}, {8, "far", {5.0, 0.0, 0.0}}};
        Finder finder(world, {});
        finder.steps(10);
        const auto told = finder.hearAll<protocol::RfidReading>();
        QCOMPARE(told.size(), std::size_t(1));
        QCOMPARE(told[0].tags.size(), std::size_t(1));
        QCOMPARE(told[0].tags[0].id, 7LL);
        QVERIFY(told[0].tags[0].tag_in_reader_m);
        QVERIFY((told[0].tags[0].tag_in_reader_m->head<2>() - Vec2(1.0, 0.5)).norm() < 0.02);
        finder.talker.say("DRIVE {Left 10} {Right 10}");
        finder.steps(30); // some 5 m
        QVERIFY(!finder.hearAll<protocol::RfidReading>().empty());
    }

    void tagsAreReadAndWritten() {
        World world = flatWorld();
        world.rfid_tags = {{7, "first words", {1.0, 0.0, 0.0}}, {8, "far", {5.0, 0.0, 0.0}}};
        Finder finder(world, {});
        finder.steps(3);
        const auto ask = [&](const char* line) {
            finder.talker.hearText();
            finder.talker.say(line);
            finder.steps(1);
            return finder.talker.hearLast<protocol::Response>();
        };
        auto answer = ask("SET {Type RFID} {Name RFID} {Opcode Read} {Params 7}");
        QVERIFY(answer && answer->ok);
        QCOMPARE(answer->memory, std::string("first words"));
        answer = ask("SET {Type RFID} {Name RFID} {Opcode Write} {Params 7 visited by R1}");
        QVERIFY(answer && answer->ok);
        answer = ask("SET {Type RFID} {Name RFID} {Opcode Read} {Params 7}");
        QCOMPARE(answer->memory, std::string("visited by R1"));
        answer = ask("SET {Type RFID} {Name RFID} {Opcode Read} {Params 8}");
        QVERIFY(answer && !answer->ok);
    }

    void victimsAreSeenWhereNothingHidesThem_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("y_m");
        QTest::addColumn<bool>("wall");
        QTest::addColumn<bool>("seen");
        QTest::newRow("ahead") << 3.0 << 0.0 << false << true;
        QTest::newRow("ahead at the edge of the view") << 3.0 << 1.6 << false << true;
        QTest::newRow("outside the view") << 3.0 << 2.2 << false << false;
        QTest::newRow("too far") << 7.0 << 0.0 << false << false;
        QTest::newRow("behind a wall") << 3.0 << 0.0 << true << false;
        QTest::newRow("behind the robot") << -3.0 << 0.0 << false << false;
    }
    void victimsAreSeenWhereNothingHidesThem() {
        QFETCH(double, x_m);
        QFETCH(double, y_m);
        QFETCH(bool, wall);
        QFETCH(bool, seen);
        World world = worldWithVictim({x_m, y_m, 0.5});
        if (wall)
            world.boxes.push_back({Pose{.position_m = {1.5, 0.0, 1.0}}, {0.2, 4.0, 2.0}});
        Finder finder(world, {sensor("VictSensor")});
        finder.steps(8);
        const auto told = finder.hearAll<protocol::VictimReading>();
        QVERIFY(!told.empty());
        if (seen) {
            QCOMPARE(told.back().parts.size(), std::size_t(1));
            QCOMPARE(told.back().parts[0].part, std::string("Head"));
            QVERIFY((told.back().parts[0].part_in_sensor_m->head<2>() - Vec2(x_m, y_m)).norm() < 0.05);
        } else {
            QCOMPARE(told.back().status, std::string("NoVictims"));
        }
    }

    /// As many false alarms as the setting says, within four sigma of the binomial law.
    void falseAlarmsFollowTheirLaw() {
        Finder finder(flatWorld(), {sensor("VictSensor", {{"false_alarm", 0.1}})}, true);
        finder.steps(1000);
        int alarms = 0;
        for (const auto& told : finder.hearAll<protocol::VictimReading>())
            alarms += !told.parts.empty();
        QVERIFY2(std::abs(alarms - 100) < 4 * std::sqrt(1000 * 0.1 * 0.9), qPrintable(QString::number(alarms)));
    }

    void onlyWhoMovesIsFelt_data() {
        QTest::addColumn<QString>("status");
        QTest::addColumn<double>("probability");
        QTest::newRow("calm") << "Calm" << 0.5;
        QTest::newRow("unconscious") << "Unconscious" << 0.0;
        QTest::newRow("dead, in any case") << "DEAD" << 0.0;
    }
    void onlyWhoMovesIsFelt() {
        QFETCH(QString, status);
        QFETCH(double, probability);
        Finder finder(worldWithVictim({3.0, 0.0, 0.5}, status.toStdString()), {sensor("HumanMotion")});
        finder.steps(8);
        const auto told = finder.hearAll<protocol::HumanMotionReading>();
        QVERIFY(!told.empty() && std::abs(told.back().probability - probability) < 0.03);
    }

    void soundFallsWithTheDistance_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<double>("loudness_db");
        QTest::newRow("at the source") << 0.5 << 80.0;
        QTest::newRow("10 m off: 20 dB less") << 10.0 << 60.0;
        QTest::newRow("20 m off: 6 dB less again") << 20.0 << 53.98;
    }
    void soundFallsWithTheDistance() {
        QFETCH(double, distance_m);
        QFETCH(double, loudness_db);
        World world = flatWorld();
        world.sounds.push_back({"Siren", 80.0, {distance_m, 0.0, 0.6}});
        Finder finder(world, {sensor("Sound")});
        finder.steps(8);
        const auto told = finder.hearAll<protocol::SoundReading>();
        QVERIFY(!told.empty());
        QVERIFY2(std::abs(told.back().loudness_db - loudness_db) < 0.1,
                 qPrintable(QString::number(told.back().loudness_db)));
    }

    void silenceIsNotTold() {
        Finder finder(flatWorld(), {sensor("Sound")});
        finder.steps(8);
        QVERIFY(finder.hearAll<protocol::SoundReading>().empty());
    }

    void gasAddsUp() {
        World world = flatWorld();
        world.gases = {{"CO2", 8.0, {2.0, 0.0, 0.6}}, {"CO2", 1.0, {0.0, 0.5, 0.6}}, {"CH4", 9.0, {1.0, 0.0, 0.6}}};
        Finder finder(world, {sensor("CO2Sensor")});
        finder.steps(8);
        const auto told = finder.hearAll<protocol::GasReading>();
        QVERIFY(!told.empty() && std::abs(told.back().density - 3.0) < 0.05);
    }

    void theBallIsFoundWhereItLies() {
        World world = flatWorld();
        WorldObject ball;
        ball.name = "Ball";
        ball.class_name = "USARModels.SoccerBall";
        ball.body.mass_kg = 0.06;
        ball.body.inertia_kg_m2 = Vec3::Constant(4.4e-5);
        ball.body.rolling_friction_m = 0.002;
        ball.body.parts = {{SphereShape{0.043}, {}}};
        ball.body_in_map.position_m = {2.0, 0.5, 0.05};
        world.objects.push_back(ball);
        Finder finder(world, {sensor("Helper")});
        finder.steps(10);
        const auto told = finder.hearAll<protocol::BallReading>();
        QVERIFY(!told.empty() && told.back().visible && *told.back().visible && told.back().position);
        // Forward, right, down.
        const Vec3 seen_m = *told.back().position;
        QVERIFY2((seen_m.head<2>() - Vec2(2.0, -0.5)).norm() < 0.05, qPrintable(QString::number(seen_m.y())));
        QVERIFY(seen_m.z() > 0.4);
    }
};

USAR_TEST(tst_FindingSensors)

} // namespace tst_finding_sensors

#include "tst_finding_sensors.moc"
