// Plugins while the window runs: built anew, taken away, and behaviors that go wrong in the air.
#include <csignal>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QLabel>
#include <QListView>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/signaling.h"
#include "tests/suite/suite.h"
#include "widgets/messages/toast_stack.h"
#include "widgets/panels/plugin_dialog.h"

namespace tst_window_plugins {

using namespace usar;

namespace {

const QString built = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/");
const QString robots = QStringLiteral(USAR_BINARY_DIR "/robots");
const QString slow = built + "dangerous/slow_to_tell.so";

/// As a linker does: the file stays, and what is in it changes.
void writeOver(const QString& file, const QString& source) {
    QFile from(source);
    QFile to(file);
    QVERIFY(from.open(QIODevice::ReadOnly));
    QVERIFY(to.open(QIODevice::WriteOnly | QIODevice::Truncate));
    QVERIFY(to.write(from.readAll()) > 0);
}

bool flies(const WindowPage& page) {
    return page.robot(1) && page.robot(1)->figures.behavior_running && page.robot(1)->status;
}

/// In the air, with this behavior.
bool startFlight(WindowPage& page, const std::string& behavior_id) {
    if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
        return false;
    page.window().views().behavior->chooseBehavior(behavior_id);
    if (page.window().views().behavior->behaviorId() != behavior_id)
        return false;
    page.press("Start");
    return QTest::qWaitFor([&] { return flies(page); }, soon_ms);
}

/// The processes of behaviors that we have started.
QList<int> hosts() {
    QList<int> found;
    for (const QString& process : QDir("/proc").entryList({"[0-9]*"}, QDir::Dirs)) {
        QFile status("/proc/" + process + "/stat");
        if (!status.open(QIODevice::ReadOnly))
            continue;
        const QByteArray text = status.readAll(); // "17 (usar-behavior-h) S 12 …"
        const QList<QByteArray> words = text.mid(text.lastIndexOf(')') + 2).split(' ');
        if (text.contains("(usar-behavior") && words.value(0) != "Z" &&
            words.value(1).toLongLong() == QCoreApplication::applicationPid())
            found << process.toInt();
    }
    return found;
}

/// On a toast; nullptr where none says so.
QPushButton* offerButton(WindowPage& page, const QString& text) {
    for (widgets::Toast* toast : page.map().findChildren<widgets::Toast*>())
        for (QPushButton* button : toast->findChildren<QPushButton*>())
            if (button->isVisible() && button->text() == text)
                return button;
    return nullptr;
}

/// As a person may: on the toast, by the key, or on the row of the list.
void takeOffer(WindowPage& page, const QString& text, const QString& by) {
    if (by == "key")
        return page.pressKey(Qt::Key_Return, Qt::ControlModifier | Qt::ShiftModifier);
    if (by == "toast") {
        QPushButton* const button = offerButton(page, text);
        QVERIFY(button && button->toolTip().contains("Ctrl+Shift+Return"));
        return QTest::mouseClick(button, Qt::LeftButton);
    }
    auto* const dock = page.window().views().notifications_dock;
    dock->show();
    dock->raise();
    auto* const list = dock->findChild<QListView*>();
    QTRY_VERIFY(list->isVisible());
    const QModelIndex row = list->model()->index(0, 0);
    QVERIFY(row.data(Qt::AccessibleTextRole).toString().endsWith("Press Return to do this: " + text + "."));
    list->setFocus();
    list->setCurrentIndex(row);
    QTest::keyClick(list, Qt::Key_Return);
}

/// Of a person who has chosen this before.
void isolate(const QTemporaryDir& settings, const QString& plugin) {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
    QSettings().setValue("isolated_plugins", QStringList{plugin});
}

/// The rows of the selected robot's behaviors.
QStringList behaviorRows(WindowPage& page) {
    const auto* const box = page.window().views().behavior->findChild<QComboBox*>();
    QStringList rows;
    for (int i = 0; i < box->count(); ++i)
        rows << box->itemText(i);
    return rows;
}

/// What the behavior's panel says a task would come to.
bool summarized(WindowPage& page, const QString& words) {
    for (const QLabel* label : page.window().views().behavior->findChildren<QLabel*>())
        if (label->isVisible() && label->text().contains(words))
            return true;
    return false;
}

/// The sensors that the open list of plugins says this file needs.
QStringList sensorsNeeded(WindowPage& page, const QString& file) {
    const auto* const list = page.window().findChild<widgets::PluginDialog*>();
    if (list)
        for (const widgets::PluginRow& row : list->plugins())
            if (row.file.endsWith(file))
                return row.sensors;
    return {"not listed"};
}

QCheckBox* isolationBox(const WindowPage& page) {
    return const_cast<WindowPage&>(page).window().views().behavior->findChild<QCheckBox*>();
}

} // namespace

class tst_WindowPlugins : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() {
        qunsetenv("USAR_TEST_SLOW_S");
        QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint());
    }
    void aPluginThatIsBuiltAnewIsLoadedByItself();
    void aPluginBuiltAnewInFlightDecidesFromTheNextStartOn();
    void theCommandSaysAlsoThatNothingIsNew();
    void aHangingBehaviorIsStoppedAndTheRobotCanFlyOn();
    void whatBrokeIsStartedAgainByTheButtonInItsMessage_data();
    void whatBrokeIsStartedAgainByTheButtonInItsMessage();
    void theOfferOfARobotGoesWithItAndWithAnotherStart();
    void aBehaviorKilledInFlightCostsItsRobotABehaviorAndNobodyElseAnything_data();
    void aBehaviorKilledInFlightCostsItsRobotABehaviorAndNobodyElseAnything();
    void isolationIsChosenForAPluginAndRemembered();
    void whatEndedTheProgramIsOfferedAProcessOfItsOwn();
    void aPluginThatIsAskedIsAtOnceInTheListAndFilledInLater();
    void theListSaysWhichSensorsEachPluginNeeds();
    void aPluginThatHangsWhenAskedHoldsNobodyUp();
    void closingTheWindowWhileItAsksDoesNotWait();
    void aPreviewThatHangsIsToldOfWhileTheWindowGoesOn();
    void aMissionForAPluginThatIsAskedIsSetUpOnceItHasAnswered();
    void whatIsSetUpOutlivesABuildOfAnIsolatedPlugin();
};

