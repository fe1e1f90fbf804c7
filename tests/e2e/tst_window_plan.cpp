// A robot that a POSH plan decides, in the real window against the real simulator.
#include <algorithm>
#include <atomic>

#include <QFile>
#include <QListWidget>
#include <QTest>

#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/own_thread.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_plan {

using namespace usar;

namespace {

/// The dock, as a person reads it.
class PlanDock {
public:
    explicit PlanDock(WindowPage& page) : panel_(page.window().views().plan) {}

    bool isShown() const { return panel_->isVisible(); }
    bool isEmpty() const { return panel_->view().tree().empty(); }
    /// Some list of the dock has a row with this word.
    bool says(const QString& word) const {
        for (const QListWidget* list : panel_->findChildren<QListWidget*>())
            if (!list->findItems(word, Qt::MatchContains).isEmpty())
                return true;
        return false;
    }
    /// Presses Return on the first reason with these words. False where there is none.
    bool enterReason(const QString& words) {
        for (QListWidget* list : panel_->findChildren<QListWidget*>())
            if (const auto rows = list->findItems(words, Qt::MatchContains);
                list->accessibleName() == "Reasons" && !rows.isEmpty()) {
                list->setCurrentItem(rows[0]);
                QTest::keyClick(list, Qt::Key_Return);
                return true;
            }
        return false;
    }
    const widgets::PlanTime& time() const { return panel_->timeBar().time(); }

private:
    widgets::PlanPanel* panel_;
};

} // namespace

class tst_WindowPlan : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aPlanIsSeenWhileItFlies();
    void aRobotWithoutAPlanHasNoneToShow();
    void aPersonsOwnPlanDecides();
    void aPlanThatDoesNotFitIsRefused_data();
    void aPlanThatDoesNotFitIsRefused();
};

void tst_WindowPlan::aPlanIsSeenWhileItFlies() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    PlanDock dock(page);
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    page.pressKey(Qt::Key_F4, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(dock.isShown(), soon_ms);
    QVERIFY(dock.isEmpty());
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(!dock.isEmpty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(dock.says("RobotLaunch"), soon_ms);
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(dock.says("FlyToGoal"), flight_ms);
    page.screenshot("plan");
    QVERIFY(dock.time().live);
    QVERIFY(dock.enterReason("RobotLaunch: LaunchReady = false – no"));
    QVERIFY(!dock.time().live); // the moment when the launch was done
    QVERIFY(dock.time().shown > dock.time().begin && dock.time().shown < dock.time().end);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, flight_ms);
    QVERIFY2(page.robot(1)->finished->success, page.robot(1)->finished->reason.c_str());
}

void tst_WindowPlan::aRobotWithoutAPlanHasNoneToShow() {
    WindowPage page;
    const PlanDock dock(page);
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    page.pressKey(Qt::Key_A);
    page.drawArea({{-10.0, -10.0}, {10.0, 10.0}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->status, soon_ms);
    QVERIFY(dock.isEmpty());
}

void tst_WindowPlan::aPersonsOwnPlanDecides() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    const PlanDock dock(page);
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    const QString path = fileIn(folder, "lookout.lap", "((DC lookout (drives ((stay Hover)))))");
    QVERIFY(page.dropFile(path));
    QCOMPARE(page.window().views().behavior->plan().path(), path);
    page.press("Start");
    page.pressKey(Qt::Key_F4, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(dock.says("Hover"), soon_ms);
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, soon_ms);
    const QString mission = folder.filePath("saved.json");
    page.window().mission().saveMission(mission);
    QFile saved(mission);
    QVERIFY(saved.open(QIODevice::ReadOnly));
    QVERIFY(saved.readAll().contains("\"plan\": \"lookout.lap\""));
}

void tst_WindowPlan::aPlanThatDoesNotFitIsRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("not a plan") << QByteArray("((DC lookout (drives ((stay Hover))))") << "1:38: error E203";
    QTest::newRow("of another robot") << QByteArray("((DC lookout (drives ((stay Hoover)))))") << "did you mean Hover";
}

void tst_WindowPlan::aPlanThatDoesNotFitIsRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.dropFile(fileIn(folder, "own.lap", text)));
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("own.lap").contains(says), soon_ms);
    QVERIFY(page.window().views().behavior->plan().path().isEmpty());
}

USAR_TEST(tst_WindowPlan)

} // namespace tst_window_plan

#include "tst_window_plan.moc"
