// What the window knows of a replayed robot, at the moment to which the replay was moved.
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/agent/published_text.h"
#include "core/mission/files/flown_mission.h"
#include "core/mission/fleet/robot.h"
#include "core/mission/session/notices.h"
#include "core/protocol/command_writer.h"
#include "tests/doubles/two_flights.h"
#include "tests/suite/suite.h"

namespace tst_robot_replay {

using namespace usar;
using namespace usar::mission;
using namespace std::chrono_literals;

namespace {

/// A flight with a corrected map that lands after eight scans and again after two more, and waits each time.
class TwoLandings {
public:
    TwoLandings() {
        Mission mission;
        mission.name = "m";
        mission.area_in_map = {{0.0, 0.0}, {3.0, 4.0}};
        mission.adjust = true;
        doubles::appendOldHead(file);
        add({.kind = link::RecordKind::Start, .bytes = "robot: R1\n"});
        add({.kind = link::RecordKind::Opened, .bytes = "h:1"});
        note("mission", noteOf({mission}));
        note("behavior", "airrobot/cpp\tR1\t0 0 3 4");
        for (const int scans : {8, 2}) {
            for (int i = 0; i < scans; ++i)
                scan();
            land();
        }
    }
    std::string file;

private:
    void add(const link::Record& record) {
        link::Record timed = record;
        timed.time = time_;
        timed.line = {line_};
        doubles::appendPlain(file, timed);
        time_ += 100ms;
    }
    void note(const std::string& name, const std::string& bytes) {
        add({.kind = link::RecordKind::Note, .name = name, .bytes = bytes});
    }
    void line(const std::string& text) {
        add({.kind = link::RecordKind::In, .bytes = text + "\r\n"});
        ++line_;
    }
    void publish(const agent::Published& value) {
        std::string text;
        agent::appendText(text, value);
        note("published", text);
    }
    void estimate(double x_m) { publish(agent::PoseEstimate{Seconds(time_), {.position_m = {x_m, 2.0, 6.0}}}); }
    void scan() {
        estimate(x_m_ += 0.2);
        line("SEN {Type RangeScanner} {Name Scanner1} {Resolution 0.1} {FOV 0.2} {Range 6.0,6.0,6.0}");
        publish(agent::ScanPlacement{{line_}, {.position_m = {x_m_, 2.0, 6.0}, .pitch_rad = pi / 2}});
    }
    void land() {
        const std::string set = protocol::write(protocol::SetInsPose{.base_in_map = {.position_m = {0.0, 2.0, 6.0}}});
        add({.kind = link::RecordKind::Out, .name = "behavior: landed", .bytes = set + "\r\n"});
        estimate(0.0);
        for (int i = 0; i < 40; ++i)
            line("STA {Battery 500}");
    }

    link::RecordTime time_{0};
    std::uint64_t line_ = 0;
    double x_m_ = 0.0;
};

struct Replayed {
    explicit Replayed(const std::string& bytes = doubles::twoFlights()) {
        QFile file(folder.filePath("R1.usarrec"));
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

    void theMapIsCorrectedAtEachLandingThatIsWatched() {
        Replayed replayed(TwoLandings().file);
        int corrections = 0;
        QObject::connect(&replayed.robot, &Robot::noticed, [&](const Notice& notice) {
            corrections += notice.topic == textOf(Topic::Adjustment) ? 1 : 0;
        });
        replayed.robot.orderReplay({.play = true, .speed = std::numeric_limits<double>::infinity()});
        QTRY_VERIFY(replayed.view().figures.replay && replayed.view().figures.replay->position > 8s &&
                    !replayed.view().figures.replay->playing);
        QTRY_COMPARE(corrections, 2);
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