void tst_WindowPlugins::aPluginThatIsBuiltAnewIsLoadedByItself() {
    QTemporaryDir folder;
    writeOver(folder.filePath("robot.so"), built + "good.so");
    WindowPage page({.plugin_folders = {folder.path()}});
    const auto& plugins = page.window().control().plugins();
    QCOMPARE(plugins.robots().front().name, std::string("Test robot"));
    writeOver(folder.filePath("robot.so"), built + "rebuilt.so");
    QTRY_COMPARE_WITH_TIMEOUT(plugins.robots().front().name, std::string("Rebuilt robot"), soon_ms);
    QVERIFY(page.notified("robot.so was built anew").contains("the new code"));
    writeOver(folder.filePath("robot.so"), built + "wrong_version.so");
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("robot.so was refused").contains("Rebuild it"), soon_ms);
    QVERIFY(QFile::remove(folder.filePath("robot.so")));
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("robot.so is gone").isEmpty(), soon_ms);
}

void tst_WindowPlugins::aPluginBuiltAnewInFlightDecidesFromTheNextStartOn() {
    QTemporaryDir folder;
    writeOver(folder.filePath("faulty.so"), built + "faulty.so");
    WindowPage page({.plugin_folders = {folder.path()}});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(startFlight(page, "faulty/none"));
    writeOver(folder.filePath("faulty.so"), built + "faulty.so");
    page.pressKey(Qt::Key_F5, Qt::ControlModifier);
    QVERIFY2(page.notified("faulty.so was built anew").contains("R1 goes on with the old one"),
             qPrintable(page.notified("faulty.so")));
    const Seconds then = page.robot(1)->figures.now;
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > then + Seconds(1.0), soon_ms);
    QVERIFY(page.robot(1)->figures.behavior_running);
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1)->figures.behavior_running, soon_ms);
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(flies(page), soon_ms);
}

void tst_WindowPlugins::theCommandSaysAlsoThatNothingIsNew() {
    WindowPage page({.plugin_folders = {robots}});
    page.pressKey(Qt::Key_F5, Qt::ControlModifier);
    QVERIFY(!page.notified("No plugin is new").isEmpty());
}

