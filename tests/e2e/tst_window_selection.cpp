// The selected robot and what the window shows of it: after a robot goes, while time stands still, and under typed
// letters.
#include <algorithm>

#include <QComboBox>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_selection {

using namespace usar;

class tst_WindowSelection : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void backToNowLeadsToTheRobotThatWasReplayed_data();
    void backToNowLeadsToTheRobotThatWasReplayed();
    void afterARemovalTheRightRobotIsSelected_data();
    void afterARemovalTheRightRobotIsSelected();
    void aRobotThatIsSelectedWhileTimeStandsShowsItsReadings();
    void lettersTypedIntoAListAreNoCommands();

private:
    /// Spawns that many robots, each at a start pose of its own.
    static bool spawns(WindowPage& page, std::size_t robots);
};

bool tst_WindowSelection::spawns(WindowPage& page, std::size_t robots) {
    if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms))
        return false;
    const auto poses = page.map().content().start_poses;
    for (std::size_t i = 0; i < robots; ++i)
        if (i >= poses.size() || !page.spawnAt(poses[i].name))
            return false;
    return true;
}

/// Defect D13 of the review.
void tst_WindowSelection::backToNowLeadsToTheRobotThatWasReplayed_data() {
    QTest::addColumn<int>("robot");
    QTest::newRow("the first of two") << 1;
    QTest::newRow("the second of two") << 2;
}

void tst_WindowSelection::backToNowLeadsToTheRobotThatWasReplayed() {
    QFETCH(int, robot);
    WindowPage page;
    QVERIFY(spawns(page, 2));
    page.pressKey(robot == 1 ? Qt::Key_1 : Qt::Key_2);
    QCOMPARE(page.window().selectedRobot(), RobotId{robot});
    QVERIFY(page.clockGoesOn(Seconds(2.0), robot));
    page.window().commands().action("plan.look_back")->trigger();
    const auto replays = [&] {
        const auto* view = page.robot(page.window().selectedRobot());
        return view && view->figures.replay.has_value();
    };
    QTRY_VERIFY_WITH_TIMEOUT(replays(), soon_ms);
    page.pressKey(Qt::Key_End, Qt::AltModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!replays(), soon_ms);
    QCOMPARE(page.window().selectedRobot(), RobotId{robot});
    QCOMPARE(page.window().control().robots().size(), std::size_t(2));
}

/// Defect D13 of the review: the list selects the robot below the removed row, or above the last one, and that one was
/// kept. What ought to be selected is the one that was, or else the first.
void tst_WindowSelection::afterARemovalTheRightRobotIsSelected_data() {
    QTest::addColumn<std::size_t>("robots");
    QTest::addColumn<int>("selected");
    QTest::addColumn<int>("removed");
    QTest::addColumn<int>("then");
    QTest::newRow("the only one") << std::size_t(1) << 1 << 1 << 0;
    QTest::newRow("the selected first one") << std::size_t(3) << 1 << 1 << 2;
    QTest::newRow("the selected middle one, below which the list goes on") << std::size_t(3) << 2 << 2 << 1;
    QTest::newRow("the selected last one, above which the list goes on") << std::size_t(3) << 3 << 3 << 1;
    QTest::newRow("one above the selected one") << std::size_t(3) << 3 << 1 << 3;
    QTest::newRow("one just above the selected one") << std::size_t(3) << 3 << 2 << 3;
    QTest::newRow("one below the selected one") << std::size_t(3) << 1 << 2 << 1;
}

void tst_WindowSelection::afterARemovalTheRightRobotIsSelected() {
    QFETCH(std::size_t, robots);
    QFETCH(int, selected);
    QFETCH(int, removed);
    QFETCH(int, then);
    WindowPage page;
    QVERIFY(spawns(page, robots));
    page.pressKey(Qt::Key(Qt::Key_0 + selected));
    QCOMPARE(page.window().selectedRobot(), RobotId{selected});
    page.window().control().remove({removed});
    QCOMPARE(page.window().selectedRobot(), RobotId{then});
    QCOMPARE(page.window().control().robots().size(), robots - 1);
    const widgets::WindowViews& views = page.window().views();
    QCOMPARE(views.robots->selectedRobot().value_or(RobotId{}), RobotId{then});
    QCOMPARE(page.map().content().selected_robot, then == 0 ? QString() : QString("R%1").arg(then));
}

/// Defect D17 of the review.
void tst_WindowSelection::aRobotThatIsSelectedWhileTimeStandsShowsItsReadings() {
    WindowPage page;
    QVERIFY(spawns(page, 2));
    QVERIFY(page.clockGoesOn(Seconds(1.5), 2));
    const widgets::WindowViews& views = page.window().views();
    page.window().commands().action("time.pause")->trigger();
    QTRY_VERIFY(views.time->paused());
    page.pressKey(Qt::Key_1);
    page.pressKey(Qt::Key_2);
    page.pressKey(Qt::Key_1);
    QCOMPARE(page.window().selectedRobot(), RobotId{1});
    const auto told = [](const QWidget* view) { return view->accessibleDescription(); };
    QTRY_VERIFY2(views.sensors->model().rowCount() > 3, "the sensors are empty");
    QTRY_VERIFY2(told(views.sonars).contains(QStringLiteral("sonars, ")), qPrintable(told(views.sonars)));
    QVERIFY2(told(views.laser).contains(QStringLiteral("m to ground")), qPrintable(told(views.laser)));
}

/// Defect D5 of the review, the row of the combo boxes.
void tst_WindowSelection::lettersTypedIntoAListAreNoCommands() {
    WindowPage page;
    QVERIFY(spawns(page, 2));
    const widgets::WindowViews& views = page.window().views();
    page.clickStartPose(page.map().content().start_poses.back().name);
    QTRY_VERIFY(views.spawn_card->isVisible());
    auto* const classes = views.spawn_card->findChild<QComboBox*>();
    classes->setFocus();
    QTRY_VERIFY(classes->hasFocus());
    QTest::keyClicks(classes, QStringLiteral("P2AT"));
    QCOMPARE(classes->currentText(), QStringLiteral("P2AT"));
    QVERIFY(!page.window().commands().action("mission.area")->isChecked());
    for (QComboBox* const box : page.window().findChildren<QComboBox*>()) {
        if (!box->isVisible() || !box->isEnabled() || box->isEditable())
            continue;
        box->setFocus();
        for (const char letter : {'a', 'l', 'p', 'g', 'w', 'n', '1'})
            QTest::keyClick(box, letter);
        QVERIFY2(!page.window().commands().action("mission.area")->isChecked(), qPrintable(box->accessibleName()));
        QVERIFY2(page.window().selectedRobot() == RobotId{2}, qPrintable(box->accessibleName()));
    }
    QVERIFY(page.notified("Land").isEmpty() && page.notified("Landed").isEmpty());
    QVERIFY(!page.robot(2)->paused);
}

USAR_TEST(tst_WindowSelection)

} // namespace tst_window_selection

#include "tst_window_selection.moc"
