#include <QSignalSpy>
#include <QTest>

#include "core/mission/fleet/trace_watch.h"
#include "core/mission/world/world_session.h"
#include "core/server/embedded/headless_simulator.h"
#include "tests/doubles/fake_server.h"
#include "tests/doubles/test_worlds.h"
#include "tests/suite/suite.h"
#include "tests/suite/waiting.h"

namespace tst_world_session {

using namespace usar;
using namespace usar::mission;
using namespace std::chrono_literals;
using usar::server::HeadlessSimulator;
using usar::test::FakeServer;

namespace {

const std::vector<std::string> classes{"Crate", "Ball", "Conveyor"};

protocol::CreateObject creation(const char* class_name, const char* name, const Vec3& position_m) {
    protocol::CreateObject created{protocol::Token::make(class_name).value()};
    created.object_name = protocol::Name::make(name).value();
    created.start = Pose{position_m};
    return created;
}

protocol::Token nameOf(const char* name) {
    return protocol::Token::make(name).value();
}

/// A session that polls, with what it said.
struct Session {
    explicit Session(std::optional<std::chrono::milliseconds> polling = 50ms) {
        session.setLimits(
            {.link = {.first_retry = Seconds{0.02}, .longest_retry = Seconds{0.1}}, .answer = 400ms, .settle = 30ms});
        session.setClasses(classes);
        session.setPolling(polling);
        QObject::connect(&session, &WorldSession::noticed, &session,
                         [this](const Notice& notice) { notices.push_back(notice); });
    }
    const WorldThing* thing(const char* name) const {
        for (const WorldThing& one : session.view().things)
            if (one.name == name)
                return &one;
        return nullptr;
    }
    bool said(const char* words) const {
        return std::ranges::any_of(notices,
                                   [&](const Notice& one) { return one.text.find(words) != std::string::npos; });
    }
    bool ready() const { return session.view().state == WorldState::Ready; }

    std::vector<Notice> notices;
    WorldSession session;
};

/// A world controller as UDK spells it, that says STA for what it was told to.
struct FakeWorld : FakeServer {
    bool answers = true;
    bool only_udk = false;
    QByteArray things;

