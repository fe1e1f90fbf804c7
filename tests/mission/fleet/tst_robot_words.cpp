// What is said about a robot in a few words.
#include <QTest>

#include "core/mission/fleet/robot_words.h"
#include "core/mission/fleet/roster.h"
#include "core/protocol/commands/spawn.h"
#include "tests/suite/suite.h"

namespace tst_robot_words {

using namespace usar;
using namespace usar::mission;

namespace {

/// A robot that is connected and spawned and does nothing.
RobotView idleRobot() {
    RobotView view;
    view.id = {1};
    view.spawn.robot_name = "R1";
    view.spawn.class_name = "USARBot.P2DX";
    view.link.state = link::LinkState::Connected;
    view.figures.spawned = true;
    return view;
}

template <class Change>
RobotView changed(Change change) {
    RobotView view = idleRobot();
    change(view);
    return view;
}

} // namespace

class tst_RobotWords : public QObject {
    Q_OBJECT
private slots:
    void theStateIsOneOrTwoWords_data();
    void theStateIsOneOrTwoWords();
    void theTitleTellsWhatIsKnown_data();
    void theTitleTellsWhatIsKnown();
    void savingNamesTheRobotAndTheFolder();
    void severalRobotsAreNamedOrCounted();
    void aRobotWithoutALinkIsStale();
    void aRobotThatIsNotThereIsStale();
    void theDeviceIsNamed_data();
    void theDeviceIsNamed();
    void theNoteSaysWhatToDoOrWhatIsWrong_data();
    void theNoteSaysWhatToDoOrWhatIsWrong();
    void whatPreventsDrivingIsNamed_data();
    void whatPreventsDrivingIsNamed();
    void whatPreventsPicturesIsNamed_data();
    void whatPreventsPicturesIsNamed();
    void onlyALiveRecordingCanBeLookedBackOn();
    void missingObjectsAreExplained();
    void aStationGetsAFreePlaceAndANewName();
};

void tst_RobotWords::savingNamesTheRobotAndTheFolder() {
    QCOMPARE(savedText("R4", {"/scans/a.bil", "/scans/a.hdr"}), QString("Saved the scan of R4: 2 files in /scans."));
}

void tst_RobotWords::severalRobotsAreNamedOrCounted() {
    QCOMPARE(robotsText({}), QString());
    QCOMPARE(robotsText({"R1"}), QString("R1"));
    QCOMPARE(robotsText({"R1", "R2"}), QString("R1 and R2"));
    QCOMPARE(robotsText({"R1", "R2", "R5"}), QString("R1, R2 and R5"));
    QCOMPARE(robotsText({"R1", "R2", "R5", "R7"}), QString("4 robots"));
}

void tst_RobotWords::theStateIsOneOrTwoWords_data() {
    QTest::addColumn<RobotView>("view");
    QTest::addColumn<QString>("text");
    QTest::newRow("idle") << idleRobot() << "idle";
    QTest::newRow("without a link") << changed([](RobotView& view) { view.link = {}; }) << "no link";
    QTest::newRow("asked for") << changed([](RobotView& view) {
        view.figures.spawned = false;
        view.figures.spawn = SpawnState::Asked;
    }) << "spawning…";
    QTest::newRow("never asked for") << changed([](RobotView& view) { view.figures.spawned = false; }) << "not spawned";
    QTest::newRow("a station") << changed([](RobotView& view) { view.spawn.class_name = protocol::station_class; })
                               << "listens";
    QTest::newRow("a behavior's own word") << changed([](RobotView& view) {
        view.figures.behavior_running = true;
        view.status.emplace().state = "climbing";
    }) << "climbing";
    QTest::newRow("done") << changed([](RobotView& view) { view.finished = {true, "all scanned"}; }) << "done";
    QTest::newRow("failed") << changed([](RobotView& view) { view.finished = {false, "no battery"}; }) << "ended early";
    QTest::newRow("a replay that has not begun") << changed([](RobotView& view) {
        view.recording = "R1.usarrec";
        view.link = {};
    }) << "replay · not begun";
    QTest::newRow("a replay under way") << changed([](RobotView& view) {
        view.recording = "R1.usarrec";
        view.figures.lines_received = 3;
    }) << "replay · idle";
}

void tst_RobotWords::theStateIsOneOrTwoWords() {
    QFETCH(RobotView, view);
    QTEST(stateText(view), "text");
}

void tst_RobotWords::theTitleTellsWhatIsKnown_data() {
    using Coverage = std::optional<double>;
    QTest::addColumn<RobotView>("view");
    QTest::addColumn<Coverage>("coverage_pct");
    QTest::addColumn<QString>("title");
    const auto told = [](auto change) {
        return changed([&](RobotView& view) {
            view.status.emplace().state = "scanning";
            change(*view.status);
        });
    };
    QTest::newRow("no status yet") << idleRobot() << Coverage(50.0) << "";
    QTest::newRow("hardly anything") << told([](agent::BehaviorStatus&) {}) << Coverage()
                                     << "scanning · 0 m traveled · 0:00 elapsed";
    const RobotView all = told([](agent::BehaviorStatus& status) {
        status.progress_pct = 42.4;
        status.distance_flown_m = 119.6;
        status.elapsed = Seconds{45.9};
        status.time_left = Seconds{62.1};
        status.range_left_m = 310.4;
    });
    QTest::newRow("everything, in whole units")
        << all << Coverage(36.6)
        << "42 % · scanning · 37 % covered · 120 m traveled · 0:45 elapsed · 1:03 left · 310 m range left";
    QTest::newRow("the reserve is being used")
        << told([](agent::BehaviorStatus& status) { status.range_left_m = -0.2; }) << Coverage()
        << "scanning · 0 m traveled · 0:00 elapsed · 0 m range left";
    QTest::newRow("no numbers") << told([](agent::BehaviorStatus& status) {
        status.progress_pct = status.range_left_m = qQNaN();
        status.time_left = Seconds{qInf()};
    }) << Coverage() << "scanning · 0 m traveled · 0:00 elapsed";
}

void tst_RobotWords::theTitleTellsWhatIsKnown() {
    QFETCH(RobotView, view);
    QFETCH(std::optional<double>, coverage_pct);
    QTEST(titleText(view, coverage_pct), "title");
}

void tst_RobotWords::aRobotWithoutALinkIsStale() {
    QVERIFY(!isStale(idleRobot()));
    RobotView lost = changed([](RobotView& view) { view.link = {}; });
    QVERIFY(isStale(lost));
    lost.recording = "R1.usarrec";
    QVERIFY(!isStale(lost)); // it has not begun
    lost.figures.lines_received = 1;
    QVERIFY(isStale(lost));
}

/// After a reconnect the server no longer has it, whatever the connection says.
void tst_RobotWords::aRobotThatIsNotThereIsStale() {
    RobotView gone = changed([](RobotView& view) { view.figures.spawned = false; });
    QCOMPARE(gone.link.state, link::LinkState::Connected);
    QVERIFY(isStale(gone));
    gone.recording = "R1.usarrec"; // A replay shows what was, and nobody spawns it.
    gone.figures.lines_received = 1;
    QVERIFY(!isStale(gone));
}

void tst_RobotWords::theDeviceIsNamed_data() {
    QTest::addColumn<ControlState>("state");
    QTest::addColumn<QString>("text");
    const auto held = [](HandSource source, const std::string& device) {
        ControlState state;
        state.held = source;
        state.device = device;
        return state;
    };
    QTest::newRow("none") << ControlState{} << "";
    QTest::newRow("keys") << held(HandSource::Keys, {}) << "keys";
    QTest::newRow("the pad") << held(HandSource::Pad, {}) << "pad";
    QTest::newRow("a gamepad") << held(HandSource::Gamepad, "Wheelie 2") << "Wheelie 2";
    QTest::newRow("a gamepad without a name") << held(HandSource::Gamepad, {}) << "gamepad";
}

void tst_RobotWords::theDeviceIsNamed() {
    QFETCH(ControlState, state);
    QTEST(deviceText(state), "text");
}

void tst_RobotWords::theNoteSaysWhatToDoOrWhatIsWrong_data() {
    QTest::addColumn<ControlState>("state");
    QTest::addColumn<bool>("taken");
    QTest::addColumn<QString>("begin");
    ControlState state;
    QTest::newRow("free") << state << false << "";
    state.reins = Reins::Behavior;
    QTest::newRow("a behavior drives") << state << false << "Taking control";
    state.reins = Reins::Hand;
    QTest::newRow("taken") << state << true << "Hold a key";
    state.last_stop = "the key was let go";
    QTest::newRow("stopped") << state << true << "Stopped: the key was let go.";
    state.held = HandSource::Keys;
    QTest::newRow("held") << state << true << "";
    state.learning = true;
    QTest::newRow("learning") << state << true << "Asking the server";
    state.hindrance = "It has no wheels.";
    QTest::newRow("hindered") << state << true << "It has no wheels.";
}

void tst_RobotWords::theNoteSaysWhatToDoOrWhatIsWrong() {
    QFETCH(ControlState, state);
    QFETCH(bool, taken);
    QFETCH(QString, begin);
    const QString note = driveNote(state, taken);
    QVERIFY2(note.left(begin.size()) == begin && note.isEmpty() == begin.isEmpty(), qPrintable(note));
}

void tst_RobotWords::whatPreventsDrivingIsNamed_data() {
    QTest::addColumn<RobotView>("view");
    QTest::addColumn<QString>("title");
    QTest::newRow("nothing") << idleRobot() << "";
    QTest::newRow("a replay") << changed([](RobotView& view) { view.recording = "R1.usarrec"; })
                              << "A recording cannot be driven";
    QTest::newRow("a station") << changed([](RobotView& view) { view.spawn.class_name = protocol::station_class; })
                               << "R1 does not move";
    QTest::newRow("no link") << changed([](RobotView& view) { view.link = {}; }) << "No link to R1";
    QTest::newRow("not spawned") << changed([](RobotView& view) { view.figures.spawned = false; }) << "R1 is not there";
}

void tst_RobotWords::whatPreventsDrivingIsNamed() {
    QFETCH(RobotView, view);
    QTEST(whyNotDriven(&view).title, "title");
    QCOMPARE(whyNotDriven(nullptr).title, QString("No robot yet"));
}

void tst_RobotWords::whatPreventsPicturesIsNamed_data() {
    QTest::addColumn<PictureFacts>("facts");
    QTest::addColumn<QString>("title");
    const PictureFacts good{true, true, true, {"AirRobot"}};
    const auto but = [good](auto change) {
        PictureFacts facts = good;
        change(facts);
        return facts;
    };
    QTest::newRow("nothing") << good << "";
    QTest::newRow("not live") << but([](PictureFacts& facts) { facts.live = false; }) << "R1 is not there";
    QTest::newRow("no camera") << but([](PictureFacts& facts) { facts.has_camera = false; }) << "R1 has no camera";
    QTest::newRow("no server") << but([](PictureFacts& facts) { facts.has_server = false; }) << "No image server";
}

void tst_RobotWords::whatPreventsPicturesIsNamed() {
    QFETCH(PictureFacts, facts);
    const RobotView view = idleRobot();
    QTEST(whyNoPicture(&view, facts).title, "title");
    QVERIFY(whyNoPicture(nullptr, facts).hint.contains("AirRobot"));
    const RobotView replay = changed([](RobotView& view) { view.recording = "R1.usarrec"; });
    QCOMPARE(whyNoPicture(&replay, facts).title, QString("A recording has no pictures"));
}

void tst_RobotWords::onlyALiveRecordingCanBeLookedBackOn() {
    RobotView view = idleRobot();
    QVERIFY(!whyNoLookBack(nullptr).isEmpty());
    QVERIFY(whyNoLookBack(&view).contains("not being recorded"));
    view.figures.recording.emplace();
    QCOMPARE(whyNoLookBack(&view), QString());
    view.recording = "R1.usarrec";
    QVERIFY(whyNoLookBack(&view).contains("replay"));
}

void tst_RobotWords::missingObjectsAreExplained() {
    QCOMPARE(whyNoObjects(false, {}).title, QString("No world yet"));
    QCOMPARE(whyNoObjects(true, {.state = WorldState::Refused, .trouble = "Busy.", .things = {}}).hint,
             QString("Busy."));
    QCOMPARE(whyNoObjects(true, {.state = WorldState::Asking, .trouble = {}, .things = {}}).title,
             QString("Asking the server…"));
    QVERIFY(whyNoObjects(true, {.state = WorldState::Ready, .trouble = {}, .things = {}}).title.isEmpty());
    QVERIFY(whyNoObjects(true, {.state = WorldState::Asking, .trouble = {}, .things = {{}}}).title.isEmpty());
}

void tst_RobotWords::aStationGetsAFreePlaceAndANewName() {
    protocol::StartPose first{"First", {}}, second{"Second", {}};
    second.pose_in_map.position_m.x() = 5.0;
    const SpawnRequest station = stationRequest({first, second}, {});
    QCOMPARE(station.robot_name, std::string("Base"));
    QCOMPARE(station.start_in_map.position_m.x(), 0.0);
    const SpawnRequest next = stationRequest({first, second}, {station});
    QCOMPARE(next.robot_name, std::string("Base2"));
    QCOMPARE(next.start_in_map.position_m.x(), 5.0);
    const SpawnRequest crowded = stationRequest({first, second}, {station, next});
    QCOMPARE(crowded.robot_name, std::string("Base3"));
    QCOMPARE(crowded.start_in_map.position_m.x(), 0.0);
}

USAR_TEST(tst_RobotWords)

} // namespace tst_robot_words

#include "tst_robot_words.moc"
