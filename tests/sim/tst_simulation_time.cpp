#include <QObject>
#include <QTest>

#include "core/base/numbers.h"
#include "core/base/random.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_simulation_time {

using namespace usar;
using namespace usar::sim;

namespace {

using Lines = std::vector<std::string>;

const std::string init = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-6}";

World woodedWorld() {
    World world = groundOf([](const Vec2& p) { return 1.5 * std::sin(0.2 * p.x()) * std::cos(0.15 * p.y()); });
    Random random = seeded(5, 0);
    for (int i = 0; i < 120; ++i) {
        const Vec2 p(uniform(random, -30.0, 30.0), uniform(random, -30.0, 30.0));
        const double height_m = uniform(random, 2.0, 5.0);
        if (p.norm() > 4.0)
            world.plants.push_back({{p.x(), p.y(), world.terrain.height_m(p)},
                                    0.2,
                                    height_m,
                                    i % 2 == 0 ? CrownShape::Sphere : CrownShape::Cone,
                                    1.2,
                                    3.0});
    }
    return world;
}

std::string randomDrive(Random& random) {
    std::string line = "DRIVE";
    for (const char* const key : {"AltitudeVelocity", "LinearVelocity", "LateralVelocity", "RotationalVelocity"})
        line += std::string(" {") + key + " " + fixed(uniform(random, -1.5, 1.5), 3) + "}";
    return line;
}

/// Random flight by three robots, five ticks a second; all bytes that the server said.
std::string randomFlight(std::uint64_t seed, int ticks) {
    SimulationOptions options;
    options.seed = seed;
    const auto simulation = simulationOf(woodedWorld(), options);
    std::vector<ClientId> clients;
    std::string bytes;
    for (int i = 0; i < 3; ++i) {
        clients.push_back(simulation->connect());
        simulation->receive(clients.back(),
                            "INIT {ClassName AirRobot} {Location " + std::to_string(2 * i) + ",0,-7}\r\n");
    }
    Random random = seeded(99, 0);
    for (int tick = 0; tick < ticks; ++tick) {
        for (const ClientId client : clients)
            if (tick % 5 == 0)
                simulation->receive(client, randomDrive(random) + "\r\n");
        simulation->step();
        for (const ClientId client : clients)
            bytes += simulation->takeOutput(client);
    }
    return bytes;
}

} // namespace

class tst_SimulationTime : public QObject {
    Q_OBJECT

private slots:
    void sameSeedSameBytes() {
        const std::string once = randomFlight(3, 300);
        QVERIFY(once.size() > 900000);
        QVERIFY(once == randomFlight(3, 300));
    }

    void anotherSeedChangesTheNoise() { QVERIFY(randomFlight(3, 10) != randomFlight(4, 10)); }

    void anotherRobotChangesNobodysNoise() {
        const auto scans = [](bool with_company) {
            const auto simulation = simulationOf(flatWorld());
            Talker talker(*simulation);
            talker.say(init);
            simulation->step();
            Talker company(*simulation);
            if (with_company)
                company.say("INIT {ClassName AirRobot} {Location 25,25,-6}");
            steps(*simulation, 10);
            return talker.hearText();
        };
        QCOMPARE(scans(true), scans(false));
    }

    void chunksDoNotMatter() {
        const auto said = [](std::size_t chunk) {
            const auto simulation = simulationOf(flatWorld());
            const ClientId client = simulation->connect();
            const std::string all = init + "\r\nDRIVE {LinearVelocity 1}\nGETCONF {Type Robot}\r\n";
            for (std::size_t at = 0; at < all.size(); at += chunk)
                simulation->receive(client, std::string_view(all).substr(at, chunk));
            steps(*simulation, 10);
            return simulation->takeOutput(client);
        };
        const std::string whole = said(1000);
        QVERIFY(said(1) == whole);
        QVERIFY(said(7) == whole);
    }

    void lockstepIsAnsweredAtOnceAndWaitsForStep() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.hearText();
        QVERIFY(simulation->readyToStep());
        talker.say("LOCKSTEP {On true}");
        QCOMPARE(talker.hearText(), Lines{"NFO {Lockstep True}"});
        QVERIFY(simulation->hasLockstepClients());
        QVERIFY(simulation->readyToStep()); // without a robot it hears nothing that it could answer
        talker.say(init);
        QVERIFY(simulation->readyToStep());
        simulation->step();
        QCOMPARE(kindsOf(talker.hearText()), (Lines{"SEN GroundTruth", "STA"}));
        QVERIFY(!simulation->readyToStep());
        talker.say("STEP");
        QVERIFY(simulation->readyToStep());
        simulation->step();
        QVERIFY(!simulation->readyToStep());
        talker.hearText();
        talker.say("LOCKSTEP {On false}");
        QCOMPARE(talker.hearText(), Lines{"NFO {Lockstep False}"});
        QVERIFY(simulation->readyToStep());
    }

    void everyLockstepClientIsWaitedFor() {
        const auto simulation = simulationOf(flatWorld());
        Talker first(*simulation);
        Talker second(*simulation);
        Talker viewer(*simulation); // not in lockstep
        first.say("LOCKSTEP {On true}");
        second.say("LOCKSTEP {On true}");
        first.say(init);
        second.say("INIT {ClassName USARBot.AirRobot} {Name R2} {Location 5,5,-0.35}");
        simulation->step();
        QVERIFY(!simulation->readyToStep());
        first.say("STEP");
        QVERIFY(!simulation->readyToStep());
        second.say("STEP");
        QVERIFY(simulation->readyToStep());
        simulation->step();
        first.say("STEP");
        simulation->disconnect(second.id());
        QVERIFY(simulation->readyToStep());
    }

    void commandsBehindAStepWaitForTheNextTick() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say("LOCKSTEP {On true}");
        talker.say(init);
        talker.say("STEP");
        talker.say("GETGEO {Type Robot}");
        talker.say("STEP");
        talker.hearText();
        simulation->step();
        QCOMPARE(kindsOf(talker.hearText()), (Lines{"SEN GroundTruth", "STA"}));
        QVERIFY(simulation->readyToStep());
        simulation->step();
        QCOMPARE(kindsOf(talker.hearText()).front(), std::string("GEO"));
        QVERIFY(!simulation->readyToStep());
    }

    void idleMeansNobodyWouldNotice() {
        const auto simulation = simulationOf(flatWorld());
        QVERIFY(simulation->idle());
        Talker talker(*simulation);
        QVERIFY(simulation->idle());
        talker.say(init);
        QVERIFY(!simulation->idle());
        simulation->step();
        QVERIFY(!simulation->idle());
        simulation->disconnect(talker.id());
        QVERIFY(simulation->idle());
    }

    void timeGoesByTicks() {
        const auto simulation = simulationOf(flatWorld());
        QCOMPARE(simulation->now(), Seconds{0.0});
        steps(*simulation, 5);
        QVERIFY(std::abs(simulation->now().count() - 1.0) < 1e-12);
    }

    void aFloodOfCommandsIsBounded() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        for (int i = 0; i < 70000; ++i)
            talker.say("DRIVE {LinearVelocity 1}");
        QVERIFY(!simulation->takeLog().empty());
        simulation->step();
        QVERIFY(simulation->takeLog().size() <= 1000);
    }
};

USAR_TEST(tst_SimulationTime)

} // namespace tst_simulation_time

#include "tst_simulation_time.moc"
