// What the window knows of a replayed robot, at the moment to which the replay was moved.
#include <chrono>
#include <cmath>
#include <string>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/mission/fleet/robot.h"
#include "tests/doubles/two_flights.h"
#include "tests/suite/suite.h"

namespace tst_robot_replay {

using namespace usar;
using namespace usar::mission;
using namespace std::chrono_literals;

namespace {

struct Replayed {
    Replayed() {
        QFile file(folder.filePath("R1.usarrec"));
        const std::string bytes = doubles::twoFlights();
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
