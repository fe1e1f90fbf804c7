// What a person does from the menus and the palette: server, time, layouts, missions on the disk.
#include <algorithm>
#include <cmath>
#include <map>

#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QMenuBar>
#include <QRegularExpression>
#include <QScreen>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "tests/doubles/test_files.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_commands {

using namespace usar;

namespace {

void run(WindowPage& page, const QString& command) {
    QAction* action = page.window().commands().action(command);
    QVERIFY2(action->isEnabled(), qPrintable(command));
    action->trigger();
}

bool enabled(WindowPage& page, const QString& command) {
    return page.window().commands().action(command)->isEnabled();
}

} // namespace

class tst_WindowCommands : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void noTwoCommandsShareAKey();
    void theServerIsLeftAndJoinedByCommand();
    void timeIsPausedSteppedAndRunByCommand();
    void speedIsChangedByCommand();
    void withoutARobotTheClockDoesNotRunAway();
    void builtInLayoutsPutTheirDockFirst();
    void aDockIsHiddenAndShownByCommand();
    void aDockBehindATabIsRaisedByItsCommand();
    void thePaletteOffersRobotsPosesWorldsAndMissions();
    void aFirstStartFitsASmallScreen();
    void onASmallScreenTimeCanBeSteered();
    void theWindowIsFoundAsItWasLeft();
    void aSavedMissionIsOpenedAgain_data();
    void aSavedMissionIsOpenedAgain();
    void anUnwritableMissionFileIsNamed();
    void cellsOfAMissionAreThoseOfTheMap();
};

/// A key that two actions have runs neither. Letters with Alt alone open the menus.
void tst_WindowCommands::noTwoCommandsShareAKey() {
    WindowPage page;
    std::map<QKeySequence, QString> owners;
    for (const QAction* menu : page.window().menuBar()->actions())
        owners[QKeySequence::mnemonic(menu->text())] = menu->text();
    for (const auto& command : page.window().commands().commands())
        for (const QKeySequence& keys : command->action->shortcuts()) {
            QVERIFY2(!owners.contains(keys),
                     qPrintable(keys.toString() + ": " + command->spec.id + " and " + owners[keys]));
            owners[keys] = command->spec.id;
        }
    QVERIFY(owners.size() > 40);
}

void tst_WindowCommands::theServerIsLeftAndJoinedByCommand() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(!enabled(page, "link.connect"));
    run(page, "link.disconnect");
    QTRY_VERIFY_WITH_TIMEOUT(enabled(page, "link.connect"), soon_ms);
    QVERIFY(!enabled(page, "link.disconnect"));
    QVERIFY(!enabled(page, "time.pause"));
    QVERIFY(page.window().views().connection->rateText().isEmpty()); // Nothing that was measured before stays.
    run(page, "link.connect");
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
}

void tst_WindowCommands::timeIsPausedSteppedAndRunByCommand() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(!enabled(page, "time.step"));
    run(page, "time.pause");
    Seconds stood{0.0};
    const auto stands = [&] { // for three states' time, in which lines that were already sent arrive
        stood = page.robot(1)->figures.now;
        const test::Beats states(200);
        return test::holdsUntil([&] { return page.robot(1)->figures.now == stood; },
                                [&] { return states.count() >= 3; });
    };
    QTRY_VERIFY_WITH_TIMEOUT(stands(), soon_ms);
    const Seconds before = stood;
    run(page, "time.step");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > before, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(stands(), soon_ms);
    QVERIFY(stood < before + Seconds(0.25));
    run(page, "time.pause");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > stood + Seconds(1.0), soon_ms);
}

void tst_WindowCommands::speedIsChangedByCommand() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const auto* time = page.window().views().time;
    run(page, "time.faster");
    QCOMPARE(time->speed(), 2.0);
    run(page, "time.slower");
    run(page, "time.slower");
    QCOMPARE(time->speed(), 0.5);
    run(page, "time.max");
    QVERIFY(std::isinf(time->speed()));
    run(page, "time.real");
    QCOMPARE(time->speed(), 1.0);
}

void tst_WindowCommands::withoutARobotTheClockDoesNotRunAway() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QSignalSpy figures(&page.window().control().simulator(), &server::SimulatorHost::figuresChanged);
    run(page, "time.max");
    const auto now = [&] { return figures.last().front().value<server::SimulatorFigures>().now; };
    QTRY_VERIFY_WITH_TIMEOUT(!figures.isEmpty(), soon_ms);
    const Seconds before = now();
    QElapsedTimer since;
    since.start();
    QTRY_VERIFY_WITH_TIMEOUT(now() > before + Seconds(1.0), soon_ms);
    QVERIFY2(now() - before < Seconds(2.0 + 1e-3 * double(since.elapsed())), "at most real time, and one report late");
    QVERIFY(page.window().views().time->limited());
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(!page.window().views().time->limited());
    QVERIFY(std::isinf(page.window().views().time->speed()));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > before + Seconds(60.0), soon_ms);
}

