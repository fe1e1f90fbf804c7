// A run that is kept and taken up again goes on byte by byte as the one that was not.
#include <QByteArray>
#include <QObject>
#include <QString>
#include <QTest>

#include "tests/doubles/shipped_robots.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_snapshot {

using namespace usar;
using namespace usar::sim;

namespace {

constexpr const char* init_air_robot = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-3}\r\n";
constexpr const char* init_ers = "INIT {ClassName ERS} {Name R2} {Location 3,0.5,-0.3}\r\n";

/// Two robots, a ball of the world controller, and a fault.
struct Run {
    std::unique_ptr<Simulation> simulation;
    ClientId flyer;
    ClientId walker;
    ClientId controller;

    explicit Run(std::uint64_t seed = 3) {
        SimulationOptions options;
        options.seed = seed;
        options.faults.push_back(readFault("wind speed=2 gust=1 from=3").value());
        simulation = simulationOf(flatWorld(), options);
        flyer = simulation->connect();
        walker = simulation->connect();
        controller = simulation->connect();
        simulation->receive(flyer, "LOCKSTEP {On true}\r\n");
        simulation->receive(flyer, init_air_robot);
        simulation->receive(walker, init_ers);
        simulation->receive(controller, "INIT {ClassName USARBot.WorldController} {Name C}\r\n");
        simulation->receive(
            controller, "CONTROL {Type Create} {ClassName USARModels.SoccerBall} {Name B} {Location 3.4,0.5,-1}\r\n");
    }
    /// One more tick, with commands; all that is said.
    std::string go(int tick) { return go(*simulation, tick); }
    std::string go(Simulation& in, int tick) const {
        in.receive(flyer, "DRIVE {LinearVelocity " + std::to_string(0.1 * (tick % 7)) + "}\r\nSTEP\r\n");
        in.receive(walker, "MULTIDRIVE {LFLeg1 " + std::to_string(0.1 * (tick % 5)) + "}\r\n");
        if (tick == 40)
            in.addFault(readFault("sensor_dropout robot=R1 sensor=INS share=0.5").value());
        in.step();
        return in.takeOutput(flyer) + in.takeOutput(walker) + in.takeOutput(controller);
    }
};

Result<std::unique_ptr<Simulation>> resumed(const Snapshot& snapshot) {
    return Simulation::resume(flatWorld(), doubles::shippedRobots(), snapshot);
}

} // namespace

class tst_Snapshot : public QObject {
    Q_OBJECT
private slots:
    void goesOnAsIfNothingHadBeen() {
        Run run;
        for (int tick = 0; tick < 60; ++tick)
            run.go(tick);
        const auto snapshot = run.simulation->snapshot();
        QVERIFY(snapshot);
        auto again = resumed(*snapshot);
        QVERIFY2(again, again ? "" : again.error().text().c_str());
        Simulation& twin = **again;
        QCOMPARE(twin.now(), run.simulation->now());

        // Its robots wait, and time with them, until somebody comes for each.
        QVERIFY(!twin.readyToStep());
        QCOMPARE(twin.orphans().size(), std::size_t(2));
        Run same; // for the numbers of its clients
        same.flyer = twin.connect();
        twin.receive(same.flyer, "LOCKSTEP {On true}\r\n");
        twin.receive(same.flyer, init_air_robot);
        QVERIFY(!twin.readyToStep());
        same.walker = twin.connect();
        same.controller = twin.connect();
        twin.receive(same.walker, init_ers);
        QVERIFY(twin.readyToStep());
        QVERIFY(twin.orphans().empty());
        const std::string greetings =
            twin.takeOutput(same.flyer) + twin.takeOutput(same.walker) + twin.takeOutput(same.controller);
        QVERIFY(greetings.find("NFO") != std::string::npos);
        for (int tick = 60; tick < 160; ++tick) {
            const std::string was = run.go(tick);
            const std::string is = same.go(twin, tick);
            QVERIFY2(was.size() > 1000 && is == was, qPrintable(QString("tick %1").arg(tick)));
        }
    }

    void canBeTakenUpTwiceAndGoDifferentWays() {
        Run run;
        for (int tick = 0; tick < 20; ++tick)
            run.go(tick);
        const auto snapshot = run.simulation->snapshot();
        const auto goOn = [&](const char* command) {
            auto fork = resumed(*snapshot);
            const ClientId client = (*fork)->connect();
            (*fork)->receive(client, std::string(init_air_robot) + command);
            for (int tick = 0; tick < 20; ++tick)
                (*fork)->step();
            return (*fork)->robots().back().base_in_map.position_m;
        };
        const Vec3 forth_m = goOn("DRIVE {LinearVelocity 2} {AltitudeVelocity 0}\r\n");
        const Vec3 up_m = goOn("DRIVE {LinearVelocity 0} {AltitudeVelocity 2}\r\n");
        QVERIFY(forth_m.x() > up_m.x() + 2.0);
        QVERIFY(up_m.z() > forth_m.z() + 2.0);
        QVERIFY(forth_m == goOn("DRIVE {LinearVelocity 2} {AltitudeVelocity 0}\r\n"));
    }

