// A plan that is stopped, stepped and looked back on while it flies, in the real window against the real simulator.
#include <cmath>

#include <QClipboard>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTabBar>
#include <QTest>
#include <QTreeView>

#include "core/server/embedded/simulator_host.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/dialogs.h"
#include "widgets/style/theme.h"

namespace tst_window_debugger {

using namespace usar;
using widgets::PlanNodeKind;

namespace {

/// The dock, as a person uses it, and the simulator's own clock.
class Debugger {
public:
    explicit Debugger(WindowPage& page)
        : page_(page)
        , panel_(*page.window().views().plan)
        , clock_(&page.window().control().simulator(), &server::SimulatorHost::figuresChanged) {}

    /// A click on the part of that name.
    bool select(const QString& name, PlanNodeKind kind) {
        widgets::PlanView& view = panel_.view();
        for (const widgets::PlanNodeId node : view.tree().nodes()) {
            if (view.tree()[node].name != name || view.tree()[node].kind != kind)
                continue;
            view.select({});
            view.unfoldAll();
            view.select(node); // into view, as a search would
            view.select({});
            const QPointF title = view.layout().box(view.tree(), node).topLeft() + QPointF(40.0, 12.0);
            QTest::mouseClick(&view, Qt::LeftButton, {}, view.toScreen(title).toPoint());
            return view.selected() == node;
        }
        return false;
    }
    void press(const QString& text) {
        for (QToolButton* button : panel_.findChildren<QToolButton*>())
            if (button->isVisible() && button->isEnabled() && button->text() == text)
                return QTest::mouseClick(button, Qt::LeftButton);
        QTest::qFail(qPrintable("no button says " + text), __FILE__, __LINE__);
    }
    std::optional<agent::PlanHalted> halted() const {
        const mission::RobotView* robot = page_.robot(1);
        return robot ? robot->halted : std::nullopt;
    }
    Seconds robotTime() const { return page_.robot(1)->figures.now; }
    /// As the simulator said last.
    Seconds simulatorTime() const {
        return clock_.isEmpty() ? Seconds{0.0} : clock_.last().at(0).value<server::SimulatorFigures>().now;
    }
    QString banner() const { return panel_.haltBar().isVisible() ? panel_.haltBar().text() : QString(); }
    const widgets::PlanTime& time() const { return panel_.timeBar().time(); }
    widgets::PlanPanel& panel() { return panel_; }
    QListWidget* list(const QString& name) {
        for (QListWidget* each : panel_.findChildren<QListWidget*>())
            if (each->accessibleName() == name)
                return each;
        return nullptr;
    }
    /// By a click on its tab, where the panel is so low that lists stand behind tabs.
    bool sees(const QString& name) {
        if (auto* const tabs = panel_.findChild<QTabBar*>(); tabs->isVisible())
            for (int i = 0; i < tabs->count(); ++i)
                if (tabs->tabToolTip(i) == name)
                    QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
        return list(name)->isVisible();
    }
    /// As marked on the selected part.
    int breakpointsSelected() const {
        const widgets::PlanMark* const mark = panel_.view().marks().at(panel_.view().selected());
        return mark ? mark->breakpoints : 0;
    }

private:
    WindowPage& page_;
    widgets::PlanPanel& panel_;
    QSignalSpy clock_;
};

/// Spawned, started, and its plan on show.
bool takeOff(WindowPage& page) {
    if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
        return false;
    page.pressKey(Qt::Key_F4, Qt::ControlModifier);
    page.press("Start");
    return QTest::qWaitFor([&] { return !page.window().views().plan->view().tree().empty(); }, soon_ms);
}

} // namespace

class tst_WindowDebugger : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aBreakpointStopsTheSimulatorsTime();
    void nobodyIsCalledSilentWhileAnotherRobotsPlanStandsStill();
    void whatAPlanDidIsLookedBackOn();
    void whatActsWroteDownIsSeenAndStopsThePlan();
    void whatARunCameToIsReported();
    void aDriveThatIsOffLetsAnotherWin();
    void breakpointsOutliveTheWindow();
    void allOfTheWindowLooksBackWhileTheRobotFlies();
    void aReplayGoesWhereThePlansSliderSays();
    void whatIsRecordedFromTheMiddleOnShowsThePlan();
};