void tst_WindowPlugins::aHangingBehaviorIsStoppedAndTheRobotCanFlyOn() {
    WindowPage page({.plugin_folders = {built}});
    QVERIFY(startFlight(page, "faulty/loop"));
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("faulty/loop hangs").isEmpty(), soon_ms);
    QVERIFY(page.notified("faulty/loop hangs").startsWith("R1"));
    QVERIFY(!page.robot(1)->figures.behavior_running);
    page.window().views().behavior->chooseBehavior("faulty/none");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(flies(page), soon_ms);
}

void tst_WindowPlugins::aBehaviorKilledInFlightCostsItsRobotABehaviorAndNobodyElseAnything_data() {
    QTest::addColumn<std::string>("behavior");
    QTest::addColumn<int>("signal");
    QTest::addColumn<QString>("words");
    QTest::newRow("kill -SEGV") << std::string("faulty/none") << SIGSEGV << "died by SIGSEGV";
    QTest::newRow("kill -KILL") << std::string("faulty/none") << SIGKILL << "died by SIGKILL";
    QTest::newRow("a fault of its own") << std::string("faulty/segfault") << 0 << "died by SIGSEGV";
}

void tst_WindowPlugins::aBehaviorKilledInFlightCostsItsRobotABehaviorAndNobodyElseAnything() {
    QFETCH(std::string, behavior);
    QFETCH(int, signal);
    QFETCH(QString, words);
    WindowPage page({.plugin_folders = {built}});
    QVERIFY(startFlight(page, "faulty/none")); // the other one, in this process
    QVERIFY(hosts().isEmpty());
    QVERIFY(page.spawnAt(page.map().content().start_poses.back().name));
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    page.window().views().behavior->chooseBehavior(behavior);
    isolationBox(page)->click();
    page.press("Start");
    if (signal != 0) {
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(2)->status && page.robot(2)->figures.behavior_running, soon_ms);
        QCOMPARE(hosts().size(), 1);
        QVERIFY(test::sendSignal(hosts().front(), signal));
    }
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified(words).isEmpty(), soon_ms);
    const QString said = page.notified(words);
    QVERIFY2(said.startsWith("R2: ") && said.contains(QString::fromStdString(behavior)), qPrintable(said));
    QVERIFY2(said.contains("climbing for the") && said.contains("line ") && said.contains("(STA"), qPrintable(said));
    QVERIFY2(said.contains("can be started again"), qPrintable(said));
    QVERIFY(!page.robot(2)->figures.behavior_running);

    const Seconds then = page.robot(1)->figures.now;
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > then + Seconds(1.0), soon_ms);
    QVERIFY(page.robot(1)->figures.behavior_running);
    page.window().views().behavior->chooseBehavior("faulty/none");
    QVERIFY(isolationBox(page)->isChecked());
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2)->status && page.robot(2)->figures.behavior_running, soon_ms);
    QCOMPARE(hosts().size(), 1);
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(hosts().isEmpty(), soon_ms); // it goes with its behavior
}

void tst_WindowPlugins::whatBrokeIsStartedAgainByTheButtonInItsMessage_data() {
    QTest::addColumn<std::string>("behavior");
    QTest::addColumn<bool>("isolated");
    QTest::addColumn<QString>("by");
    QTest::newRow("killed, by the toast") << std::string("faulty/none") << true << "toast";
    QTest::newRow("killed, by its key") << std::string("faulty/none") << true << "key";
    QTest::newRow("killed, by the list") << std::string("faulty/none") << true << "list";
    QTest::newRow("hung in the program, by the toast") << std::string("faulty/loop") << false << "toast";
}