    void ofAResumedRunIsAnotherSnapshot() {
        Run run;
        for (int tick = 0; tick < 10; ++tick)
            run.go(tick);
        auto first = resumed(run.simulation->snapshot().value());
        const ClientId client = (*first)->connect();
        (*first)->receive(client, init_air_robot);
        (*first)->releaseFromLockstep((*first)->awaited().front()); // the walker
        for (int tick = 0; tick < 10; ++tick)
            (*first)->step();
        const auto snapshot = (*first)->snapshot();
        auto second = resumed(*snapshot);
        QVERIFY2(second, second ? "" : second.error().text().c_str());
        QCOMPARE((*second)->orphans().size(), std::size_t(1));
        QCOMPARE((*second)->robots().front().base_in_map, (*first)->robots().front().base_in_map);
    }

    void aRobotNobodyWantsIsLetGo() {
        Run run;
        for (int tick = 0; tick < 5; ++tick)
            run.go(tick);
        auto again = resumed(run.simulation->snapshot().value());
        QCOMPARE((*again)->awaited().size(), std::size_t(2));
        for (const ClientId client : (*again)->awaited())
            (*again)->releaseFromLockstep(client);
        QVERIFY((*again)->readyToStep());
        QVERIFY((*again)->robots().empty());
    }

    void whoTakesItUpIsToldHowFarItIsAndMayGiveUp() {
        Run run;
        for (int tick = 0; tick < 30; ++tick)
            run.go(tick);
        const Snapshot snapshot = run.simulation->snapshot().value();
        std::vector<double> done_s;
        const auto watch = [&](Seconds done, Seconds whole) {
            done_s.push_back(done.count());
            return whole == run.simulation->now();
        };
        QVERIFY(Simulation::resume(flatWorld(), doubles::shippedRobots(), snapshot, watch));
        QCOMPARE(done_s.size(), std::size_t(30));
        QVERIFY(std::ranges::is_sorted(done_s) && done_s.back() > 5.0);
        int asked = 0;
        const auto given_up = Simulation::resume(flatWorld(), doubles::shippedRobots(), snapshot,
                                                 [&](Seconds, Seconds) { return ++asked < 5; });
        QVERIFY(!given_up);
        QCOMPARE(asked, 5);
        QVERIFY(given_up.error().text().find("given up") != std::string::npos);
    }

    void theFileRoundTrips() {
        Run run;
        for (int tick = 0; tick < 5; ++tick)
            run.go(tick);
        run.simulation->receive(run.walker, std::string("\0\n\r bytes \xff", 12));
        const Snapshot snapshot = run.simulation->snapshot().value();
        const auto back = readSnapshot(write(snapshot));
        QVERIFY2(back, back ? "" : back.error().text().c_str());
        QVERIFY(*back == snapshot);
    }

    void aRunWithoutAJournalSaysThatItHasNoSnapshot() {
        SimulationOptions options;
        options.keeps_journal = false;
        const auto simulation = simulationOf(flatWorld(), options);
        simulation->receive(simulation->connect(), init_air_robot);
        simulation->step();
        const auto snapshot = simulation->snapshot();
        QVERIFY(!snapshot);
        QVERIFY(QString::fromStdString(snapshot.error().text()).contains("keeps no record of its input"));
    }

    void anotherWorldIsRefused() {
        Run run;
        for (int tick = 0; tick < 20; ++tick)
            run.go(tick);
        const auto other = Simulation::resume(lake(), doubles::shippedRobots(), run.simulation->snapshot().value());
        QVERIFY(!other);
        QVERIFY2(other.error().text().find("Use the world, the robot files and the program") != std::string::npos,
                 other.error().text().c_str());
    }

    void damagedFilesAreRefusedWithTheirLine_data() {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<QString>("words");
        Run run;
        run.go(0);
        const QByteArray good = QByteArray::fromStdString(write(run.simulation->snapshot().value()));
        QTest::newRow("empty") << QByteArray() << "this is not a snapshot";
        QTest::newRow("something else") << QByteArray("hello\n") << "this is not a snapshot";
        QTest::newRow("cut short") << good.chopped(20) << "the file is cut short";
        QTest::newRow("unknown word") << QByteArray(good).replace("\nseed", "\nsead") << "line 3: unknown word 'sead'";
        QTest::newRow("no number") << QByteArray(good).replace("\nticks 1", "\nticks x")
                                   << "'x' is not a valid number of ticks";
        QTest::newRow("a run without end") << QByteArray(good).replace("\nticks 1", "\nticks 999999999999")
                                           << "'999999999999' is not a valid number of ticks";
        QTest::newRow("steps without end") << QByteArray(good).replace("_tick 50", "_tick 4000000000")
                                           << "'4000000000' is not a valid number of steps";
        QTest::newRow("wrong kind") << QByteArray(good).replace("\nc 0 1 0\n", "\nz 0 1 0\n")
                                    << "'z' is not a kind of entry";
        QTest::newRow("wrong count") << QByteArray(good).replace("\nc 0 1 0\n", "\nc 0 1 999999999999\n")
                                     << "the file is cut short";
    }
    void damagedFilesAreRefusedWithTheirLine() {
        QFETCH(const QByteArray, file);
        QFETCH(const QString, words);
        const auto snapshot = readSnapshot(file.toStdString());
        QVERIFY(!snapshot);
        QVERIFY2(QString::fromStdString(snapshot.error().text()).contains(words), snapshot.error().text().c_str());
    }
};

USAR_TEST(tst_Snapshot)

} // namespace tst_snapshot

#include "tst_snapshot.moc"
