#include <chrono>
#include <optional>

#include <QByteArray>
#include <QCoreApplication>
#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QSignalSpy>
#include <QString>
#include <QTcpSocket>
#include <QTest>
#include <QVariant>

#include "core/server/simulator_server.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_simulator_server {

using namespace usar;
using namespace usar::server;

namespace {

sim::World flatWorld() {
    sim::World world;
    world.name = "flat";
    world.terrain = sim::Terrain(33, 33, 1.0, {-16.0, -16.0}, std::vector<float>(33 * 33, 0.0f));
    world.start_poses.push_back({"Middle", Pose{{0.0, 0.0, 0.3}, 0.0, 0.0, 0.0}});
    return world;
}

std::unique_ptr<sim::Simulation> flatSimulation() {
    return std::move(*sim::Simulation::make(flatWorld(), {.robots = doubles::shippedRobots()}));
}

const QByteArray init = "INIT {ClassName USARBot.AirRobot} {Name R1} {Location 0,0,-0.3}\r\n";

/// A server that listens on a free port.
struct Served {
    SimulatorServer server{flatSimulation()};
    quint16 port = *server.listen(0);

    explicit Served(Pace pace, double factor = 1.0) { server.setPace(pace, factor); }
    Seconds now() const { return server.figures().now; }
};

/// A client that keeps all it has read.
class Client {
public:
    explicit Client(quint16 port) {
        QObject::connect(&socket_, &QTcpSocket::readyRead, [this] { heard_ += socket_.readAll(); });
        socket_.connectToHost("127.0.0.1", port);
    }
    void say(const QByteArray& bytes) { socket_.write(bytes); }
    qsizetype count(const QByteArray& text) const { return heard_.count(text); }
    QTcpSocket& socket() { return socket_; }

private:
    QTcpSocket socket_;
    QByteArray heard_;
};

} // namespace

class tst_SimulatorServer : public QObject {
    Q_OBJECT

private slots:
    void greetsAndTellsStartPosesWhilePaused() {
        Served served(Pace::Paused);
        Client client(served.port);
        QTRY_COMPARE(client.count("NFO {Gametype BotDeathMatch} {Level flat}"), 1);
        client.say("GETSTARTPOSES\r\n");
        QTRY_COMPARE(client.count("{Middle 0.00,"), 1);
        QCOMPARE(served.now(), Seconds{0.0});
    }

    void listensOnLoopbackOnly() {
        Served served(Pace::Paused);
        QTcpSocket elsewhere;
        elsewhere.connectToHost("127.0.0.2", served.port); // loopback net, but not our address
        QVERIFY(!elsewhere.waitForConnected(2000));
    }

    void aPortInUseIsSaidWithTheMend() {
        Served served(Pace::Paused);
        SimulatorServer second(flatSimulation());
        const auto result = second.listen(served.port);
        QVERIFY(!result);
        const QString text = QString::fromStdString(result.error().text());
        QVERIFY2(text.contains(QString::number(served.port)) && text.contains("in use") && text.contains("--port"),
                 qPrintable(text));
    }

    void stepsOneTickAtATimeWhilePaused() {
        Served served(Pace::Paused);
        Client client(served.port);
        client.say(init);
        QTRY_COMPARE(served.server.figures().clients, 1);
        QTRY_COMPARE(client.count("NFO"), 1);
        QTRY_VERIFY((served.server.stepOnce(), client.count("STA") >= 1));
        const Seconds before = served.now();
        served.server.stepOnce();
        QVERIFY(std::abs((served.now() - before).count() - 0.2) < 1e-9);
    }

    void stepOnceMeansNothingWhileItRuns() {
        Served served(Pace::Factor, 0.001);
        served.server.stepOnce();
        QCOMPARE(served.now(), Seconds{0.0});
    }

    void runsByTheClock() {
        Served served(Pace::Factor, 20.0);
        QElapsedTimer wall;
        wall.start();
        QTRY_VERIFY(served.now() >= Seconds{10.0});
        // Never ahead of its pace; how far behind depends on the machine.
        QVERIFY(served.now().count() <= 20.0 * (static_cast<double>(wall.elapsed()) / 1000.0 + 0.1));
        served.server.setPace(Pace::Paused);
        const Seconds paused = served.now();
        QCoreApplication::sendPostedEvents();
        QCOMPARE(served.now(), paused);
    }

