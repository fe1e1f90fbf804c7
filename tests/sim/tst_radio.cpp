#include <cmath>

#include <QObject>
#include <QTest>

#include "core/sim/radio.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_radio {

using namespace usar;
using namespace usar::sim;

namespace {

Box wallAt(double x_m, double thickness_m = 0.2) {
    return {Pose{{x_m, 0.0, 1.5}, 0.0, 0.0, 0.0}, {thickness_m, 8.0, 3.0}};
}

Plant treeAt(double x_m) {
    return {.base_in_map_m = {x_m, 0.0, 0.0},
            .trunk_radius_m = 0.2,
            .trunk_height_m = 1.5,
            .crown = CrownShape::Sphere,
            .crown_radius_m = 1.5};
}

/// 1 m above flat ground on the x axis.
Vec3 at(double x_m) {
    return {x_m, 0.0, 1.0};
}

World flatWith(std::vector<Box> boxes, std::vector<Plant> plants = {}) {
    World world = flatWorld();
    world.boxes = std::move(boxes);
    world.plants = std::move(plants);
    return world;
}

/// A ridge across the x axis, 4 m high, from -half_m to half_m.
World ridge(double half_m) {
    return groundOf([half_m](const Vec2& p) { return std::abs(p.x()) <= half_m ? 4.0 : 0.0; });
}

} // namespace

class tst_Radio : public QObject {
    Q_OBJECT

private slots:
    void strengthFollowsTheClosedForm_data() {
        QTest::addColumn<double>("distance_m");
        QTest::addColumn<int>("obstacles");
        QTest::addColumn<double>("exponent");
        QTest::addColumn<double>("expected_dbm");
        QTest::newRow("at the reference distance") << 2.0 << 0 << 1.0 << -49.67;
        QTest::newRow("ten times as far, exponent 1: 10 dB less") << 20.0 << 0 << 1.0 << -59.67;
        QTest::newRow("ten times as far, exponent 2: 20 dB less") << 20.0 << 0 << 2.0 << -69.67;
        QTest::newRow("a wall takes 6.325 dB") << 2.0 << 1 << 1.0 << -55.995;
        QTest::newRow("five walls") << 2.0 << 5 << 1.0 << -81.295;
        QTest::newRow("more than five take no more") << 2.0 << 9 << 1.0 << -81.295;
        QTest::newRow("nearer than the reference is stronger") << 0.2 << 0 << 1.0 << -39.67;
        QTest::newRow("on the same spot it is finite") << 0.0 << 0 << 1.0 << -49.67 + 10.0 * std::log10(200.0);
    }
    void strengthFollowsTheClosedForm() {
        QFETCH(double, distance_m);
        QFETCH(int, obstacles);
        QFETCH(double, exponent);
        QFETCH(double, expected_dbm);
        RadioParameters parameters;
        parameters.exponent = exponent;
        QVERIFY(std::abs(strengthOver(distance_m, obstacles, parameters) - expected_dbm) < 1e-9);
    }

    void obstaclesAreCounted_data() {
        QTest::addColumn<World>("world");
        QTest::addColumn<int>("expected");
        QTest::newRow("open ground") << flatWorld() << 0;
        QTest::newRow("one wall") << flatWith({wallAt(3.0)}) << 1;
        QTest::newRow("three walls") << flatWith({wallAt(-4.0), wallAt(0.0), wallAt(5.0)}) << 3;
        QTest::newRow("a thin sheet") << flatWith({wallAt(0.0, 0.01)}) << 1;
        QTest::newRow("two sheets that touch are one") << flatWith({wallAt(0.0, 0.2), wallAt(0.2, 0.2)}) << 1;
        QTest::newRow("no more than five")
            << flatWith({wallAt(-9.0), wallAt(-6.0), wallAt(-3.0), wallAt(0.0), wallAt(3.0), wallAt(6.0), wallAt(9.0)})
            << 5;
        QTest::newRow("a wall behind the other end") << flatWith({wallAt(15.0)}) << 0;
        QTest::newRow("a tree is one, trunk and crown") << flatWith({}, {treeAt(0.0)}) << 1;
        QTest::newRow("two trees and a wall") << flatWith({wallAt(0.0)}, {treeAt(-5.0), treeAt(5.0)}) << 3;
        QTest::newRow("a ridge") << ridge(2.0) << 1;
        QTest::newRow("a hill of 16 m is two") << ridge(8.0) << 2;
        World water = flatWorld();
        water.water = Water{10.0, 1000.0};
        QTest::newRow("water is none") << water << 0;
    }
    void obstaclesAreCounted() {
        QFETCH(World, world);
        QFETCH(int, expected);
        const RayCaster still(world);
        QCOMPARE(obstaclesBetween(still, at(-12.0), at(12.0)), expected);
        QCOMPARE(obstaclesBetween(still, at(12.0), at(-12.0)), expected);
    }

