// A moment of the simulator, kept and taken up again in the real window.
#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include "tests/doubles/test_files.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_snapshots {

using namespace usar;

namespace {

/// With a robot of a run whose end lies years off.
struct LongRun {
    QTemporaryDir folder;
    QString file = folder.filePath("long.usarsnap");
    WindowPage page;

    bool isKept() {
        if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
            return false;
        page.window().control().simulator().saveSnapshot(file);
        if (!QTest::qWaitFor([&] { return !page.notified("Snapshot saved").isEmpty(); }, soon_ms))
            return false;
        std::string text = doubles::readAll(file.toStdString());
        const std::size_t at = text.find("\nticks ") + 7;
        text.replace(at, text.find('\n', at) - at, "90000000");
        doubles::writeAll(file.toStdString(), text);
        return true;
    }
    widgets::ProgressStrip& strip() { return *page.window().views().progress; }
    /// It is on its way and says so.
    bool isTakenUp() {
        page.window().server().openSnapshot(file);
        return QTest::qWaitFor(
            [&] { return strip().isVisible() && strip().findChild<QLabel*>()->text().contains(" of 5000 h"); },
            soon_ms);
    }
};

} // namespace

class tst_WindowSnapshots : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void robotsGoOnWhereTheyWere();
    void aLongRunIsSaidAndCanBeCancelled();
    void closingTheWindowDoesNotWaitForALongRun();
    void aFileThatIsNoSnapshotIsNamed();
    void aFolderThatCannotBeWrittenIsNamed();
};

void tst_WindowSnapshots::robotsGoOnWhereTheyWere() {
    QTemporaryDir folder;
    const QString file = folder.filePath("run.usarsnap");
    WindowPage page;
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(page.spawnAt("HillTop"));
    const double kept_s = page.robot(1)->figures.now.count();
    page.window().control().simulator().saveSnapshot(file);
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Snapshot saved").isEmpty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now.count() > kept_s + 3.0, soon_ms);
    const double later_s = page.robot(1)->figures.now.count();

    page.window().server().openSnapshot(file);
    const auto both = [&] {
        const auto robots = page.window().control().robots();
        return robots.size() == 2 && robots[0]->view().figures.spawned && robots[1]->view().figures.spawned &&
               robots[0]->view().figures.now.count() < later_s; // those from before go on until then
    };
    QTRY_VERIFY_WITH_TIMEOUT(both(), soon_ms);
    const auto robots = page.window().control().robots();
    QCOMPARE(robots[0]->view().spawn.robot_name, std::string("R1"));
    QCOMPARE(robots[0]->view().spawn.class_name, std::string("USARBot.AirRobot"));
    QCOMPARE(robots[1]->view().spawn.robot_name, std::string("R2"));
    QVERIFY(robots[0]->view().figures.now.count() >= kept_s);
    QVERIFY2(robots[0]->view().figures.now.count() < later_s, "time has gone back to where it was kept");
    const double resumed_s = robots[0]->view().figures.now.count();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now.count() > resumed_s + 0.5, soon_ms); // and goes on
}

void tst_WindowSnapshots::aLongRunIsSaidAndCanBeCancelled() {
    LongRun run;
    QVERIFY(run.isKept());
    WindowPage& page = run.page;
    const ConnectionId connection = page.robot(1)->connection;
    QVERIFY(run.isTakenUp());
    QVERIFY(run.strip().findChild<QLabel*>()->text().contains("Taking up long.usarsnap"));
    QVERIFY(page.window().commands().action("simulator.cancel_opening")->isEnabled());
    page.screenshot("snapshot_progress");
    const double then_s = page.robot(1)->figures.now.count();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now.count() > then_s + 0.5, soon_ms); // what runs goes on
    page.press("Cancel");
    QVERIFY(!run.strip().isVisible());
    QVERIFY(!page.notified("cancelled").isEmpty());
    QVERIFY(!page.window().commands().action("simulator.cancel_opening")->isEnabled());
    const double cancelled_s = page.robot(1)->figures.now.count();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now.count() > cancelled_s + 0.5, soon_ms);
    QCOMPARE(page.robot(1)->connection, connection);
    QVERIFY(!run.strip().isVisible());

    QVERIFY(run.isTakenUp());
    page.press("Disconnect"); // who leaves wants no other world, either
    QVERIFY(!run.strip().isVisible());
    QVERIFY(!page.window().commands().action("simulator.cancel_opening")->isEnabled());
}

void tst_WindowSnapshots::closingTheWindowDoesNotWaitForALongRun() {
    QElapsedTimer closing;
    {
        LongRun run;
        QVERIFY(run.isKept());
        QVERIFY(run.isTakenUp());
        closing.start();
        QVERIFY(run.page.window().close());
    }
    QVERIFY2(closing.elapsed() < 60'000, qPrintable(QString::number(closing.elapsed()))); // the run takes hours
}

void tst_WindowSnapshots::aFileThatIsNoSnapshotIsNamed() {
    QTemporaryDir folder;
    QFile file(folder.filePath("run.usarsnap"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("something else\n");
    file.close();
    WindowPage page;
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    page.window().server().openSnapshot(file.fileName());
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("run.usarsnap: line 1: this is not a snapshot").contains("Save snapshot"),
                             soon_ms);
}

void tst_WindowSnapshots::aFolderThatCannotBeWrittenIsNamed() {
    WindowPage page;
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    page.window().control().simulator().saveSnapshot("/proc/nowhere/run.usarsnap");
    QTRY_VERIFY_WITH_TIMEOUT(
        page.notified("/proc/nowhere/run.usarsnap: the snapshot cannot be written").contains("Choose another folder"),
        soon_ms);
}

USAR_TEST(tst_WindowSnapshots)

} // namespace tst_window_snapshots

#include "tst_window_snapshots.moc"