void tst_WindowDebugger::nobodyIsCalledSilentWhileAnotherRobotsPlanStandsStill() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) && page.spawnAt("HillTop"));
    QVERIFY(takeOff(page));
    QVERIFY(page.robot(1) && page.robot(2));
    const int flies = page.robot(2)->figures.behavior_running ? 2 : 1;
    QVERIFY(page.robot(flies)->figures.behavior_running);
    page.window().commands().action("plan.halt")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(flies)->halted, soon_ms);
    QTRY_VERIFY(page.window().views().time->paused());
    const auto nobodyIsCalledSilent = [&] { return page.notified("Nothing from").isEmpty(); };
    const test::Beats seconds(1000); // a robot may be silent for two
    QVERIFY2(test::holdsUntil(nobodyIsCalledSilent, [&] { return seconds.count() >= 3; }),
             qPrintable(page.notified("Nothing from")));
    page.window().commands().action("plan.continue")->trigger();
    QTRY_VERIFY(!page.window().views().time->paused());
    QVERIFY2(page.holdsWhileClockGoesOn(nobodyIsCalledSilent, Seconds(0.6), flies),
             qPrintable(page.notified("Nothing from")));
}

void tst_WindowDebugger::aBreakpointStopsTheSimulatorsTime() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    QVERIFY(debugger.select("FlyToGoal", PlanNodeKind::Act));
    page.pressKey(Qt::Key_F6);
    QCOMPARE(debugger.breakpointsSelected(), 1);
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(debugger.halted(), flight_ms);
    QVERIFY2(debugger.halted()->reason.ends_with("FlyToGoal"), debugger.halted()->reason.c_str());
    QTRY_VERIFY_WITH_TIMEOUT(debugger.banner().contains("FlyToGoal"), soon_ms);
    QTRY_VERIFY(page.window().views().time->paused());
    const std::uint64_t cycle = debugger.halted()->cycle;
    const Seconds stood = debugger.robotTime();
    // The simulator tells its time, which is that of its next tick, a few times a second.
    QTRY_VERIFY(std::abs((debugger.simulatorTime() - stood).count()) < 0.3);
    const Seconds simulator_stood = debugger.simulatorTime();
    const test::Beats seconds(1000); // a robot may be silent for two
    QVERIFY(test::holdsUntil(
        [&] {
            return debugger.robotTime() == stood && debugger.simulatorTime() == simulator_stood &&
                   page.notified("Nothing from").isEmpty();
        },
        [&] { return seconds.count() >= 3; }));
    page.screenshot("debugger-halted");

    page.pressKey(Qt::Key_F11);
    QTRY_VERIFY_WITH_TIMEOUT(debugger.halted() && debugger.halted()->cycle == cycle + 1, soon_ms);
    QTRY_VERIFY(debugger.robotTime() > stood);
    QVERIFY(debugger.robotTime() - stood < Seconds{0.3});
    QVERIFY(page.window().views().time->paused());

    page.pressKey(Qt::Key_F6); // no more
    QCOMPARE(debugger.breakpointsSelected(), 0);
    debugger.press("Go on");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, flight_ms);
    QVERIFY2(page.robot(1)->finished->success, page.robot(1)->finished->reason.c_str());
    QVERIFY(debugger.banner().isEmpty());
    QVERIFY(!page.window().views().time->paused());
}

void tst_WindowDebugger::whatAPlanDidIsLookedBackOn() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    QVERIFY(debugger.select("ClimbTo", PlanNodeKind::Act));
    page.pressKey(Qt::Key_F6);
    QTRY_VERIFY_WITH_TIMEOUT(debugger.halted(), flight_ms);
    const widgets::PlanNodeId climb = debugger.panel().view().selected();
    QTRY_VERIFY(debugger.panel().view().states()[climb].running);
    QVERIFY(debugger.time().live);
    page.pressKey(Qt::Key_PageUp, Qt::AltModifier);
    QVERIFY(!debugger.time().live);
    QCOMPARE(debugger.time().cycle, debugger.halted()->cycle - 1);
    QTRY_VERIFY(!debugger.panel().view().states()[climb].running);
    page.screenshot("debugger-back");
    QSlider* const slider = debugger.panel().timeBar().slider();
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(2, slider->height() / 2));
    QTRY_COMPARE(debugger.time().cycle, std::uint64_t(1));
    QCOMPARE(debugger.time().shown, debugger.time().begin);
    page.pressKey(Qt::Key_End, Qt::AltModifier);
    QVERIFY(debugger.time().live);
    QTest::keyClick(slider, Qt::Key_Home); // the slider's, though the map has this key elsewhere
    QTRY_COMPARE(debugger.time().cycle, std::uint64_t(1));
    page.pressKey(Qt::Key_End, Qt::AltModifier);
    QVERIFY(debugger.time().live);
    QTRY_VERIFY(debugger.panel().view().states()[climb].running);
    QVERIFY(debugger.halted()); // looking back is no step
}

