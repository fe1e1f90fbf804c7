// What the window knows of a replayed robot, at the moment to which the replay was moved.
#include <chrono>
#include <cmath>
#include <string>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/link/recording_format.h"
#include "core/mission/fleet/robot.h"
#include "tests/suite/suite.h"

namespace tst_robot_replay {

using namespace usar;
using namespace usar::mission;
using link::RecordKind;
using namespace std::chrono_literals;

namespace {

std::string statusText(const std::string& state, double flown_m) {
    agent::BehaviorStatus status;
    status.battery_used_pct = 20.0;
    status.state = state;
    status.distance_flown_m = flown_m;
    std::string text;
    agent::appendText(text, status);
    return text;
}

/// Two flights of one robot. The first one begins at 1 s, says "out" at 2 s, and is landed at 3 s. The second one
/// begins at 4 s and says "again" at 5 s. The recording ends at 6 s, in flight.
std::string twoFlights() {
    std::string file;
    link::recording::appendHead(file);
    const auto add = [&](link::RecordTime time, const std::string& name, const std::string& bytes) {
        link::recording::append(file,
                                {.kind = RecordKind::Note, .time = time, .line = {2}, .name = name, .bytes = bytes});
    };
    link::recording::append(file, {.kind = RecordKind::Start, .bytes = "robot: R1\n"});
    link::recording::append(file, {.kind = RecordKind::Opened, .bytes = "h:1"});
    link::recording::append(file, {.kind = RecordKind::In, .bytes = "STA {Battery 1000}\r\nSTA {Battery 500}\r\n"});
    add(1s, "behavior", "airrobot/cpp\tR1\t0 0 3 4");
    add(2s, "published", statusText("out", 7.0));
    add(3s, "finished", "0 Landed on request.");
    add(4s, "behavior", "airrobot/posh\tR1\t0 0 3 4");
    add(5s, "published", statusText("again", 2.0));
    add(6s, "fault", "wind");
    return file;
}

struct Replayed {
    Replayed() {
        QFile file(folder.filePath("R1.usarrec"));
        const std::string bytes = twoFlights();
        if (file.open(QIODevice::WriteOnly))
            file.write(bytes.data(), static_cast<qint64>(bytes.size()));
        file.close();
        robot.openRecording(file.fileName());
    }
    /// Moves the replay, and waits until the view is of that moment.
    bool moveTo(Seconds position) {
        robot.orderReplay({.seek = position});
        return QTest::qWaitFor([&] {
            const auto& replay = robot.view().figures.replay;
            return replay && !replay->seeking && std::abs((replay->position - position).count()) < 0.01;
        });
    }
    const RobotView& view() const { return robot.view(); }

    QTemporaryDir folder;
    Robot robot;
};

} // namespace

class tst_RobotReplay : public QObject {
    Q_OBJECT
private slots:
    void theEndOfAnEarlierFlightIsNotThatOfThisOne() {
        Replayed replayed;
        QVERIFY(replayed.moveTo(5.5s));
        QVERIFY2(!replayed.view().finished, "the second flight goes on");
        QVERIFY(replayed.view().figures.behavior_running);
        QCOMPARE(replayed.view().behavior_id, std::string("airrobot/posh"));
        QVERIFY(replayed.view().status);
        QCOMPARE(replayed.view().status->state, std::string("again"));
        QCOMPARE(replayed.view().status->distance_flown_m, 2.0);
    }

    void beforeItsFirstStatusAFlightHasNoFiguresOfTheOneBefore() {
        Replayed replayed;
        QVERIFY(replayed.moveTo(4.5s));
        QVERIFY(!replayed.view().finished);
        QVERIFY2(!replayed.view().status, "these would be the figures of the first flight");
    }

    void afterTheEndItsReasonAndItsLastFiguresAreThere() {
        Replayed replayed;
        QVERIFY(replayed.moveTo(3.5s));
        QVERIFY(replayed.view().finished);
        QCOMPARE(replayed.view().finished->reason, std::string("Landed on request."));
        QVERIFY(replayed.view().status);
        QCOMPARE(replayed.view().status->distance_flown_m, 7.0);
    }

    void theBatteryIsTheRobotsOwnUntilABehaviorTells() {
        Replayed replayed;
        QVERIFY(replayed.moveTo(1.5s));
        QCOMPARE(replayed.robot.batteryLeft_pct(), std::optional(50.0));
        QVERIFY(replayed.moveTo(2.5s));
        QCOMPARE(replayed.robot.batteryLeft_pct(), std::optional(80.0));
    }

    void backwardTheFiguresAreThoseOfThatMoment() {
        Replayed replayed;
        QVERIFY(replayed.moveTo(5.5s));
        QVERIFY(replayed.moveTo(2.5s));
        QVERIFY(!replayed.view().finished);
        QVERIFY(replayed.view().status);
        QCOMPARE(replayed.view().status->state, std::string("out"));
        QCOMPARE(replayed.view().behavior_id, std::string("airrobot/cpp"));
        QVERIFY(replayed.moveTo(0.5s));
        QVERIFY(!replayed.view().status && !replayed.view().finished && !replayed.view().figures.behavior_running);
    }
};

USAR_TEST(tst_RobotReplay)

} // namespace tst_robot_replay

#include "tst_robot_replay.moc"