    void fastStandsStillWithoutRobots() {
        Served served(Pace::Fast);
        Client client(served.port);
        client.say("GETSTARTPOSES\r\n");
        QTRY_COMPARE(client.count("StartPoses"), 1);
        QCOMPARE(served.now(), Seconds{0.0});
        client.say(init);
        QTRY_VERIFY(served.now() > Seconds{20.0});
    }

    void lockstepAndFastRunAsFastAsTheClientAnswers() {
        Served served(Pace::Fast);
        Client client(served.port);
        int ticks = 0;
        qsizetype answered = 0;
        client.say("LOCKSTEP {On true}\r\n" + init + "STEP\r\n");
        QObject::connect(&client.socket(), &QTcpSocket::readyRead, &client.socket(), [&] {
            for (; answered < client.count("STA {") && ticks < 200; ++answered, ++ticks)
                client.say("STEP\r\n");
        });
        QTRY_COMPARE(client.count("STA {"), 201);
        QVERIFY(std::abs(served.now().count() - 201 * 0.2) < 1e-9);
        QCOMPARE(client.count("NFO {Lockstep True}"), 1);
    }

    void withoutItsStepNothingMoves() {
        Served served(Pace::Fast);
        Client client(served.port);
        client.say("LOCKSTEP {On true}\r\n" + init);
        QTRY_COMPARE(client.count("STA {"), 1); // the tick that brings the robot needs no STEP
        client.say("GETSTARTPOSES\r\n");        // a turn of the server's loop behind it
        QTRY_COMPARE(client.count("StartPoses"), 1);
        QVERIFY(std::abs(served.now().count() - 0.2) < 1e-9);
        client.say("STEP\r\n");
        QTRY_COMPARE(client.count("STA {"), 2);
        QVERIFY(std::abs(served.now().count() - 0.4) < 1e-9);
    }

    void whilePausedAStepOfTheClientDoesNotMoveIt() {
        Served served(Pace::Paused);
        Client client(served.port);
        client.say("LOCKSTEP {On true}\r\n" + init + "STEP\r\nGETSTARTPOSES\r\n");
        QTRY_COMPARE(client.count("StartPoses"), 1);
        QCOMPARE(served.now(), Seconds{0.0});
        served.server.stepOnce();
        QVERIFY(std::abs(served.now().count() - 0.2) < 1e-9);
        served.server.stepOnce(); // waits for the next STEP
        QVERIFY(std::abs(served.now().count() - 0.2) < 1e-9);
        client.say("STEP\r\n");
        QTRY_VERIFY(std::abs(served.now().count() - 0.4) < 1e-9);
    }

    // Nobody waits for a client that hears nothing, so ticks went on after the cut for as long as the machine took.
    void aRobotGoesInTheTickInWhichItsConnectionIsCut() {
        Served served(Pace::Fast);
        const auto half_open = sim::readFault("link_half_open from=1");
        const auto cut = sim::readFault("link_cut from=5");
        QVERIFY(half_open && cut);
        served.server.addFaults({*half_open, *cut}, false);
        Client client(served.port);
        QObject::connect(&client.socket(), &QTcpSocket::readyRead, &client.socket(), [&] { client.say("STEP\r\n"); });
        client.say("LOCKSTEP {On true}\r\n" + init + "STEP\r\n");
        QTRY_COMPARE(client.socket().state(), QAbstractSocket::UnconnectedState);
        QTRY_COMPARE(served.server.figures().clients, 0);
        QVERIFY2(std::abs(served.now().count() - 5.2) < 0.21, qPrintable(QString::number(served.now().count())));
    }

    void aLockstepClientThatLeavesFreesTheOthers() {
        Served served(Pace::Fast);
        Client staying(served.port);
        auto leaving = std::make_unique<Client>(served.port);
        leaving->say("LOCKSTEP {On true}\r\n" + init);
        QTRY_COMPARE(leaving->count("STA {"), 1);
        staying.say("LOCKSTEP {On true}\r\nINIT {ClassName USARBot.AirRobot} {Location 5,5,-0.3}\r\nGETSTARTPOSES\r\n");
        QTRY_COMPARE(staying.count("StartPoses"), 1);
        QCOMPARE(staying.count("STA {"), 0); // the first one holds the simulation
        leaving.reset();
        QTRY_COMPARE(staying.count("STA {"), 1);
        QTRY_COMPARE(served.server.figures().clients, 1);
    }

