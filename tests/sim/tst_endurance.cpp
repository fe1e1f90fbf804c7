// Eight simulated hours of four robots in one world: no leak, no NaN, nobody falls through the ground.
// USAR_ENDURANCE_MINUTES shortens it.
#include <QObject>
#include <QString>
#include <QTest>

#include <fstream>

#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_endurance {

using namespace usar;
using namespace usar::sim;

namespace {

/// Of this process, in pages of 4096 bytes.
double residentMiB() {
    std::ifstream file("/proc/self/statm");
    double size = 0.0;
    double resident = 0.0;
    file >> size >> resident;
    return resident * 4096.0 / 1048576.0;
}

/// A hollow: whoever drives about stays in it.
World bowl() {
    World world = groundOf([](const Vec2& at_m) {
        const double r_m = at_m.norm();
        return r_m < 20.0 ? 0.0 : std::min(8.0, 0.08 * (r_m - 20.0) * (r_m - 20.0));
    });
    return world;
}

} // namespace

class tst_Endurance : public QObject {
    Q_OBJECT
private slots:
    void fourRobotsForEightHours() {
        const int minutes = qEnvironmentVariableIsSet("USAR_ENDURANCE_MINUTES")
                                ? qEnvironmentVariableIntValue("USAR_ENDURANCE_MINUTES")
                                : 480;
        SimulationOptions options;
        options.battery_life = Seconds{1e6};
        const auto simulation = simulationOf(bowl(), options);
        const World& world = simulation->world();
        const char* const inits[] = {"INIT {ClassName AirRobot} {Name Air} {Location 0,0,-4}",
                                     "INIT {ClassName P2DX} {Name Skid} {Location 5,0,-0.2}",
                                     "INIT {ClassName Sedan} {Name Car} {Location -6,0,-0.6}",
                                     "INIT {ClassName ERS} {Name Dog} {Location 0,6,-0.3}"};
        std::vector<std::unique_ptr<Talker>> talkers;
        for (const char* init : inits) {
            talkers.push_back(std::make_unique<Talker>(*simulation));
            talkers.back()->say(init);
        }
        double after_a_while_MiB = 0.0;
        for (int tick = 0; tick < minutes * 60 * 5; ++tick) {
            if (tick % 50 == 0) { // another way every ten seconds
                const int way = tick / 50 % 6;
                talkers[0]->say("DRIVE {AltitudeVelocity " + std::to_string(0.1 * (way % 3 - 1)) +
                                "} {LinearVelocity 1} {LateralVelocity 0} {RotationalVelocity 0.4}");
                talkers[1]->say(way < 3 ? "DRIVE {Left 3} {Right 2}" : "DRIVE {Left -2} {Right -3}");
                talkers[2]->say(way < 3 ? "DRIVE {Speed 3} {FrontSteer 0.4}" : "DRIVE {Speed -3} {FrontSteer 0.3}");
                talkers[3]->say("MULTIDRIVE {LFLeg1 " + std::to_string(0.2 * (way - 3)) + "} {RRLeg1 0.2} {RFLeg2 " +
                                std::to_string(0.1 * way) + "}");
            }
            simulation->step();
            std::size_t complaints = 0;
            for (const auto& talker : talkers)
                for (const protocol::InfoLine& line : talker->hear())
                    complaints += line.diagnostics.size() + (line.text.find("nan") != std::string::npos ? 1 : 0);
            QVERIFY2(complaints == 0, qPrintable(QString("tick %1").arg(tick)));
            const auto robots = simulation->robots();
            QCOMPARE(robots.size(), std::size_t(4));
            for (const RobotTruth& robot : robots) {
                const Vec3& at_m = robot.base_in_map.position_m;
                QVERIFY2(at_m.allFinite(), robot.name.c_str());
                const bool over_the_world = world.terrain.extent().contains(at_m.head<2>());
                QVERIFY2(!over_the_world || at_m.z() > world.terrain.height_m(at_m.head<2>()) - 0.05,
                         qPrintable(QString("%1 is under the ground at tick %2").arg(robot.name.c_str()).arg(tick)));
            }
            if (tick == 5 * 600)
                after_a_while_MiB = residentMiB();
        }
        simulation->takeLog();
        // What is kept for a snapshot grows with what was said to it: some hundred bytes every ten seconds and robot.
        const double grown_MiB = residentMiB() - after_a_while_MiB;
        qInfo("%d min, %.1f MiB, grown by %.1f MiB", minutes, residentMiB(), grown_MiB);
        if (minutes > 10)
            QVERIFY2(grown_MiB < 4.0 + 0.05 * minutes, qPrintable(QString::number(grown_MiB)));
    }
};

USAR_TEST(tst_Endurance)

} // namespace tst_endurance

#include "tst_endurance.moc"