void tst_WindowDebugger::whatActsWroteDownIsSeenAndStopsThePlan() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    QListWidget* const board = debugger.list("Blackboard");
    QVERIFY(board);
    const auto rowOf = [board](const QString& key) {
        for (int row = 0; row < board->count(); ++row)
            if (board->item(row)->text().startsWith(key + " = "))
                return row;
        return -1;
    };
    QTRY_VERIFY_WITH_TIMEOUT(debugger.sees("Blackboard") && rowOf("phase") >= 0, soon_ms);
    QVERIFY(rowOf("lane") >= 0 && rowOf("returning") >= 0);
    const QRect row = board->visualItemRect(board->item(rowOf("phase")));
    QTest::mouseClick(board->viewport(), Qt::LeftButton, {}, row.center());
    QTRY_VERIFY(page.window().commands().action("plan.break_key")->isEnabled());
    QTest::mouseDClick(board->viewport(), Qt::LeftButton, {}, row.center());
    QListWidget* const breakpoints = debugger.list("Breakpoints");
    QTRY_VERIFY(breakpoints->count() > 0 && debugger.sees("Breakpoints"));
    QVERIFY2(breakpoints->item(0)->text().contains("phase is written"), qPrintable(breakpoints->item(0)->text()));
    QTRY_VERIFY_WITH_TIMEOUT(debugger.halted(), flight_ms);
    static const QRegularExpression wrote(" wrote phase: ('\\S+) -> ('\\S+)$");
    const auto change = wrote.match(QString::fromStdString(debugger.halted()->reason));
    QVERIFY2(change.hasMatch(), debugger.halted()->reason.c_str());
    QTRY_COMPARE(board->item(rowOf("phase"))->text(), "phase = " + change.captured(2));
    page.screenshot("debugger-board");
    page.pressKey(Qt::Key_PageUp, Qt::AltModifier);
    QTRY_COMPARE(board->item(rowOf("phase"))->text(), "phase = " + change.captured(1));
    page.window().commands().action("plan.break_key")->trigger();
    QVERIFY(!breakpoints->isVisible());
}

void tst_WindowDebugger::whatARunCameToIsReported() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QAction* const report = page.window().commands().action("plan.report");
    QVERIFY(!report->isEnabled());
    QVERIFY(takeOff(page));
    page.chooseSpeed("10×");
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().cycle > 20, soon_ms);
    report->trigger();
    auto* const dialog = page.window().findChild<widgets::ReportDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    QVERIFY2(dialog->text().startsWith("AirRobot: 1 run, "), qPrintable(dialog->text()));
    QVERIFY2(dialog->text().contains("s        1 starts   AirRobot ▸ "), qPrintable(dialog->text()));
    for (QPushButton* button : dialog->findChildren<QPushButton*>())
        if (button->text() == "&Copy")
            QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(QGuiApplication::clipboard()->text(), dialog->text());
    page.screenshot("debugger-report");
}

void tst_WindowDebugger::aDriveThatIsOffLetsAnotherWin() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    const auto& commands = page.window().commands();
    QVERIFY(debugger.select("RobotTakeOff", PlanNodeKind::Drive));
    commands.action("plan.drive_off")->trigger();
    QVERIFY(debugger.panel().view().marks().at(debugger.panel().view().selected())->switched_off);
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(!debugger.panel().view().states()[debugger.panel().view().selected()].hold_back.isEmpty(),
                             soon_ms);
    QCOMPARE(debugger.panel().view().states()[debugger.panel().view().selected()].started, std::uint64_t(0));
    commands.action("plan.release")->trigger();
    QVERIFY(debugger.panel().view().marks().empty());
    QTRY_VERIFY_WITH_TIMEOUT(debugger.panel().view().states()[debugger.panel().view().selected()].started > 0, soon_ms);
}

