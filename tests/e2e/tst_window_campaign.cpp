// Campaigns from the dock: set up, flown in the background, and single runs back on the screen.
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "app/desks/campaign_setup.h"
#include "core/base/version.h"
#include "core/campaign/runs/shard_file.h"
#include "tests/doubles/two_flights.h"
#include "tests/e2e/campaign_page.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/suite/suite.h"
#include "widgets/panels/compare_dialog.h"

namespace tst_window_campaign {

using namespace usar;

namespace {

const QByteArray small = R"({ "name": "Small", "area": { "x": -8, "y": -6, "width": 16, "height": 12 } })";

QJsonObject summaryIn(const QString& folder) {
    const QStringList names = filesIn(folder, ".json");
    QFile file(QDir(folder).filePath(names.value(0)));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

} // namespace

class tst_WindowCampaign : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void runsComeAndOneFliesAgainAsItWas();
    void twoVariantsOfASeedAreShownBesideEachOther();
    void wrongInputIsSaidInTheDock();
    void theSuggestedValuesCanBeTyped();
    void aReplayAloneHasNoWorldToFlyIn();
};

void tst_WindowCampaign::runsComeAndOneFliesAgainAsItWas() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = fileIn(folder, "small.json", small)});
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    CampaignDock dock(page);
    dock.open();
    QVERIFY(dock.hasMission());
    dock.typeSeeds(7, 2);
    dock.typeJobs(1);
    dock.toggleBehavior("POSH");
    page.press("Run campaign");
    QTRY_VERIFY_WITH_TIMEOUT(dock.table().rowCount() > 0, flight_ms);
    page.press("Stop");
    const QAction* const resume = page.window().commands().action("campaign.resume");
    QTRY_VERIFY_WITH_TIMEOUT(resume->isEnabled(), soon_ms);
    QVERIFY(dock.table().rowCount() < 4);
    page.press("Resume");
    QVERIFY(dock.ends(4));
    QCOMPARE(dock.panel().trouble(), QString());
    QVERIFY2(dock.panel().verdict()->text().contains("POSH"), qPrintable(dock.panel().verdict()->text()));
    const QString results = page.resultFolder() + "/campaigns/tall_test";
    const auto runs = campaign::readResults(results, std::string(version()));
    QVERIFY(runs);
    const campaign::RunResult& last = runs->at(2);
    QCOMPARE(last.seed, std::uint64_t(8));

    dock.doubleClickRun(2);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.behavior_running, soon_ms);
    QCOMPARE(page.window().control().server().simulator.seed, quint64(8));
    QCOMPARE(page.robot(1)->behavior_id, std::string("airrobot/cpp"));
    page.window().commands().action("time.max")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!filesIn(page.resultFolder(), ".json").isEmpty(), flight_ms);
    const QJsonObject again = summaryIn(page.resultFolder());
    for (const char* const key :
         {"success", "seed", "duration_s", "distance_m", "coverage_pct", "rmse_m", "cells", "lines_received"})
        QVERIFY2(again[key] == last.summary[key], key);
    page.screenshot("campaign");
}

void tst_WindowCampaign::twoVariantsOfASeedAreShownBesideEachOther() {
    const QTemporaryDir folder;
    WindowPage page({.mission_file = fileIn(folder, "small.json", small)});
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    CampaignDock dock(page);
    dock.open();
    QVERIFY(dock.hasMission());
    dock.typeSeeds(3, 1);
    dock.toggleBehavior("POSH");
    page.press("Run campaign");
    QVERIFY(dock.ends(2));
    const auto labels = dock.panel().findChildren<QLabel*>();
    QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().startsWith("Small \u00b7 "); }));
    QVERIFY2(dock.panel().height() >= 0.4 * page.window().centralWidget()->height(), "There is room for a table.");
    dock.clickRun(1);
    page.window().commands().action("campaign.fly_pair")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2), flight_ms);
    for (const int id : {1, 2})
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(id)->figures.replay && page.robot(id)->figures.replay->playing, soon_ms);
    auto* const compared = page.window().findChild<widgets::CompareDialog*>();
    QTRY_VERIFY_WITH_TIMEOUT(compared && compared->runs().size() == 2, soon_ms);
    QCOMPARE(compared->runs()[0].behavior, QString("airrobot/cpp"));
    QCOMPARE(compared->runs()[1].behavior, QString("airrobot/posh"));
    QCOMPARE(compared->runs()[0].title, QString("C++, seed 3"));
    QCOMPARE(compared->runs()[1].title, QString("POSH, seed 3"));
    QStringList names;
    for (const int id : {1, 2})
        names << QString::fromStdString(page.robot(id)->spawn.robot_name);
    names.sort();
    QCOMPARE(names, (QStringList{"C++ replay", "POSH replay"}));
    const auto differs = [&] {
        const auto labels = compared->findChildren<QLabel*>();
        return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains("minus first"); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(differs(), soon_ms);
    page.window().commands().action("replay.play")->trigger(); // An order to one holds for both.
    for (const int id : {1, 2})
        QTRY_VERIFY_WITH_TIMEOUT(!page.robot(id)->figures.replay->playing, soon_ms);
}