void tst_WindowPlugins::whatBrokeIsStartedAgainByTheButtonInItsMessage() {
    QFETCH(std::string, behavior);
    QFETCH(bool, isolated);
    QFETCH(QString, by);
    WindowPage page({.plugin_folders = {built}});
    QVERIFY(startFlight(page, "faulty/none")); // the other one, in this process
    QVERIFY(page.spawnAt(page.map().content().start_poses.back().name));
    page.window().views().behavior->chooseBehavior(behavior);
    QVERIFY(page.typeParameter("ticks", "7"));
    if (isolated)
        isolationBox(page)->click();
    QVERIFY(!page.window().commands().action("mission.start_again")->isEnabled());
    page.press("Start");
    if (isolated) {
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(2)->status && page.robot(2)->figures.behavior_running, soon_ms);
        QCOMPARE(hosts().size(), 1);
        QVERIFY(test::sendSignal(hosts().front(), SIGKILL));
    }
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("The behavior " + QString::fromStdString(behavior)).isEmpty(), soon_ms);
    QVERIFY(!page.robot(2)->figures.behavior_running);
    page.pressKey(Qt::Key_1); // to another robot, with another behavior's form: the offer is for whom it names
    QVERIFY(page.typeParameter("ticks", "3"));
    QCOMPARE(page.window().selectedRobot(), RobotId{1});

    const Seconds then = page.robot(2)->figures.now;
    takeOffer(page, "Start R2 again", by);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2)->figures.behavior_running, soon_ms);
    QCOMPARE(hosts().size(), 1); // wherever it ran before
    const auto& started = *page.window().control().robot({2})->started();
    QCOMPARE(started.id, behavior);
    QCOMPARE(std::get<long long>(started.parameters.at("ticks")), 7LL);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2)->status && page.robot(2)->status->time > then, soon_ms); // it flies on
    QVERIFY(offerButton(page, "Start R2 again") == nullptr);
    QVERIFY(!page.window().commands().action("mission.start_again")->isEnabled());
    QVERIFY(page.robot(1)->figures.behavior_running); // nobody else has noticed anything
    const Seconds now = page.robot(1)->figures.now;
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > now, soon_ms);
}

void tst_WindowPlugins::theOfferOfARobotGoesWithItAndWithAnotherStart() {
    WindowPage page({.plugin_folders = {built}});
    QVERIFY(startFlight(page, "faulty/throw"));
    QTRY_VERIFY_WITH_TIMEOUT(offerButton(page, "Start R1 again"), soon_ms);
    page.window().views().behavior->chooseBehavior("faulty/none");
    page.press("Start");
    QVERIFY(!offerButton(page, "Start R1 again"));
    QVERIFY(!page.window().commands().action("mission.start_again")->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(flies(page), soon_ms);
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1)->figures.behavior_running, soon_ms);
    QVERIFY(!offerButton(page, "Start R1 again")); // whoever stops it does not want that
    page.window().views().behavior->chooseBehavior("faulty/throw");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(offerButton(page, "Start R1 again"), soon_ms);
    page.window().control().remove({1});
    QVERIFY(!offerButton(page, "Start R1 again"));
}

void tst_WindowPlugins::isolationIsChosenForAPluginAndRemembered() {
    QTemporaryDir settings;
    const QStringList folders{built, robots};
    {
        WindowPage page({.plugin_folders = folders, .settings_folder = settings.path()});
        page.window().views().behavior->chooseBehavior("airrobot/cpp");
        QVERIFY(!isolationBox(page)->isChecked());
        isolationBox(page)->click();
        page.window().views().behavior->chooseBehavior("airrobot/posh"); // of the same plugin
        QVERIFY(isolationBox(page)->isChecked());
        page.window().quit();
    }
    WindowPage page({.plugin_folders = folders, .settings_folder = settings.path()});
    page.window().views().behavior->chooseBehavior("airrobot/cpp");
    QVERIFY(isolationBox(page)->isChecked());
}

void tst_WindowPlugins::whatEndedTheProgramIsOfferedAProcessOfItsOwn() {
    QTemporaryDir folder;
    const QString file = folder.filePath("crashing.so");
    writeOver(file, built + "dangerous/crashes_in_the_program.so");
    QTemporaryDir settings;
    QDir(settings.path()).mkpath("USAR/plugins"); // what the program leaves behind that loads it
    const agent::PluginMarks marks(settings.filePath("USAR/plugins"));
    marks.begin(file, agent::stampOf(file));
    WindowPage page({.plugin_folders = {folder.path()}, .settings_folder = settings.path()});
    const auto& records = page.window().control().plugins().records();
    QVERIFY(page.notified("crashing.so was refused").contains("ended the program"));
    QVERIFY(records.front().dangerous);
    QTRY_VERIFY(offerButton(page, "Give Crashing robot its own process"));
    QTest::mouseClick(offerButton(page, "Give Crashing robot its own process"), Qt::LeftButton);
    QVERIFY(records.front().isolated);
    QTRY_VERIFY2_WITH_TIMEOUT(records.front().state == agent::PluginState::Loaded, qPrintable(records.front().reason),
                              soon_ms);
    QVERIFY(!page.notified("The plugin crashing.so was loaded: test/idle").isEmpty());
    QVERIFY(!offerButton(page, "Give Crashing robot its own process"));
}