    void aClientThatHangsInLockstepHoldsNobodyUpForEver() {
        Served served(Pace::Fast);
        served.server.setLockstepPatience(std::chrono::milliseconds(300));
        QSignalSpy log(&served.server, &SimulatorServer::logged);
        Client hung(served.port);
        hung.say("LOCKSTEP {On true}\r\n" + init);
        QTRY_COMPARE(hung.count("STA {"), 1);
        Client other(served.port);
        other.say("INIT {ClassName USARBot.AirRobot} {Location 5,5,-0.3}\r\n");
        QTRY_VERIFY(other.count("STA {") > 3);
        QTRY_COMPARE(hung.count("NFO {Lockstep False}"), 1);
        QVERIFY(std::any_of(log.begin(), log.end(), [](const QList<QVariant>& one) {
            return one.first().toString().contains("client 1: taken out of lockstep");
        }));
        served.server.setLockstepPatience(std::chrono::seconds(60)); // or a slow machine would find it let go again
        hung.say("STEP\r\nLOCKSTEP {On true}\r\n");                  // it has come to itself
        QTRY_COMPARE(hung.count("NFO {Lockstep True}"), 2);
        const auto held = [&] {
            const Seconds before = served.now();
            const test::Beats beats(10); // at full speed each has many ticks
            return test::holdsUntil([&] { return served.now() == before; }, [&] { return beats.count() >= 5; });
        };
        QTRY_VERIFY(held());
    }

    void onlyTheOneThatHangsIsTakenOutOfLockstep() {
        Served served(Pace::Fast);
        served.server.setLockstepPatience(std::chrono::milliseconds(300));
        Client hung(served.port);
        hung.say("LOCKSTEP {On true}\r\n" + init);
        QTRY_COMPARE(hung.count("STA {"), 1);
        Client answering(served.port);
        answering.say("LOCKSTEP {On true}\r\nINIT {ClassName USARBot.AirRobot} {Location 5,5,-0.3}\r\nSTEP\r\n");
        QObject::connect(&answering.socket(), &QTcpSocket::readyRead, &answering.socket(),
                         [&] { answering.say("STEP\r\n"); });
        QTRY_VERIFY(answering.count("STA {") > 20);
        QCOMPARE(hung.count("NFO {Lockstep False}"), 1);
        QCOMPARE(answering.count("NFO {Lockstep False}"), 0);
    }

    void aClientMayTakeItsTime_data() {
        QTest::addColumn<bool>("paused");
        QTest::newRow("while it is alone") << false;
        QTest::newRow("while the simulation is paused") << true;
    }

    void aClientMayTakeItsTime() {
        QFETCH(bool, paused);
        Served served(Pace::Fast);
        served.server.setLockstepPatience(std::chrono::milliseconds(1));
        Client client(served.port);
        client.say("LOCKSTEP {On true}\r\n" + init);
        QTRY_COMPARE(client.count("STA {"), 1);
        std::optional<Client> other;
        if (paused) {
            served.server.setPace(Pace::Paused);
            other.emplace(served.port);
            QTRY_COMPARE(served.server.figures().clients, 2);
        }
        QSignalSpy reports(&served.server, &SimulatorServer::figuresChanged);
        QTRY_VERIFY(reports.size() >= 3);
        QCOMPARE(client.count("NFO {Lockstep False}"), 0);
        QVERIFY(std::abs(served.now().count() - 0.2) < 1e-9);
    }

    void clientsThatCloseTogetherLeaveTheServerAlive() {
        Served served(Pace::Paused);
        std::vector<std::unique_ptr<Client>> clients;
        for (int i = 0; i < 4; ++i) {
            clients.push_back(std::make_unique<Client>(served.port));
            clients.back()->say("INIT {ClassName USARBot.AirRobot} {Location " + QByteArray::number(4 * i - 8) +
                                ",0,-0.3}\r\n");
        }
        QTRY_COMPARE(served.server.figures().clients, 4);
        const auto all_fly = [&] {
            served.server.stepOnce();
            return std::ranges::all_of(clients, [](const auto& client) { return client->count("STA {") > 0; });
        };
        QTRY_VERIFY(all_fly());
        served.server.setPace(Pace::Factor, 50.0);
        QTRY_VERIFY(served.now() > Seconds{2.0});
        for (const auto& client : clients)
            client->socket().abort();
        // The ticks notice it, before the event loop does.
        served.server.setPace(Pace::Paused);
        for (int i = 0; i < 5; ++i)
            served.server.stepOnce();
        served.server.setPace(Pace::Factor, 50.0);
        QTRY_COMPARE(served.server.figures().clients, 0);
        Client next(served.port);
        QTRY_COMPARE(next.count("NFO {Gametype"), 1);
    }

