#include <QTemporaryDir>
#include <QTest>

#include "core/agent/behavior_start.h"
#include "core/agent/watched_behavior.h"
#include "core/link/recording_reader.h"
#include "core/mission/session/robot_session.h"
#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/rough_relay.h"
#include "tests/doubles/scripted_behavior.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_flight_loop {

using namespace usar;
using namespace usar::mission;
using agent::BehaviorThread;
using usar::server::HeadlessSimulator;
using usar::test::RoughRelay;
using usar::test::Script;

namespace {

constexpr double climb_s = 3.0;

/// Climbs at 1 m/s for three seconds, hovers, and ends after ten.
std::shared_ptr<Script> climbAndHover() {
    auto script = std::make_shared<Script>();
    auto first = std::make_shared<std::optional<Seconds>>();
    script->on_tick = [first](const agent::Tick& tick, agent::CommandPort& port) {
        if (!*first)
            *first = tick.now;
        const double flown_s = (tick.now - **first).count();
        protocol::AerialDrive drive{0.0, 0.0, 0.0, 0.0};
        drive.climb_m_s = flown_s < climb_s - 0.01 ? 1.0 : 0.0;
        port.send(drive, "climbing and hovering");
        if (flown_s > 10.0)
            port.publish(agent::BehaviorFinished{true, "Hovered."});
        if (const auto* truth = tick.robot.sensors.groundTruth())
            port.publish(agent::PoseEstimate{tick.now, truth->value.base_in_map});
    };
    return script;
}

/// What one flight showed.
struct Flight {
    bool finished = false;
    bool success = false;
    std::vector<std::string> lines;
    std::vector<Vec3> path_m;
    std::optional<int> collisions;
    std::string heard;             ///< every byte from the server
    std::vector<std::string> said; ///< what was sent and noted to the behavior's end, with its cause and line
};

std::shared_ptr<agent::RunningBehavior> behaviorOf(const std::shared_ptr<Script>& script, BehaviorThread thread) {
    auto host = std::make_unique<agent::BehaviorHost>(std::make_unique<test::ScriptedBehavior>(script), "test");
    if (thread == BehaviorThread::Callers)
        return host;
    return std::make_shared<agent::WatchedBehavior>(std::move(host));
}

/// Adds what the recording has of the flight, without its times, which are those of a clock on the wall.
void readInto(Flight& flight, const QString& path) {
    const auto reader = link::RecordingReader::open(path);
    bool over = false;
    while (const auto record = reader ? (*reader)->next() : std::nullopt) {
        over |= record->bytes.find("Hovered.") != std::string_view::npos; // Its last word.
        if (record->kind == link::RecordKind::In)
            flight.heard += record->bytes;
        else if (!over && (record->kind == link::RecordKind::Out || record->kind == link::RecordKind::Note))
            flight.said.push_back(std::to_string(record->line.value) + ' ' + std::to_string(record->trigger.value) +
                                  ' ' + std::string(record->name) + ' ' + std::string(record->bytes));
    }
}

Flight fly(HeadlessSimulator& simulator, quint16 port, bool lockstep, BehaviorThread thread = BehaviorThread::Callers) {
    constexpr int timeout_ms = 20000;
    Flight flight;
    RobotSession session;
    const QTemporaryDir folder;
    const QString recording = folder.filePath("flight.usarrec");
    const auto script = climbAndHover();
    if (!session.startRecording(recording, {}))
        return flight;
    QObject::connect(&session, &RobotSession::startPosesKnown, &session, [&](const protocol::StartPoses& poses) {
        session.spawn({"USARBot.AirRobot", "R1", poses.poses.front().pose_in_map});
    });
    QObject::connect(&session, &RobotSession::spawned, &session,
                     [&] { session.startBehavior(behaviorOf(script, thread), {}); });
    QObject::connect(&session, &RobotSession::behaviorFinished, &session, [&](bool success) {
        flight.success = success;
        if (const auto figures = simulator.firstRobot())
            flight.collisions = figures->collisions;
        flight.path_m = session.record().path_m;
    });
    if (const auto in_process = simulator.inProcess())
        session.useInProcess(in_process);
    session.open("127.0.0.1", port, lockstep);
    flight.finished = test::waitForSignal(&session, &RobotSession::behaviorFinished, timeout_ms);
    session.close();
    session.stopRecording();
    readInto(flight, recording);
    flight.lines = script->lines;
    return flight;
}

Flight flyAtFullSpeed(std::uint64_t seed) {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = seed});
    return simulator ? fly(**simulator, (*simulator)->port(), true) : Flight{};
}

} // namespace

/// Controller and simulator over loopback TCP, unless they share a thread.
class tst_FlightLoop : public QObject {
    Q_OBJECT
private slots:
    void climbsAndHoversByDriveCommands();
    void theSameSeedGivesTheSameLines();
    void aRoughWireChangesNothing();
    void howeverTheyAreConnectedEachByteIsTheSame_data();
    void howeverTheyAreConnectedEachByteIsTheSame();
    void fliesAtThePaceThatItIsGiven();
    void fliesWithoutLockstepInRealTime();
    void aCutWireEndsTheFlightAndKeepsThePath();
    void aCutInMemoryEndsTheFlightAndKeepsThePath();
};

