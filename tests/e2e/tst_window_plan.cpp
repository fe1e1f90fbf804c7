// A robot that a POSH plan decides, in the real window against the real simulator.
#include <QFile>
#include <QListWidget>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"

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

private:
    widgets::PlanPanel* panel_;
};

/// A small scan that the plan decides.
QString missionFile(const QTemporaryDir& folder) {
    const QString path = folder.filePath("planned.json");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return {};
    file.write(R"({ "name": "Planned", "world": "tall_test", "robot": "USARBot.AirRobot", "start": "PlayerStart",
        "behavior": "airrobot/posh", "area": { "x": -10, "y": -10, "width": 20, "height": 20 } })");
    return path;
}

} // namespace

class tst_WindowPlan : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aPlanIsSeenWhileItFlies();
    void aRobotWithoutAPlanHasNoneToShow();
};

void tst_WindowPlan::aPlanIsSeenWhileItFlies() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = missionFile(folder)});
    const PlanDock dock(page);
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

USAR_E2E_MAIN(tst_WindowPlan)
#include "tst_window_plan.moc"
