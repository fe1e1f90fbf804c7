// A session against a fake robot server, with limits that a test can wait for.
#pragma once

#include <memory>

#include <QSignalSpy>
#include <QTest>

#include "core/mission/session/robot_session.h"
#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/scripted_behavior.h"

namespace usar::test {

/// Made for each test. Its functions tell what the session has reported.
struct SessionFixture {
    explicit SessionFixture(const mission::SessionLimits& limits = quickLimits()) {
        session.setLimits(limits);
        QObject::connect(&session, &mission::RobotSession::noticed, &session,
                         [this](const mission::Notice& notice) { notices.push_back(notice); });
        server.listen();
    }

    static mission::SessionLimits quickLimits() {
        return {.link = {.connect_timeout = Seconds{1.0}, .first_retry = Seconds{0.02}, .longest_retry = Seconds{0.1}},
                .greeting = Seconds{0.2},
                .spawn = Seconds{0.2},
                .stale = Seconds{0.2},
                .sensor_silence = Seconds{3.0}};
    }
    /// For tests in which nothing may be called late, however slow the machine.
    static mission::SessionLimits patientLimits() {
        mission::SessionLimits limits = quickLimits();
        limits.greeting = limits.spawn = limits.stale = Seconds{60.0};
        return limits;
    }

    bool connectNow(bool lockstep = false) {
        QSignalSpy poses(&session, &mission::RobotSession::startPosesKnown);
        session.open("127.0.0.1", server.port(), lockstep);
        return QTest::qWaitFor([&] { return !poses.isEmpty(); });
    }
    bool spawnNow(bool lockstep = false) {
        if (!connectNow(lockstep))
            return false;
        session.spawn({.class_name = "USARBot.AirRobot", .robot_name = "R1", .start_in_map = {{1.0, 2.0, 0.5}}});
        return QTest::qWaitFor([&] { return session.figures().spawned && linesOfTickSeen(); });
    }
    /// The whole of all ticks so far has arrived.
    bool linesOfTickSeen() const { return session.figures().now.count() > server.time_s() - 0.01; }
    bool tickNow() {
        server.tick();
        return QTest::qWaitFor([&] { return linesOfTickSeen(); });
    }

    /// All that the session sent before has been heard, for it sends this after it.
    bool answersAQuestion() {
        const qsizetype before = server.heardOf("GETGEO").size();
        session.sendCommand(protocol::RawCommand{"GETGEO {Type Robot}"}, by::Other{"test"});
        return QTest::qWaitFor([&] { return server.heardOf("GETGEO").size() > before; });
    }

    bool said(const char* words) const {
        return std::ranges::any_of(
            notices, [&](const mission::Notice& notice) { return notice.text.find(words) != std::string::npos; });
    }
    std::size_t countSaid(const char* words) const {
        return static_cast<std::size_t>(std::ranges::count_if(
            notices, [&](const mission::Notice& notice) { return notice.text.find(words) != std::string::npos; }));
    }

    /// A word on this topic, at its start or at its end.
    bool saidOn(const char* topic, bool over = false) const {
        return std::ranges::any_of(
            notices, [&](const mission::Notice& notice) { return notice.topic == topic && notice.over == over; });
    }

    FakeRobotServer server;
    std::vector<mission::Notice> notices;
    mission::RobotSession session;
};

} // namespace usar::test