    FakeWorld() {
        on_connect = [this] {
            is_controller_ = false;
            say("NFO {Gametype BotDeathMatch} {Level fake} {TimeLimit 0}\r\n");
        };
        on_line = [this](const QByteArray& line) {
            if (line.startsWith("INIT"))
                is_controller_ = line.contains(only_udk ? "USARBotAPI.WorldController" : "WorldController");
            if (line.contains("GetSTA") && answers && is_controller_)
                say("STA" + (line.contains("ClassName") ? QByteArray() : things) + "\r\n");
        };
        listen();
    }

private:
    bool is_controller_ = false;
};

} // namespace

class tst_WorldSession : public QObject {
    Q_OBJECT

private slots:
    void makesMovesAndRemovesThingsInTheSimulation() {
        auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1, .speed_x = 5.0});
        QVERIFY(simulator);
        Session world;
        world.session.open("127.0.0.1", (*simulator)->port());
        QTRY_VERIFY(world.ready());
        QVERIFY(world.session.view().things.empty());
        world.session.send(creation("Crate", "C1", {2, 3, 0.6}));
        QTRY_VERIFY(world.thing("C1"));
        QCOMPARE(world.thing("C1")->class_name, std::string("Crate"));
        QVERIFY(world.thing("C1")->size_m && (*world.thing("C1")->size_m - Vec3::Ones()).norm() < 0.01);
        world.session.send(protocol::PlaceObject{nameOf("C1"), Pose{{-4, 1, 0.5}, 0, 0, 0.5}});
        QTRY_VERIFY((world.thing("C1")->body_in_map.position_m.head<2>() - Vec2(-4, 1)).norm() < 0.02);
        QVERIFY(std::abs(world.thing("C1")->body_in_map.yaw_rad - 0.5) < 0.02);
        world.session.send(protocol::AddWaypoints{nameOf("C1"), {{-4, 20, 0.5}}});
        world.session.send(protocol::FollowWaypoints{nameOf("C1"), protocol::WaypointSpeed{1.0}, {}, {}, true});
        QTRY_VERIFY(world.thing("C1")->velocity_in_map_m_s.y() > 1.0); // by wall time, at five times real time
        world.session.send(protocol::KillObject{nameOf("C1")});
        QTRY_VERIFY(world.session.view().things.empty());
        QVERIFY2(world.notices.empty(), world.notices.empty() ? "" : world.notices.front().text.c_str());
    }

    void learnsTheKindsOfThingsThatOthersMade() {
        auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1, .speed_x = 5.0});
        QVERIFY(simulator);
        Session maker;
        maker.session.open("127.0.0.1", (*simulator)->port());
        QTRY_VERIFY(maker.ready());
        maker.session.send(creation("Ball", "Round", {0, 0, 1}));
        Session reader;
        reader.session.open("127.0.0.1", (*simulator)->port());
        QTRY_VERIFY(reader.thing("Round") && reader.thing("Round")->class_name == "Ball");
    }

    void saysThatAThingOfAnUnknownClassDidNotCome() {
        auto simulator = HeadlessSimulator::serve(doubles::flatWorld(), {.seed = 1, .speed_x = 5.0});
        QVERIFY(simulator);
        Session world(std::nullopt);
        world.session.open("127.0.0.1", (*simulator)->port());
        QTRY_VERIFY(world.ready());
        world.session.send(creation("Unicorn", "U1", {0, 0, 1}));
        QTRY_VERIFY(world.said("Could not place U1"));
        QVERIFY(world.said("does not know Unicorn"));
    }

    void saysWhyTheSimulatorRefusedAThing() {
        FakeWorld server;
        Session world(std::nullopt);
        world.session.open("127.0.0.1", server.port());
        QTRY_VERIFY(world.ready());
        world.session.refuse("Crate1", "something is in the way");
        QVERIFY2(world.notices.empty(), "nobody here has asked for it");
        world.session.send(creation("Crate", "Crate1", {0, 0, 1}));
        world.session.refuse("Crate1", "something is in the way");
        QVERIFY(world.said("Could not place Crate1: something is in the way."));
        QCOMPARE(world.notices.size(), std::size_t(1));
        QCOMPARE(world.notices.front().topic, std::string("world/placing"));
    }

    void asksNothingWhileNobodyPolls() {
        FakeWorld server;
        Session world(std::nullopt);
        world.session.open("127.0.0.1", server.port());
        QTRY_VERIFY(world.ready());
        const auto asked = server.heardOf("CONTROL").size();
        QCOMPARE(asked, 1);
        const test::Beats beats(20);
        QVERIFY(test::holdsUntil([&] { return server.heardOf("CONTROL").size() == asked; },
                                 [&] { return beats.count() >= 5; }));
        world.session.setPolling(20ms);
        QTRY_VERIFY(server.heardOf("CONTROL").size() > asked + 3);
    }

    void triesTheOtherNameOfTheControllersClass() {
        FakeWorld server;
        server.only_udk = true;
        server.things = " {Name Box1} {Size 1.00,2.00,0.50} {Location 1.00,2.00,-0.50 {Memory {} {Rotation 0,0,0}";
        Session world;
        world.session.open("127.0.0.1", server.port());
        QTRY_VERIFY(world.ready());
        QTRY_VERIFY(world.thing("Box1"));
        QCOMPARE(world.thing("Box1")->body_in_map.position_m, Vec3(1, -2, 0.5));
        QVERIFY(world.notices.empty());
    }

    void saysThatAServerHasNoWorldController() {
        FakeWorld server;
        server.answers = false;
        Session world;
        world.session.open("127.0.0.1", server.port());
        QTRY_COMPARE(world.session.view().state, WorldState::Refused);
        QVERIFY(world.said("does not answer as a world controller"));
        server.answers = true; // it was only slow
        QTRY_VERIFY(world.ready());
        QVERIFY(world.notices.back().over);
    }

    void aPausedSimulatorIsNoTrouble() {
        FakeWorld server;
        Session world;
        world.session.setPaused(true);
        server.answers = false;
        world.session.open("127.0.0.1", server.port());
        QTRY_COMPARE(world.session.view().state, WorldState::Asking);
        const test::Beats patiences(400);
        QVERIFY(
            test::holdsUntil([&] { return world.session.view().state == WorldState::Asking && world.notices.empty(); },
                             [&] { return patiences.count() >= 2; }));
    }

    void sendsAfterTheGreetingWhatWasAskedForWhileItConnected() {
        FakeWorld server;
        Session world;
        world.session.open("127.0.0.1", server.port());
        world.session.send(creation("Crate", "C1", {2, 3, 0.6})); // the event loop has not run, so nothing is connected
        QTRY_COMPARE(server.heardOf("CONTROL {Type Create}").size(), 1);
        QVERIFY(server.heard().front().startsWith("INIT"));
        QVERIFY(world.notices.empty());
    }

    void saysOnceThatThereIsNobodyToChangeTheWorld() {
        FakeWorld gone;
        const quint16 port = gone.port();
        gone.stopListening();
        Session world;
        world.session.open("127.0.0.1", port);
        world.session.send(creation("Crate", "C1", {2, 3, 0.6}));
        world.session.send(creation("Crate", "C2", {5, 3, 0.6}));
        QTRY_VERIFY(world.said("no connection to the world"));
        QCOMPARE(world.notices.size(), std::size_t(1));
    }

    void comesBackAfterALostConnection() {
        FakeWorld server;
        server.things = " {Name B} {Location 0,0,0} {Rotation 0,0,0}";
        Session world;
        world.session.open("127.0.0.1", server.port());
        QTRY_VERIFY(world.thing("B"));
        server.hangUp();
        QTRY_VERIFY(!world.thing("B"));
        QTRY_VERIFY(world.thing("B"));
        QCOMPARE(server.heardOf("INIT").size(), 2);
    }

    void findsTheMarksOfATraceInWhatTheSessionSaw() {
        TraceWatch watch;
        SessionUpdate update;
        const auto truth = [&](std::uint64_t number, double time_s, double x_m) {
            protocol::GroundTruthReading reading;
            reading.time = Seconds{time_s};
            reading.base_in_map.position_m = {x_m, 0, 0};
            update.lines.push_back({});
            update.lines.back().number = {number};
            update.lines.back().message = reading;
        };
        const auto say = [&](const char* text, std::uint64_t after) {
            SentCommand command;
            command.text = text;
            command.after = {after};
            update.commands.push_back(command);
        };
        truth(1, 0.2, 0.0);
        say("Trace {On true} {Interval 0.4} {Color Blue}", 1);
        truth(2, 0.4, 1.0);
        truth(3, 0.6, 2.0);
        truth(4, 0.8, 3.0);
        say("TRACE {On false}", 4);
        truth(5, 1.6, 4.0);
        const std::vector<TraceSpot> spots = watch.take(update);
        QCOMPARE(spots.size(), std::size_t(2));
        QCOMPARE(spots[0], (TraceSpot{protocol::TraceColor::Blue, Vec3(1, 0, 0)}));
        QCOMPARE(spots[1].position_in_map_m.x(), 3.0);
        QVERIFY(!watch.on());
    }
};

USAR_TEST(tst_WorldSession)

} // namespace tst_world_session

#include "tst_world_session.moc"