    void theCountIsTheSameBothWays() {
        World world = flatWith({}, {});
        for (int i = 0; i < 40; ++i)
            world.plants.push_back({.base_in_map_m = {std::sin(i * 1.7) * 20.0, std::cos(i * 2.3) * 20.0, 0.0},
                                    .trunk_radius_m = 0.15,
                                    .trunk_height_m = 2.0,
                                    .crown = CrownShape::Cone,
                                    .crown_radius_m = 1.0,
                                    .crown_height_m = 3.0});
        const RayCaster still(world);
        for (int i = 0; i < 200; ++i) {
            const Vec3 a(std::sin(i * 0.9) * 25.0, std::cos(i * 1.1) * 25.0, 1.0);
            const Vec3 b(std::cos(i * 0.7) * 25.0, std::sin(i * 1.3) * 25.0, 2.5);
            QCOMPARE(obstaclesBetween(still, a, b), obstaclesBetween(still, b, a));
        }
    }

    void whoStandsOnOneSpotHasNothingBetween() {
        const World world = flatWith({wallAt(0.0)});
        QCOMPARE(obstaclesBetween(RayCaster(world), at(0.0), at(0.0)), 0);
    }

    void theSimulationTellsItsRadios() {
        auto simulation = simulationOf(flatWith({wallAt(4.0)}));
        Talker robot(*simulation);
        Talker station(*simulation);
        Talker nobody(*simulation);
        robot.say(init_p2dx);
        station.say("INIT {ClassName USARBot.ComStation} {Name Base} {Location 8,-3,-0.5}");
        steps(*simulation, 5);
        const std::vector<RadioStation> radios = simulation->radios();
        QCOMPARE(radios.size(), std::size_t(2));
        QCOMPARE(radios[0].name, std::string("R1"));
        QCOMPARE(radios[1].name, std::string("Base"));
        QVERIFY(radios[1].antenna_in_map_m.isApprox(Vec3(8.0, 3.0, 0.8)));
        const double distance_m = (radios[0].antenna_in_map_m - radios[1].antenna_in_map_m).norm();
        QCOMPARE(simulation->radioStrength_dbm(radios[0], radios[1]), strengthOver(distance_m, 1));
        QCOMPARE(simulation->radioStrength_dbm(radios[1], radios[0]), strengthOver(distance_m, 1));
    }

    void aBaseStationMayStandOnAStartPose() {
        World world = flatWorld();
        world.start_poses.push_back({"Hill", Pose{{5.0, 6.0, 1.0}, 0.0, 0.0, 0.0}});
        auto simulation = simulationOf(std::move(world));
        Talker station(*simulation);
        station.say("INIT {ClassName USARBot.ComStation} {Name Base} {Start Hill}");
        simulation->step();
        QVERIFY(simulation->radios().at(0).antenna_in_map_m.isApprox(Vec3(5.0, 6.0, 1.3)));
    }

    void anEmptyBatterySilencesARadio() {
        SimulationOptions options;
        options.battery_life = Seconds{1.0};
        auto simulation = simulationOf(flatWorld(), options);
        Talker robot(*simulation);
        robot.say(init_p2dx);
        simulation->step();
        QVERIFY(!simulation->radios().at(0).silent);
        steps(*simulation, 10);
        QVERIFY(simulation->radios().at(0).silent);
    }

    void whoLeavesIsHeardNoMore() {
        auto simulation = simulationOf(flatWorld());
        Talker station(*simulation);
        station.say("INIT {ClassName USARBot.ComStation} {Name Base} {Location 0,0,0}");
        simulation->step();
        QCOMPARE(simulation->radios().size(), std::size_t(1));
        simulation->disconnect(station.id());
        QVERIFY(simulation->radios().empty());
    }
};

USAR_TEST(tst_Radio)

} // namespace tst_radio

#include "tst_radio.moc"
