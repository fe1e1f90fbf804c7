// The samples that come with the program, opened where a view is still empty.
#include <QClipboard>
#include <QDir>
#include <QDirIterator>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include "core/server/embedded/program_files.h"
#include "tests/e2e/campaign_page.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/compare_dialog.h"

namespace tst_window_samples {

using namespace usar;

namespace {

/// Presses the button of the sheet that covers an empty view.
void pressButtonOf(widgets::EmptyState* sheet, const QString& text) {
    auto* const button = sheet->findChild<QPushButton*>();
    QVERIFY(sheet->isVisible() && button->isVisible());
    QCOMPARE(button->text(), text);
    QTest::mouseClick(button, Qt::LeftButton);
}

} // namespace

class tst_WindowSamples : public QObject {
    Q_OBJECT
private slots:
    void theFlightIsReplayedAndItsMapGrows() {
        WindowPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        page.screenshot("samples_empty_list");
        pressButtonOf(page.window().views().robots->emptyState(), "Open sample flight");
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.window().views().replay->isVisible(), soon_ms);
        QVERIFY(page.window().control().robot({1})->isReplay());
        page.window().commands().action("replay.faster")->trigger();
        page.window().commands().action("replay.play")->trigger();
        QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() > 0, flight_ms);
        page.screenshot("samples_flight");
    }

    void theScanHasFiguresAndAPicture() {
        WindowPage page;
        page.window().commands().action("sample.scan")->trigger();
        auto* const compare = page.window().findChild<widgets::CompareDialog*>();
        QVERIFY(compare && compare->isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(compare->runs().size(), std::size_t(1), soon_ms);
        QVERIFY2(compare->trouble().isEmpty(), qPrintable(compare->trouble()));
        QVERIFY(compare->runs()[0].coverage_pct > 90.0 && QFile::exists(compare->runs()[0].picture));
        compare->close();
    }

    void aRunOfTheCampaignIsFlownAgain() {
        const QTemporaryDir folder;
        WindowPage page({.result_folder = folder.path()});
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        CampaignDock dock(page);
        dock.open();
        dock.showPage(widgets::CampaignPanel::Page::Runs);
        pressButtonOf(dock.panel().runs()->emptyState(), "Open sample campaign");
        QVERIFY(dock.ends(48));
        page.screenshot("samples_campaign");
        dock.showPage(widgets::CampaignPanel::Page::Runs);
        dock.clickRun(1);
        page.window().commands().action("campaign.copy")->trigger();
        const QString mission = folder.filePath("Sample/sample.mission.json");
        QVERIFY2(QGuiApplication::clipboard()->text().contains(mission),
                 qPrintable(QGuiApplication::clipboard()->text()));
        dock.doubleClickRun(1);
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
        QTRY_VERIFY_WITH_TIMEOUT(page.window().control().robot({1})->running(), soon_ms);
    }

    void theyAreSmallAndNameNoOtherPlace() {
        const QDir folder(server::samplesFolder());
        const QRegularExpression whole_path("[\"' =]/[a-z]+/"); // Paths from the root of another machine.
        QVERIFY(QString("\"usar-mission run /home/me/a.json\"").contains(whole_path));
        qint64 bytes = 0;
        for (QDirIterator files(folder.path(), QDir::Files, QDirIterator::Subdirectories); files.hasNext();) {
            QFile file(files.next());
            bytes += file.size();
            QVERIFY(file.open(QIODevice::ReadOnly));
            if (const QString name = QFileInfo(file).suffix(); name == "json" || name == "jsonl" || name == "html")
                QVERIFY2(!QString(file.readAll()).contains(whole_path), qPrintable(file.fileName()));
        }
        QVERIFY(bytes > 0);
        QVERIFY2(bytes < 3'000'000, qPrintable(QString::number(bytes)));
        QVERIFY(QFile::exists(folder.filePath("campaign/report.html")));
    }
};

USAR_TEST(tst_WindowSamples)

} // namespace tst_window_samples

#include "tst_window_samples.moc"