    void aClientThatDoesNotReadIsDropped() {
        Served served(Pace::Fast);
        served.server.setUnreadLimit(1 << 16);
        QSignalSpy log(&served.server, &SimulatorServer::logged);
        QTcpSocket deaf;
        deaf.setReadBufferSize(4096);
        deaf.connectToHost("127.0.0.1", served.port);
        deaf.write(init);
        QTRY_COMPARE(served.server.figures().clients, 1);
        QTRY_COMPARE_WITH_TIMEOUT(served.server.figures().clients, 0, 60000);
        const bool said = std::any_of(log.begin(), log.end(), [](const QList<QVariant>& one) {
            return one.first().toString().contains("does not read");
        });
        QVERIFY(said);
    }

    void publishesFiguresAndRobots() {
        Served served(Pace::Factor, 10.0);
        QSignalSpy figures(&served.server, &SimulatorServer::figuresChanged);
        QSignalSpy robots(&served.server, &SimulatorServer::robotsChanged);
        Client client(served.port);
        client.say(init);
        QTRY_VERIFY(!robots.isEmpty() && !robots.last().first().value<std::vector<sim::RobotTruth>>().empty());
        const auto truths = robots.last().first().value<std::vector<sim::RobotTruth>>();
        QCOMPARE(truths.front().name, std::string("R1"));
        QTRY_VERIFY(figures.last().first().value<SimulatorFigures>().real_time_factor > 1.0);
        QVERIFY(figures.last().first().value<SimulatorFigures>().real_time_factor < 12.0);
    }

    void objectsAreToldWhenOneHasMoved() {
        Served served(Pace::Factor, 10.0);
        QSignalSpy told(&served.server, &SimulatorServer::objectsChanged);
        const auto ball = [&]() -> std::optional<Pose> {
            const auto objects =
                told.isEmpty() ? protocol::WorldObjects{} : told.last()[0].value<protocol::WorldObjects>();
            return objects.objects.size() == 1 ? std::optional(objects.objects[0].object_in_map) : std::nullopt;
        };
        Client client(served.port);
        client.say(
            "INIT {ClassName USARBot.WorldController} {Name WC}\r\n"
            "CONTROL {Type Create} {ClassName USARModels.Ball} {Name B} {Location 2,1,-0.11} {Permanent True}\r\n");
        QTRY_VERIFY(ball());
        QSignalSpy figures(&served.server, &SimulatorServer::figuresChanged);
        QTRY_VERIFY(figures.count() >= 4);
        told.clear();
        figures.clear();
        QTRY_VERIFY(figures.count() >= 4);
        QCOMPARE(told.count(), 0); // It lies still.
        client.say("CONTROL {Type AbsMove} {Name B} {Location 4,-3,-0.11}\r\n");
        QTRY_VERIFY(ball() && (ball()->position_m.head<2>() - Vec2(4.0, 3.0)).norm() < 0.05);
        client.say("CONTROL {Type Kill} {Name B}\r\n");
        QTRY_VERIFY(!told.last()[0].value<protocol::WorldObjects>().objects.size());
    }

    void whatIsIgnoredIsLogged() {
        Served served(Pace::Factor, 50.0);
        QSignalSpy log(&served.server, &SimulatorServer::logged);
        Client client(served.port);
        client.say("INIT {ClassName USARBot.Fountain}\r\n");
        QTRY_VERIFY(std::any_of(log.begin(), log.end(), [](const QList<QVariant>& one) {
            return one.first().toString().contains("unknown robot class");
        }));
    }
};

USAR_TEST(tst_SimulatorServer)

} // namespace tst_simulator_server

#include "tst_simulator_server.moc"