void tst_WindowPlugins::aPluginThatIsAskedIsAtOnceInTheListAndFilledInLater() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    qputenv("USAR_TEST_SLOW_S", "2");
    WindowPage page({.plugin_folders = {slow}, .settings_folder = settings.path()});
    QCOMPARE(behaviorRows(page), QStringList{"slow/idle (asking…)"});
    QVERIFY(isolationBox(page)->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart")); // what it drives is known from its metadata
    QTRY_COMPARE_WITH_TIMEOUT(behaviorRows(page), QStringList{"Idle at last"}, soon_ms);
    QVERIFY(page.window().commands().action("mission.start")->isEnabled());
    QVERIFY(page.notified("slow_to_tell").isEmpty()); // it was there from the first, and nothing is wrong
}

/// What is not known is not said: of one that has not answered yet, and of one that is refused because another has its
/// behavior.
void tst_WindowPlugins::theListSaysWhichSensorsEachPluginNeeds() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    qputenv("USAR_TEST_SLOW_S", "2");
    WindowPage page(
        {.plugin_folders = {slow, built + "good.so", built + "twin.so", robots}, .settings_folder = settings.path()});
    page.window().commands().action("plugins.show")->trigger();
    QCOMPARE(sensorsNeeded(page, "slow_to_tell.so"), QStringList());
    QCOMPARE(sensorsNeeded(page, "good.so"), QStringList{"INS"});
    QCOMPARE(sensorsNeeded(page, "twin.so"), QStringList());
    QCOMPARE(sensorsNeeded(page, "airrobot.so"), QStringList({"INS", "GroundTruth", "RangeScanner", "Sonar"}));
    QTRY_COMPARE_WITH_TIMEOUT(sensorsNeeded(page, "slow_to_tell.so"), QStringList{"INS"}, soon_ms);
}

void tst_WindowPlugins::aPluginThatHangsWhenAskedHoldsNobodyUp() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    qputenv("USAR_TEST_SLOW_S", "60");
    WindowPage page({.plugin_folders = {slow, robots}, .settings_folder = settings.path()});
    QElapsedTimer clock;
    clock.start();
    QVERIFY(behaviorRows(page).contains("slow/idle (asking…)"));
    page.window().views().behavior->chooseBehavior("slow/idle");
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    const std::string chosen = page.window().views().behavior->behaviorId();
    const bool enabled = page.window().commands().action("mission.start")->isEnabled();
    if (clock.elapsed() < 4000) // or it has been given up already
        QVERIFY(chosen == "slow/idle" && !enabled);
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("did not answer for 5 s").isEmpty(), soon_ms);
    QVERIFY(page.notified("slow_to_tell.so was refused").contains("while being loaded in a separate process"));
    const auto* const told = page.window().views().notifications->model();
    const auto about = told->match(told->index(0, 0), Qt::DisplayRole, "slow_to_tell.so", -1, Qt::MatchContains);
    QCOMPARE(about.size(), 1); // in one message
    QVERIFY(!behaviorRows(page).contains("slow/idle (asking…)"));
    QTRY_VERIFY(hosts().isEmpty());

    qunsetenv("USAR_TEST_SLOW_S");
    QTRY_VERIFY(offerButton(page, "Ask again"));
    QTest::mouseClick(offerButton(page, "Ask again"), Qt::LeftButton);
    QVERIFY(behaviorRows(page).contains("slow/idle (asking…)"));
    QTRY_VERIFY_WITH_TIMEOUT(behaviorRows(page).contains("Idle at last"), soon_ms);
    QVERIFY(!offerButton(page, "Ask again"));
}

