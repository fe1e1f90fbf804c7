// The end of a mission in the real window: a card tells it, and leads to the files and to the next flight.
#include <algorithm>

#include <QCheckBox>
#include <QDir>
#include <QLabel>
#include <QLockFile>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/behavior_panel.h"
#include "widgets/panels/compare_dialog.h"
#include "widgets/panels/export_dialog.h"

namespace tst_window_results {

using namespace usar;

namespace {

/// Spawns a robot and draws an area around it.
bool hasAFieldToScan(WindowPage& page) {
    if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
        return false;
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    return page.map().area().has_value();
}

} // namespace

class tst_WindowResults : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }

    void aCardTellsTheEndAndFliesAgain() {
        WindowPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(page.spawnAt("PlayerStart"));
        auto* const card = page.window().views().result;
        page.pressKey(Qt::Key_A);
        page.drawArea({{-10, -10}, {10, 10}});
        page.pressKey(Qt::Key_0, Qt::ControlModifier);
        auto* const hint = page.window().views().hint;
        QVERIFY(hint->accessibleDescription().contains("Press Start"));
        page.press("Start");
        QVERIFY(hint->accessibleDescription().contains("P pauses the robot"));
        QVERIFY(card->isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), flight_ms);
        QVERIFY(card->accessibleDescription().startsWith("R1: mission complete"));
        QString figures;
        for (const QLabel* label : card->findChildren<QLabel*>())
            figures += QString(label->text()).replace("&nbsp;", " ");
        for (const char* name : {"Coverage <b>", "Time <b>", "Distance <b>", "Heights <b>", "Error <b>"})
            QVERIFY2(figures.contains(name), qPrintable(figures));
        QVERIFY(!page.notified("Saved").isEmpty());
        page.screenshot("result_card");
        page.press("Compare");
        auto* const compare = page.window().findChild<widgets::CompareDialog*>();
        QVERIFY(compare && compare->isVisible() && !compare->isModal());
        QTRY_COMPARE_WITH_TIMEOUT(compare->runs().size(), std::size_t(1), soon_ms);
        QVERIFY(compare->runs()[0].coverage_pct && !compare->runs()[0].picture.isEmpty() &&
                compare->trouble().isEmpty());
        compare->close();
        page.window().commands().action("file.compare")->trigger();
        QVERIFY(compare->isVisible());
        compare->close();
        page.press("Fly again");
        QTRY_VERIFY_WITH_TIMEOUT(page.window().control().robot({1})->running(), soon_ms);
        QVERIFY(card->isHidden());
    }

    /// With the box ticked, the map is made again at the end, and the card tells how much better its strips agree.
    void aCorrectedMapTellsBeforeAndAfter() {
        WindowPage page;
        QVERIFY(hasAFieldToScan(page));
        auto* const panel = page.window().views().behavior;
        QVERIFY(!panel->adjusts());
        for (QCheckBox* box : panel->findChildren<QCheckBox*>())
            if (box->isVisible() && box->text() == "Correct the map where strips overlap")
                QTest::mouseClick(box, Qt::LeftButton, {}, {10, box->height() / 2});
        QVERIFY(panel->adjusts());
        page.pressKey(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!panel->adjusts());
        page.window().commands().action("edit.redo")->trigger(); // Its key differs between platforms.
        QVERIFY(panel->adjusts());
        page.pressKey(Qt::Key_0, Qt::ControlModifier);
        page.press("Start");
        auto* const card = page.window().views().result;
        QTRY_VERIFY_WITH_TIMEOUT(card->isVisible(), flight_ms);
        const QString corrected_words = page.notified("The map was corrected.");
        QVERIFY2(corrected_words.contains("The path was moved by"), qPrintable(corrected_words));
        QStringList figures;
        for (const QLabel* label : card->findChildren<QLabel*>())
            figures << QString(label->text()).replace("&nbsp;", " ");
        QVERIFY2(figures.join(' ').contains("Overlaps <b>"), qPrintable(figures.join('\n')));
        QVERIFY2(figures.join(' ').contains("Path moved <b>"), qPrintable(figures.join('\n')));
        const auto& robots = page.window().views().map->content().robots;
        QCOMPARE(robots.size(), std::size_t(1));
        const widgets::SharedPath& corrected = robots.begin()->second.corrected_in_map_m;
        QVERIFY2(corrected && corrected->size() > 20, "the map shows the corrected path");
        page.screenshot("result_card_corrected");
    }

    /// A limit that is typed ends the flight on the robot's clock, and its undoing takes it away.
    void aTimeLimitEndsTheFlight() {
        WindowPage page;
        QVERIFY(hasAFieldToScan(page));
        auto* const panel = page.window().views().behavior;
        QVERIFY(!panel->limit_h());
        const auto boxes = panel->findChildren<widgets::QuantityBox*>();
        const auto found = std::ranges::find(boxes, QStringLiteral("Time limit"), &QWidget::accessibleName);
        QVERIFY(found != boxes.end());
        auto* const box = *found;
        QCOMPARE(box->text(), "none");
        const auto type = [&](const QString& hours) {
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, hours);
            QTest::keyClick(box, Qt::Key_Return);
        };
        type("2");
        QCOMPARE(panel->limit_h(), std::optional(2.0));
        type("0.01");
        QCOMPARE(panel->limit_h(), std::optional(0.01));
        page.window().commands().action("edit.undo")->trigger();
        QCOMPARE(panel->limit_h(), std::optional(2.0));
        page.window().commands().action("edit.redo")->trigger();
        page.screenshot("time_limit");
        page.pressKey(Qt::Key_0, Qt::ControlModifier);
        page.press("Start");
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("longer than its limit of 36 s").isEmpty(), flight_ms);
        const auto& figures = page.window().control().robot({1})->view().figures;
        QTRY_VERIFY_WITH_TIMEOUT(!page.window().control().robot({1})->running(), soon_ms);
        QVERIFY2(figures.now.count() > 36.0, qPrintable(QString::number(figures.now.count())));
    }

    /// The map of a robot in flight, in every format, and once more where it cannot be written.
    void aMapIsExportedForOtherPrograms() {
        WindowPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QAction* const command = page.window().commands().action("file.export_map");
        QVERIFY(!command->isEnabled());
        QVERIFY(page.spawnAt("PlayerStart"));
        page.pressKey(Qt::Key_A);
        page.drawArea({{-10, -10}, {10, 10}});
        page.chooseSpeed("max");
        page.press("Start");
        QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
        command->trigger();
        auto* const dialog = page.window().findChild<widgets::ExportDialog*>();
        QVERIFY(dialog && dialog->isVisible() && !dialog->isModal());
        QCOMPARE(dialog->chosen(), QStringList{"tif"});
        dialog->setChosen({"tif", "asc", "geojson", "ply", "las"});
        dialog->setFolder(page.resultFolder() + "/exports");
        page.screenshot("export_dialog");
        page.press("Export");
        QVERIFY(!dialog->isVisible());
        const QDir folder(page.resultFolder() + "/exports");
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Exported the map of R1 to " + folder.path()).isEmpty(), soon_ms);
        const QString stem = "USAR_Scan_tall-test_R1_001.";
        QCOMPARE(folder.entryList(QDir::Files, QDir::Name),
                 (QStringList{stem + "asc", stem + "geojson", stem + "las", stem + "ply", stem + "tif"}));
        QVERIFY(QFileInfo(folder.filePath(stem + "las")).size() > 1000);
        page.screenshot("map_exported");
        command->trigger();
        QCOMPARE(dialog->chosen().size(), 5);
        dialog->setFolder(folder.filePath(stem + "tif"));
        page.press("Export");
        QTRY_VERIFY_WITH_TIMEOUT(!page.notified("cannot create the folder for the results").isEmpty(), soon_ms);
    }

    void aLongSaveIsSaidAndCanBeCancelled() {
        WindowPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(page.spawnAt("PlayerStart"));
        QAction* const cancel = page.window().commands().action("file.cancel_saving");
        QVERIFY(!cancel->isEnabled());
        QVERIFY(QDir().mkpath(page.resultFolder()));
        QLockFile other(QDir(page.resultFolder()).filePath(".usar_scan.lock")); // Another program saves there.
        QVERIFY(other.lock());
        page.pressKey(Qt::Key_E, Qt::ControlModifier);
        auto* const strip = page.window().views().saving;
        QTRY_VERIFY_WITH_TIMEOUT(strip->isVisible(), soon_ms);
        QVERIFY(strip->findChild<QLabel*>()->text().contains("Saving what R1 has scanned"));
        QVERIFY(cancel->isEnabled());
        page.press("Cancel");
        QTRY_VERIFY_WITH_TIMEOUT(!strip->isVisible(), soon_ms);
        QVERIFY(!page.notified("cancelled").isEmpty());
        QVERIFY(!cancel->isEnabled());
        QVERIFY(QDir(page.resultFolder()).entryList({"USAR_Scan_*"}, QDir::Files).isEmpty());
    }
};

USAR_TEST(tst_WindowResults)

} // namespace tst_window_results

#include "tst_window_results.moc"