void tst_WindowDebugger::breakpointsOutliveTheWindow() {
    const QTemporaryDir folder;
    const QTemporaryDir settings;
    const WindowSetup setup{.mission_file = plannedMission(folder), .settings_folder = settings.path()};
    {
        WindowPage page(setup);
        Debugger debugger(page);
        QVERIFY(takeOff(page));
        QVERIFY(debugger.select("ClimbTo", PlanNodeKind::Act));
        page.pressKey(Qt::Key_F6);
        page.window().control().stopAll();
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, soon_ms);
        page.window().quit();
    }
    WindowPage page(setup);
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    QTRY_VERIFY_WITH_TIMEOUT(debugger.halted(), flight_ms);
    QVERIFY2(debugger.halted()->reason.ends_with("ClimbTo"), debugger.halted()->reason.c_str());
    page.press("Stop"); // time goes on without it
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, soon_ms);
    QTRY_VERIFY(!page.window().views().time->paused());
}

void tst_WindowDebugger::allOfTheWindowLooksBackWhileTheRobotFlies() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    const QAction& offer = *page.window().commands().action("plan.look_back");
    QVERIFY(!offer.isEnabled() && offer.toolTip().contains("No robot"));
    QVERIFY(takeOff(page));
    page.chooseSpeed("10×");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->trail_m.size() > 40, flight_ms);
    page.chooseSpeed("1×");
    QSlider* const slider = debugger.panel().timeBar().slider();
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
    QTRY_VERIFY(!debugger.time().live);
    const Seconds moment = debugger.time().shown;
    page.screenshot("debugger-past");
    const Seconds flown_until = page.robot(1)->figures.now;
    debugger.press("Replay from here");
    const auto arrived = [&] {
        const mission::RobotView* const replay = page.robot(2);
        return replay && replay->figures.replay && !replay->figures.replay->seeking &&
               std::abs((replay->figures.now - moment).count()) < 0.25 && debugger.time().shown == moment;
    };
    QTRY_VERIFY_WITH_TIMEOUT(arrived(), soon_ms);
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    QAbstractItemView* const sensors = page.window().views().sensors->findChild<QTreeView*>();
    QTRY_VERIFY_WITH_TIMEOUT(sensors && sensors->isVisible() && sensors->model()->rowCount() > 2, soon_ms);
    page.screenshot("debugger-look-back");
    QVERIFY(debugger.time().end > moment + Seconds{1.0}); // the whole run can be gone to
    QVERIFY(!page.robot(2)->trail_m.empty());
    QVERIFY(page.robot(2)->trail_m.size() < page.robot(1)->trail_m.size());
    const std::size_t flown = page.robot(2)->trail_m.size() - 1;
    QVERIFY((page.robot(2)->trail_m[flown] - page.robot(1)->trail_m[flown]).norm() < 0.5);
    QVERIFY(page.notified("not ended").isEmpty() && page.notified("damaged").isEmpty());
    QTRY_COMPARE(QApplication::focusWidget(), slider); // so that the next keys step
    const std::uint64_t cycle = debugger.time().cycle;
    const auto shows = [&](std::uint64_t wanted) {
        return debugger.time().cycle == wanted && !page.robot(2)->figures.replay->seeking &&
               std::abs((page.robot(2)->figures.now - debugger.time().shown).count()) < 0.25;
    };
    for (const auto& [key, wanted] : {std::pair(Qt::Key_Right, cycle + 1), std::pair(Qt::Key_Left, cycle)}) {
        page.pressKey(key);
        QTRY_VERIFY_WITH_TIMEOUT(shows(wanted), soon_ms);
    }
    QVERIFY(!offer.isEnabled() && offer.toolTip().contains("replay"));
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 2));
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().shown < moment && !page.robot(2)->figures.replay->seeking &&
                                 std::abs((page.robot(2)->figures.now - debugger.time().shown).count()) < 0.25,
                             soon_ms);
    QVERIFY(page.robot(1)->figures.behavior_running && !page.robot(1)->halted);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > flown_until + Seconds{1.0}, soon_ms);

    page.pressKey(Qt::Key_End, Qt::AltModifier);
    QTRY_COMPARE(page.window().selectedRobot(), RobotId{1});
    QVERIFY(!page.robot(2) && debugger.time().live && offer.isEnabled());
    page.pressKey(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier); // no more recording
    QTRY_VERIFY(!offer.isEnabled());
    QVERIFY2(offer.toolTip().contains("not being recorded"), qPrintable(offer.toolTip()));
}