void tst_WindowCommands::builtInLayoutsPutTheirDockFirst() {
    WindowPage page;
    const auto* messages = page.window().findChild<QDockWidget*>("messages");
    const auto* plots = page.window().findChild<QDockWidget*>("plots");
    run(page, "view.debug");
    QTRY_VERIFY(!messages->visibleRegion().isEmpty());
    QTRY_VERIFY2(messages->height() > page.map().height(), qPrintable(QString::number(messages->height())));
    run(page, "view.analyse");
    QTRY_VERIFY(!plots->visibleRegion().isEmpty());
    run(page, "view.operate");
    QTRY_VERIFY(page.map().height() > plots->height());
}

void tst_WindowCommands::aDockIsHiddenAndShownByCommand() {
    WindowPage page;
    const auto* layers = page.window().findChild<QDockWidget*>("layers");
    QVERIFY(layers->isHidden());
    run(page, "view.dock.layers");
    QTRY_VERIFY(layers->isVisible());
    run(page, "view.dock.layers");
    QTRY_VERIFY(layers->isHidden());
}

/// Defect D15 of the review: the command of a dock that lay behind another tab took it away.
void tst_WindowCommands::aDockBehindATabIsRaisedByItsCommand() {
    WindowPage page;
    int raised = 0;
    for (QDockWidget* const dock : page.window().views().docks) {
        const QList<QDockWidget*> mates = page.window().tabifiedDockWidgets(dock);
        const auto front = std::ranges::find_if(mates, [](const QDockWidget* mate) { return !mate->isHidden(); });
        if (dock->isHidden() || front == mates.end())
            continue;
        (*front)->raise();
        QTRY_VERIFY2(dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
        const QString command = "view.dock." + dock->objectName();
        run(page, command);
        QTRY_VERIFY2(!dock->visibleRegion().isEmpty(), qPrintable(dock->objectName()));
        QTRY_VERIFY2(page.window().commands().action(command)->isChecked(), qPrintable(dock->objectName()));
        QVERIFY2(!(*front)->isHidden(), qPrintable((*front)->objectName()));
        ++raised;
    }
    QVERIFY2(raised >= 5, qPrintable(QString::number(raised)));
}

void tst_WindowCommands::thePaletteOffersRobotsPosesWorldsAndMissions() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    widgets::CommandListModel model(page.window().commands());
    const auto first = [&](const QString& typed) {
        model.setFilter({});
        model.setFilter(typed);
        return model.index(0);
    };
    QCOMPARE(first("select R1").data().toString(), QString("Select R1"));
    QCOMPARE(first("spawn PlayerStart").data().toString(), QString("Spawn a robot at PlayerStart"));
    QCOMPARE(first("world tall").data().toString(), QString("Open world Tall test"));
    QCOMPARE(first("mission quick").data().toString(), QString("Open mission quick scan"));
    QCOMPARE(first("camera show").data().toString(), QString("Show Camera"));
    for (int i = 0; i < 2; ++i)
        model.run(first("camera show"));
    QVERIFY(page.window().findChild<QDockWidget*>("camera")->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(first("plot INS").isValid(), soon_ms);
    model.run(first("spawn FarCorner"));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(2), soon_ms);
    model.run(first("select R1"));
    QCOMPARE(page.window().selectedRobot().value, 1);
}

/// 1024 x 700 with a desktop's frame around it.
void tst_WindowCommands::aFirstStartFitsASmallScreen() {
    const QTemporaryDir nothing;
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, nothing.path());
    app::MainWindow window{app::Options{}};
    const QSize least = window.minimumSizeHint();
    const QSize asked = QSize(1280, 800).boundedTo(window.screen()->availableSize()).expandedTo(least);
    QVERIFY2(window.width() <= asked.width(), qPrintable(QString::number(window.width())));
    QVERIFY2(least.width() <= 1020 && least.height() <= 665,
             qPrintable(QString("%1 x %2").arg(least.width()).arg(least.height())));
    window.resize(least);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    for (const QWidget* sight :
         {static_cast<QWidget*>(window.views().stop_all), static_cast<QWidget*>(window.views().driver)}) {
        const QRect there(sight->mapTo(&window, QPoint(0, 0)), sight->size());
        QVERIFY(sight->isVisible() && window.rect().contains(there));
    }
}