void tst_WindowCampaign::wrongInputIsSaidInTheDock() {
    const QTemporaryDir folder;
    WindowPage page;
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    CampaignDock dock(page);
    dock.open();
    const auto says = [&](const QString& words) {
        const auto labels = dock.panel().findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(says("no mission area"), soon_ms); // Nothing was drawn.
    page.window().campaigns().openFile(fileIn(folder, "bad.json", "{ \"name\": \"A\",\n  \"missions\": 3 }"));
    QVERIFY(says("bad.json:2:"));
    page.window().campaigns().openResults(folder.path());
    QVERIFY(says("this folder holds no campaign"));
    page.window().campaigns().openFile(
        fileIn(folder, "gone.json", R"({ "name": "Gone", "missions": ["gone_m.json"] })"));
    QTRY_VERIFY_WITH_TIMEOUT(says("Gone, from gone.json"), soon_ms);
    page.press("Run campaign");
    QTRY_VERIFY_WITH_TIMEOUT(dock.panel().trouble().contains("gone_m.json"), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(says("no runs"), soon_ms);
    QVERIFY(!page.window().commands().action("campaign.resume")->isEnabled()); // There is nothing to go on with.
}

void tst_WindowCampaign::theSuggestedValuesCanBeTyped() {
    WindowPage page;
    int suggested = 0;
    for (const agent::RobotDescription& robot : page.window().control().plugins().kinds())
        for (const agent::BehaviorDescription& behavior : robot.behaviors)
            for (const widgets::CampaignParameter& one : app::parametersOf(behavior, {})) {
                const auto spec =
                    std::ranges::find(behavior.parameters, one.id.toStdString(), &agent::ParameterSpec::id);
                const auto values = campaign::readValues(one.usual, app::valueWordsOf(*spec));
                QVERIFY2(values && values->size() == 1, qPrintable(one.label + ": " + one.usual));
                QVERIFY2(!one.usual.contains(QChar(0x00a0)), qPrintable(one.usual));
                ++suggested;
            }
    QVERIFY(suggested > 10);
}

void tst_WindowCampaign::aReplayAloneHasNoWorldToFlyIn() {
    const QTemporaryDir folder;
    WindowPage page({.recording = fileIn(folder, "R1.usarrec", QByteArray::fromStdString(doubles::twoFlights()))});
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().replay->isVisible(), soon_ms);
    CampaignDock dock(page);
    dock.open();
    const auto says = [&](const QString& words) {
        const auto labels = dock.panel().findChildren<QLabel*>();
        return std::ranges::any_of(
            labels, [&](const QLabel* label) { return label->isVisible() && label->text().contains(words); });
    };
    QTRY_VERIFY_WITH_TIMEOUT(says("There is no world to fly in"), soon_ms);
    page.press("Run campaign");
    QVERIFY(says("There is no world to fly in"));
    QVERIFY(!page.window().commands().action("campaign.resume")->isEnabled());
    QVERIFY(!QDir(page.resultFolder() + "/campaigns").exists());
}

USAR_TEST(tst_WindowCampaign)

} // namespace tst_window_campaign

#include "tst_window_campaign.moc"