void tst_WindowPlugins::closingTheWindowWhileItAsksDoesNotWait() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    qputenv("USAR_TEST_SLOW_S", "60");
    auto page = std::make_unique<WindowPage>(WindowSetup{.plugin_folders = {slow}, .settings_folder = settings.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page->hasStartPoses(), soon_ms);
    QCOMPARE(page->window().control().plugins().records().front().state, agent::PluginState::Asked);
    QCOMPARE(hosts().size(), 1);
    QElapsedTimer clock;
    clock.start();
    QVERIFY(page->window().close());
    page.reset();
    QVERIFY2(clock.elapsed() < 30'000, "it has waited for the plugin, which takes a minute");
    QTRY_VERIFY(hosts().isEmpty());
}

void tst_WindowPlugins::aPreviewThatHangsIsToldOfWhileTheWindowGoesOn() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    WindowPage page({.plugin_folders = {slow}, .settings_folder = settings.path()});
    QTRY_COMPARE_WITH_TIMEOUT(behaviorRows(page), QStringList{"Idle at last"}, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.pressKey(Qt::Key_A);
    page.drawArea({{-5, -5}, {5, 5}});
    QTRY_VERIFY_WITH_TIMEOUT(summarized(page, " wide · "), soon_ms);
    QVERIFY(!page.map().content().area.lanes_in_map_m.empty());
    page.pressKey(Qt::Key_A);
    page.drawArea({{-25, -5}, {25, 5}});
    QTRY_VERIFY(summarized(page, "Asking the plugin's process"));
    QVERIFY(page.map().content().area.lanes_in_map_m.empty()); // they were of another area
    QTRY_VERIFY_WITH_TIMEOUT(summarized(page, "did not answer for 1 s while previewing"), soon_ms);
    page.pressKey(Qt::Key_A);
    page.drawArea({{50, 40}, {60, 50}}); // apart from the other one, which would be moved
    QTRY_VERIFY_WITH_TIMEOUT(summarized(page, " wide · "), soon_ms);
    QVERIFY(!page.map().content().area.lanes_in_map_m.empty());
}

void tst_WindowPlugins::aMissionForAPluginThatIsAskedIsSetUpOnceItHasAnswered() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    const QString mission = settings.filePath("slow.json");
    QFile file(mission);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"name": "Slow", "world": "tall_test", "robot": "USARBot.AirRobot", "start": "PlayerStart",
                   "behavior": "slow/idle", "area": {"x": -5, "y": -5, "width": 10, "height": 10},
                   "parameters": {"speed_m_s": 1.5}})");
    file.close();
    qputenv("USAR_TEST_SLOW_S", "2");
    WindowPage page({.plugin_folders = {robots, slow}, .mission_file = mission, .settings_folder = settings.path()});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("Mission Slow is ready").isEmpty(), soon_ms);
    QCOMPARE(page.window().views().behavior->behaviorId(), std::string("slow/idle"));
    QCOMPARE(std::get<double>(page.window().views().parameters->values().at("speed_m_s")), 1.5);
}

void tst_WindowPlugins::whatIsSetUpOutlivesABuildOfAnIsolatedPlugin() {
    const QTemporaryDir settings;
    isolate(settings, "Slow robot");
    const QTemporaryDir folder;
    writeOver(folder.filePath("robot.so"), slow);
    WindowPage page({.plugin_folders = {folder.path()}, .settings_folder = settings.path()});
    QTRY_COMPARE_WITH_TIMEOUT(behaviorRows(page), QStringList{"Idle at last"}, soon_ms);
    QVERIFY(page.typeParameter("speed_m_s", "0.5"));
    qputenv("USAR_TEST_SLOW_S", "0.5");
    writeOver(folder.filePath("robot.so"), slow);
    QTRY_COMPARE_WITH_TIMEOUT(behaviorRows(page), QStringList{"slow/idle (asking…)"}, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("robot.so was built anew").isEmpty(), soon_ms);
    QCOMPARE(behaviorRows(page), QStringList{"Idle at last"});
    QCOMPARE(std::get<double>(page.window().views().parameters->values().at("speed_m_s")), 0.5);
}

USAR_TEST(tst_WindowPlugins)

} // namespace tst_window_plugins

#include "tst_window_plugins.moc"