void tst_WindowCommands::onASmallScreenTimeCanBeSteered() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const widgets::WindowViews& views = page.window().views();
    page.window().resize(1024, 690);
    for (QWidget* sight : {static_cast<QWidget*>(views.time), static_cast<QWidget*>(views.record),
                           static_cast<QWidget*>(views.driver), static_cast<QWidget*>(views.stop_all)})
        QTRY_VERIFY2(sight->isVisible() && page.window().rect().contains(
                                               QRect(sight->mapTo(&page.window(), QPoint(0, 0)), sight->size())),
                     qPrintable(sight->accessibleName()));
    QVERIFY(views.driver->width() >= views.driver->sizeHint().width()); // in words
    auto* const button = views.connection->findChild<QPushButton*>();
    QCOMPARE(button->accessibleName(), QString("Disconnect")); // there is no room for the word
    QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY(views.connection->findChild<QComboBox*>()->isVisible());
}

void tst_WindowCommands::theWindowIsFoundAsItWasLeft() {
    const QTemporaryDir settings;
    const WindowSetup setup{.settings_folder = settings.path()};
    {
        WindowPage page(setup);
        QVERIFY(!page.window().views().hint->isHidden());
        run(page, "view.dock.layers");
        run(page, "view.dock.robots");
        run(page, "view.dark");
        page.window().views().connection->setAddress("robots.example", 3001);
        page.window().quit();
        QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    }
    WindowPage page(setup);
    QVERIFY(page.window().findChild<QDockWidget*>("layers")->isVisible());
    QVERIFY(page.window().findChild<QDockWidget*>("robots")->isHidden());
    QVERIFY(!page.window().commands().action("view.dark")->isChecked());
    QCOMPARE(page.window().views().connection->host(), QString("robots.example"));
    QCOMPARE(page.window().views().connection->port(), 3001);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms); // of the embedded world all the same
    run(page, "view.operate");
    QVERIFY(page.window().findChild<QDockWidget*>("robots")->isVisible());
}

void tst_WindowCommands::aSavedMissionIsOpenedAgain_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("as any JSON") << "north field.json";
    QTest::newRow("as a desktop knows it") << "north field.mission.json";
}

void tst_WindowCommands::aSavedMissionIsOpenedAgain() {
    QFETCH(QString, name);
    const Rectangle area{{-20, -15}, {20, 15}};
    const QTemporaryDir folder;
    const QString file = folder.filePath(name);
    {
        WindowPage page;
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QVERIFY(!enabled(page, "file.save"));
        page.window().mission().saveMission(file);
        QVERIFY(!page.notified("no mission area").isEmpty());
        page.typeArea(area);
        QVERIFY(enabled(page, "file.save"));
        page.window().mission().saveMission(file);
        QVERIFY(!page.notified(name).isEmpty());
    }
    WindowPage page({.mission_file = file});
    QTRY_VERIFY_WITH_TIMEOUT(page.map().area().has_value(), soon_ms);
    QVERIFY(page.map().area()->min_m.isApprox(area.min_m) && page.map().area()->max_m.isApprox(area.max_m));
    QVERIFY(!page.notified("north field is ready").isEmpty());
}

void tst_WindowCommands::anUnwritableMissionFileIsNamed() {
    const QTemporaryDir folder;
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.typeArea({{-20, -15}, {20, 15}});
    page.window().mission().saveMission(folder.filePath("nowhere/field.json"));
    QVERIFY(!page.notified("nowhere/field.json").isEmpty());
}

void tst_WindowCommands::cellsOfAMissionAreThoseOfTheMap() {
    const QTemporaryDir folder;
    const QString file = folder.filePath("coarse.json");
    doubles::writeAll(file.toStdString(), R"({"name": "coarse", "cell_size_m": 0.5,
        "area": {"x": -20, "y": -15, "width": 40, "height": 30}})");
    WindowPage page({.mission_file = file});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    QCOMPARE(page.robot(1)->cell_size_m, 0.5);
    run(page, "mission.stop");
    QTRY_VERIFY_WITH_TIMEOUT(!QDir(page.resultFolder()).entryList({"*.hdr"}).isEmpty(), soon_ms);
    QFile header(QDir(page.resultFolder()).filePath(QDir(page.resultFolder()).entryList({"*.hdr"}).front()));
    QVERIFY(header.open(QIODevice::ReadOnly));
    QVERIFY(QString(header.readAll()).contains(QRegularExpression("XDIM\\s+0\\.5\\b")));
}

USAR_TEST(tst_WindowCommands)

} // namespace tst_window_commands

#include "tst_window_commands.moc"