void tst_WindowDebugger::aReplayGoesWhereThePlansSliderSays() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    QVERIFY(takeOff(page));
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, flight_ms);
    page.window().control().remove({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page.endedRecording().isEmpty(), soon_ms);
    page.window().control().openRecording(page.endedRecording());
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.replay, soon_ms);
    page.window().control().robot({1})->orderReplay({.seek = Seconds{1e6}});
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().cycle > 100 && !page.robot(1)->figures.replay->seeking, flight_ms);
    const Seconds end = debugger.time().shown;
    const auto agree = [&] { // within a cycle, while the plan ran
        return std::abs((debugger.time().shown - debugger.robotTime()).count()) < 0.25;
    };

    QSlider* const slider = debugger.panel().timeBar().slider();
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 3, slider->height() / 2));
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().shown < 0.5 * end && debugger.time().cycle > 1, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(agree() && !page.robot(1)->figures.replay->seeking, soon_ms);
    QVERIFY(debugger.time().end > 0.9 * end); // what comes is known
    const Seconds before = debugger.time().shown;
    page.pressKey(Qt::Key_PageUp, Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().shown < before && debugger.time().cycle > 1, soon_ms);
    QVERIFY(before - debugger.time().shown < Seconds{0.5});
    QTRY_VERIFY_WITH_TIMEOUT(agree(), soon_ms);
}

void tst_WindowDebugger::whatIsRecordedFromTheMiddleOnShowsThePlan() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    Debugger debugger(page);
    page.pressKey(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier); // no recording
    QVERIFY(takeOff(page));
    page.chooseSpeed("10×");
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().cycle > 60, flight_ms);
    QVERIFY(QDir(page.resultFolder()).entryList({"*.usarrec"}).isEmpty());
    const std::uint64_t before = debugger.time().cycle;
    page.pressKey(Qt::Key_R, Qt::ControlModifier | Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.recording, soon_ms);
    const std::uint64_t begun = debugger.time().cycle;
    QTRY_VERIFY_WITH_TIMEOUT(debugger.time().cycle > begun + 20, soon_ms);
    const auto drives = [&] { // how often each began
        std::vector<std::uint64_t> counts;
        const widgets::PlanView& view = debugger.panel().view();
        for (const widgets::PlanNodeId node : view.tree().nodes())
            if (view.tree()[node].kind == PlanNodeKind::Drive)
                counts.push_back(view.states()[node].started);
        return counts;
    };
    page.window().control().stopAll();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, soon_ms);
    const auto settled = [&] { // the robot's last words are on their way when it is known to have finished
        const std::uint64_t shown = debugger.time().cycle;
        return page.holdsWhileClockGoesOn([&] { return debugger.time().cycle == shown; }, Seconds(0.6));
    };
    QTRY_VERIFY_WITH_TIMEOUT(settled(), soon_ms);
    const auto started = drives();
    const std::uint64_t last = debugger.time().cycle;
    QVERIFY(std::ranges::any_of(started, [](std::uint64_t count) { return count > 0; }));
    QVERIFY(debugger.sees("Blackboard"));
    page.window().control().remove({1});
    QTRY_VERIFY_WITH_TIMEOUT(!page.endedRecording().isEmpty(), soon_ms);
    page.window().control().openRecording(page.endedRecording());
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.replay, soon_ms);
    page.window().control().robot({1})->orderReplay({.seek = Seconds{0.1}});
    QTRY_VERIFY_WITH_TIMEOUT(!debugger.panel().view().tree().empty(), soon_ms);
    const std::uint64_t first = debugger.time().cycle; // the recording began somewhere between the two
    QVERIFY2(first >= before && first <= begun + 5, qPrintable(QString::number(first)));
    page.window().control().robot({1})->orderReplay({.seek = Seconds{1e6}});
    QTRY_COMPARE_WITH_TIMEOUT(debugger.time().cycle, last, soon_ms);
    QTRY_COMPARE(drives(), started); // also what was before the recording
    QVERIFY(debugger.sees("Blackboard"));
}

USAR_TEST(tst_WindowDebugger)

} // namespace tst_window_debugger

#include "tst_window_debugger.moc"