void tst_FlightLoop::climbsAndHoversByDriveCommands() {
    const Flight flight = flyAtFullSpeed(1);
    QVERIFY(flight.finished && flight.success);
    QVERIFY(flight.path_m.size() > 5);
    const double climbed_m = flight.path_m.back().z() - flight.path_m.front().z();
    QVERIFY2(std::abs(climbed_m - climb_s) < 0.5, qPrintable(QString::number(climbed_m)));
    QVERIFY((flight.path_m.back() - flight.path_m.front()).head<2>().norm() < 0.5);
    QCOMPARE(flight.collisions, std::optional(0));
}

void tst_FlightLoop::theSameSeedGivesTheSameLines() {
    const Flight first = flyAtFullSpeed(5);
    const Flight second = flyAtFullSpeed(5);
    const Flight other = flyAtFullSpeed(6);
    QVERIFY(first.lines.size() > 200);
    QVERIFY(first.lines == second.lines);
    QVERIFY(first.lines != other.lines);
}

void tst_FlightLoop::aRoughWireChangesNothing() {
    const Flight straight = flyAtFullSpeed(5);
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 5});
    QVERIFY(simulator);
    RoughRelay relay((*simulator)->port());
    const Flight rough = fly(**simulator, relay.port(), true);
    QVERIFY(rough.finished);
    QVERIFY(straight.lines == rough.lines);
}

void tst_FlightLoop::howeverTheyAreConnectedEachByteIsTheSame_data() {
    QTest::addColumn<QString>("wire");
    QTest::addColumn<int>("thread");
    QTest::addColumn<int>("longest_piece");
    const auto row = [](const char* name, const char* wire, BehaviorThread thread, int longest_piece = 0) {
        QTest::newRow(name) << wire << static_cast<int>(thread) << longest_piece;
    };
    row("in memory, all in one thread", "memory", BehaviorThread::Callers);
    row("in memory, the behavior in its own thread", "memory", BehaviorThread::Own);
    row("by TCP, the behavior in its own thread", "tcp", BehaviorThread::Own);
    row("in pieces of up to 100 bytes, the behavior in its own thread", "rough", BehaviorThread::Own, 100);
    row("in pieces of up to 900 bytes, the behavior in its own thread", "rough", BehaviorThread::Own, 900);
    row("in pieces of up to 3000 bytes, the behavior in its own thread", "rough", BehaviorThread::Own, 3000);
}

/// A behavior in its own thread gets the lines that come together at once, and its answers are taken line by line.
void tst_FlightLoop::howeverTheyAreConnectedEachByteIsTheSame() {
    QFETCH(QString, wire);
    QFETCH(int, thread);
    QFETCH(int, longest_piece);
    const Flight by_tcp = flyAtFullSpeed(5);
    const auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 5, .own_thread = wire != "memory"});
    QVERIFY(simulator);
    QCOMPARE(bool((*simulator)->inProcess()), wire == "memory");
    RoughRelay relay((*simulator)->port());
    relay.longest_piece = longest_piece;
    const Flight flight = fly(**simulator, wire == "rough" ? relay.port() : (*simulator)->port(), true,
                              static_cast<BehaviorThread>(thread));
    QVERIFY(flight.finished && flight.success);
    QVERIFY(by_tcp.lines.size() > 200);
    QVERIFY(by_tcp.said.size() > 100);
    QVERIFY(by_tcp.lines == flight.lines);
    QVERIFY(by_tcp.path_m == flight.path_m);
    const std::string_view to_its_end = std::string_view(by_tcp.heard).substr(0, by_tcp.heard.find_last_not_of("\r\n"));
    QVERIFY(flight.heard.starts_with(to_its_end)); // In memory the next tick comes before the test hears of the end.
    QCOMPARE(flight.said, by_tcp.said);
}

void tst_FlightLoop::fliesAtThePaceThatItIsGiven() {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.speed_x = 10.0});
    QVERIFY(simulator);
    QElapsedTimer wall;
    wall.start();
    QVERIFY(fly(**simulator, (*simulator)->port(), true).success);
    QVERIFY2(wall.elapsed() > 950, qPrintable(QString::number(wall.elapsed()))); // ten seconds at ten times real time
}

void tst_FlightLoop::fliesWithoutLockstepInRealTime() {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.speed_x = 5.0});
    QVERIFY(simulator);
    const Flight flight = fly(**simulator, (*simulator)->port(), false);
    QVERIFY(flight.success);
    const double climbed_m = flight.path_m.back().z() - flight.path_m.front().z();
    QVERIFY2(std::abs(climbed_m - climb_s) < 1.0, qPrintable(QString::number(climbed_m)));
}

void tst_FlightLoop::aCutWireEndsTheFlightAndKeepsThePath() {
    auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1});
    QVERIFY(simulator);
    RoughRelay relay((*simulator)->port());
    relay.cut_after_bytes = 50000;
    const Flight flight = fly(**simulator, relay.port(), true);
    QVERIFY(flight.finished && !flight.success);
    QVERIFY(!flight.path_m.empty());
}

void tst_FlightLoop::aCutInMemoryEndsTheFlightAndKeepsThePath() {
    const auto cut = sim::readFault("link_cut from=5");
    QVERIFY(cut);
    const auto simulator =
        HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1, .faults = {*cut}, .own_thread = false});
    QVERIFY(simulator);
    const Flight flight = fly(**simulator, (*simulator)->port(), true);
    QVERIFY(flight.finished && !flight.success);
    QVERIFY(!flight.path_m.empty());
}

USAR_TEST(tst_FlightLoop)

} // namespace tst_flight_loop

#include "tst_flight_loop.moc"
