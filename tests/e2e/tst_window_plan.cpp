// A robot that a POSH plan decides, in the real window against the real simulator.
#include <algorithm>
#include <atomic>

#include <QFile>
#include <QListWidget>
#include <QTest>

#include "tests/doubles/fake_robot_server.h"
#include "tests/doubles/own_thread.h"
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

/// Counts the paintings of a plan that show news.
class PaintedNews : public QObject {
public:
    explicit PaintedNews(widgets::PlanView& view) {
        connect(&view, &widgets::PlanView::refreshed, this, [this] { has_news_ = true; });
        view.installEventFilter(this);
    }
    int count() const { return count_; }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && std::exchange(has_news_, false))
            ++count_;
        return QObject::eventFilter(watched, event);
    }

private:
    bool has_news_ = false;
    int count_ = 0;
};

QString fileIn(const QTemporaryDir& folder, const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName() : QString();
}

/// A small scan that the plan decides.
QString missionFile(const QTemporaryDir& folder) {
    return fileIn(folder, "planned.json",
                  R"({ "name": "Planned", "world": "tall_test", "robot": "USARBot.AirRobot", "start": "PlayerStart",
        "behavior": "airrobot/posh", "area": { "x": -10, "y": -10, "width": 20, "height": 20 } })");
}

} // namespace

class tst_WindowPlan : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aPlanIsSeenWhileItFlies();
    void aCycleIsSeenAtOnce();
    void aRobotWithoutAPlanHasNoneToShow();
    void aPersonsOwnPlanDecides();
    void aPlanThatDoesNotFitIsRefused_data();
    void aPlanThatDoesNotFitIsRefused();
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

/// From the bytes of a state at a server that has a thread of its own, over the cycle that it causes, to its painting
/// in the dock. The figures are in README; here is asked that no beat is waited for.
void tst_WindowPlan::aCycleIsSeenAtOnce() {
    const QTemporaryDir folder;
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    server.on_command = [&](const QByteArray& line) {
        if (line.startsWith("INIT"))
            server.keepClient();
    };
    const test::OwnThread wire(server);
    WindowPage page({.mission_file = missionFile(folder)});
    const PlanDock dock(page);
    page.connectToServer("127.0.0.1", server.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose(page.map().content().start_poses.front().name);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    page.pressKey(Qt::Key_F4, Qt::ControlModifier);
    page.typeArea({{-10.0, -10.0}, {10.0, 10.0}});
    page.press("Start");
    QMetaObject::invokeMethod(&server, [&] { server.tick(); });
    QTRY_VERIFY_WITH_TIMEOUT(!dock.isEmpty(), soon_ms);

    const PaintedNews news(page.window().views().plan->view());
    QElapsedTimer clock;
    clock.start();
    std::vector<qint64> delays_us;
    for (int i = 0; i < 25; ++i) {
        QTest::qWait(67); // at any moment of a beat
        std::atomic<qint64> from_us = 0;
        const int before = news.count();
        QMetaObject::invokeMethod(&server, [&] {
            from_us = clock.nsecsElapsed() / 1000;
            server.tick();
        });
        qint64 seen_us = 0;
        QVERIFY(QTest::qWaitFor([&] {
            seen_us = clock.nsecsElapsed() / 1000;
            return news.count() > before;
        }));
        delays_us.push_back(seen_us - from_us);
    }
    std::ranges::sort(delays_us);
    qInfo("state to painted cycle: median %lld us, worst %lld us", delays_us[12], delays_us.back());
    QVERIFY2(delays_us[12] < 200000, "half of them wait for a beat");
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
    WindowPage page({.mission_file = missionFile(folder)});
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
    page.window().saveMission(mission);
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
    WindowPage page({.mission_file = missionFile(folder)});
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.dropFile(fileIn(folder, "own.lap", text)));
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("own.lap").contains(says), soon_ms);
    QVERIFY(page.window().views().behavior->plan().path().isEmpty());
}

USAR_E2E_MAIN(tst_WindowPlan)
#include "tst_window_plan.moc"
