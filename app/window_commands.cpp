// Every command of the window, registered once; menus are made from the registry.
#include <QApplication>
#include <QDesktopServices>
#include <QMenuBar>
#include <QUrl>

#include "app/main_window.h"
#include "core/protocol/commands/spawn.h"
#include "widgets/command_palette.h"
#include "widgets/shortcut_sheet.h"

namespace usar::app {

namespace {

const QList<std::pair<QString, QString>> gestures{
    {QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
    {QObject::tr("Click a start pose"), QObject::tr("Choose class, name and behavior first")},
    {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area; its handles change it")},
    {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
    {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
    {QObject::tr("W S, A D, Q E, R F held while you drive"),
     QObject::tr("Forward and back, round, sideways, up and down; Shift slower, Space stops")},
    {QObject::tr("Drag the camera's picture, wheel on it"), QObject::tr("Turn the camera, zoom it")},
    {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
    {QObject::tr("Press an object in the palette, click on the map"), QObject::tr("Put it into the world")},
    {QObject::tr("Drag an object"), QObject::tr("Move it")}};

} // namespace

void MainWindow::registerCommands() {
    registerFileCommands();
    registerMissionCommands();
    registerRobotCommands();
    registerMapCommands();
    registerViewCommands();
    registerLinkCommands();
    registerWorldCommands();
    registerSnapshotCommands();
    registerRobotFileCommand();
    registerTimeCommands();
    registerLayoutCommands();
    registerMessageCommands();
    registerReplayCommands();
    registerFaultCommands();
    registerPlanCommands();
    registerCameraCommands();
    drive_.registerCommands();
    registerTraceCommands();
    registerPluginCommands();
    world_.registerCommands();
    registerRadioCommands();
}

void MainWindow::registerFileCommands() {
    commands_.add({"file.open",
                   tr("Open mission…"),
                   tr("File"),
                   tr("Area, behavior and parameters from a mission file"),
                   "open",
                   {QKeySequence::Open}},
                  [this](bool) { chooseMissionFile(); });
    commands_.add(
        {"file.save",
         tr("Save mission as…"),
         tr("File"),
         tr("Area, behavior and parameters of the selected robot as a mission file"),
         "",
         {QKeySequence::SaveAs}},
        [this](bool) { chooseWhereToSaveMission(); }, [this] { return mayBeSaved(); });
    commands_.add(
        {"file.export",
         tr("Save results now"),
         tr("File"),
         tr("Picture, heights and raw data of the selected robot, at any time"),
         "export",
         {QKeySequence("Ctrl+E")}},
        [this](bool) { control_.exportResults(selected_); }, [this] { return selected_ != 0; });
    commands_.add({"file.folder", tr("Result folder…"), tr("File"), tr("Where results are saved"), "", {}},
                  [this](bool) { chooseResultFolder(); });
    commands_.add({"file.show_folder", tr("Show results"), tr("File"), tr("Opens the result folder"), "", {}},
                  [this](bool) { QDesktopServices::openUrl(QUrl::fromLocalFile(control_.resultFolder())); });
    commands_.add({"file.quit",
                   tr("Quit"),
                   tr("File"),
                   tr("Stops the robots, saves what was scanned, and quits"),
                   "",
                   {QKeySequence("Ctrl+Q")}},
                  [this](bool) { close(); });
}

void MainWindow::registerMissionCommands() {
    const auto running = [this] {
        const Robot* robot = control_.robot(selected_);
        return robot && robot->running();
    };
    commands_.add({"mission.area",
                   tr("Draw mission area"),
                   tr("Mission"),
                   tr("Drag a rectangle on the map"),
                   "area",
                   {QKeySequence("A")},
                   true},
                  [this](bool on) { views_.map->setTool(on ? widgets::MapTool::Area : widgets::MapTool::Pan); });
    commands_.add(
        {"mission.start",
         tr("Start behavior"),
         tr("Mission"),
         tr("With this area and these parameters"),
         "play",
         {QKeySequence("Ctrl+Return")}},
        [this](bool) { start(); },
        [this, running] {
            const Robot* robot = control_.robot(selected_);
            return robot && robot->view().figures.spawned && !running() && !robot->isReplay() &&
                   control_.plugins().behavior(views_.behavior->behaviorId());
        });
    commands_.add(
        {"mission.start_again",
         tr("Start again what broke"),
         tr("Mission"),
         tr("A behavior that threw, hung or died: the same with the same parameters, in a process of its own"),
         "play",
         {QKeySequence("Ctrl+Shift+Return")}},
        [this](bool) { startAgain(brokenRobot()); }, [this] { return brokenRobot() != 0; });
    commands_.add(
        {"mission.pause",
         tr("Pause or resume"),
         tr("Mission"),
         tr("The robot holds its position"),
         "pause",
         {QKeySequence("P")}},
        [this](bool) {
            const Robot* robot = control_.robot(selected_);
            give(robot && robot->view().paused ? agent::Order::Resume : agent::Order::Pause);
        },
        running);
    commands_.add(
        {"mission.land",
         tr("Land now"),
         tr("Mission"),
         tr("Here; what was scanned is kept"),
         "land",
         {QKeySequence("L")}},
        [this](bool) { give(agent::Order::LandNow); }, running);
    commands_.add(
        {"mission.stop",
         tr("Stop this robot"),
         tr("Mission"),
         tr("Ends its behavior with its safe command; what was scanned is kept"),
         "stop",
         {QKeySequence("Ctrl+Backspace")}},
        [this](bool) {
            if (Robot* robot = control_.robot(selected_))
                robot->stop();
        },
        running);
    commands_.add({"mission.stop_all",
                   tr("Stop all robots"),
                   tr("Mission"),
                   tr("At once; Escape twice does the same"),
                   "stop",
                   {QKeySequence("Ctrl+.")}},
                  [this](bool) { control_.stopAll(); });
}

void MainWindow::registerRobotCommands() {
    for (int id = 1; id <= 9; ++id)
        commands_.add(
            {QString("robot.select_%1").arg(id),
             tr("Select robot %1").arg(id),
             tr("Robots"),
             tr("Shows its instruments, sensors and map"),
             "",
             {QKeySequence(QString::number(id))}},
            [this, id](bool) { selectRobot(id); }, [this, id] { return control_.robot(id) != nullptr; });
    commands_.add(
        {"robot.spawn_again",
         tr("Spawn again"),
         tr("Robots"),
         tr("For a robot that did not come, or was lost with its link: same class, name and start pose"),
         "",
         {QKeySequence("Ctrl+R")}},
        [this](bool) { control_.spawnAgain(selected_); },
        [this] {
            const Robot* robot = control_.robot(selected_);
            return robot && !robot->isReplay() && !robot->view().figures.spawned &&
                   robot->view().link.state == link::LinkState::Connected;
        });
    commands_.add(
        {"robot.remove",
         tr("Remove robot"),
         tr("Robots"),
         tr("Saves what it scanned and closes its connection; the server takes it away"),
         "",
         {}},
        [this](bool) { control_.remove(selected_); }, [this] { return selected_ != 0; });
}

void MainWindow::registerMapCommands() {
    commands_.add({"map.fit",
                   tr("Fit mission"),
                   tr("Map"),
                   tr("Shows the area and all that was scanned"),
                   "fit",
                   {QKeySequence("F")}},
                  [this](bool) { views_.map->fit(); });
    commands_.add(
        {"map.fit_world", tr("Fit world"), tr("Map"), tr("Shows the whole world"), "", {QKeySequence("Home")}},
        [this](bool) { views_.map->fitWorld(); });
    commands_.add({"map.follow",
                   tr("Follow robot"),
                   tr("Map"),
                   tr("Keeps the selected robot in the middle"),
                   "follow",
                   {QKeySequence("Shift+F")},
                   true},
                  [this](bool on) { views_.map->setFollowing(on); });
    commands_.add({"map.zoom_in", tr("Zoom in"), tr("Map"), tr("Closer"), "", {QKeySequence::ZoomIn}},
                  [this](bool) { views_.map->zoomIn(); });
    commands_.add({"map.zoom_out", tr("Zoom out"), tr("Map"), tr("Farther away"), "", {QKeySequence::ZoomOut}},
                  [this](bool) { views_.map->zoomOut(); });
}

void MainWindow::registerViewCommands() {
    commands_.add(
        {"view.dark", tr("Dark theme"), tr("View"), tr("Dark or light"), "moon", {QKeySequence("Ctrl+T")}, true},
        [this](bool dark) { setTheme(dark ? widgets::Theme::Dark : widgets::Theme::Light); });
    commands_.add({"view.hint", tr("First steps"), tr("View"), tr("The three-step hint above the map"), "", {}},
                  [this](bool) { views_.hint->show(); });
    auto* palette = new widgets::CommandPalette(commands_, this);
    commands_.add({"view.palette",
                   tr("Command palette"),
                   tr("View"),
                   tr("Any command by a few letters"),
                   "",
                   {QKeySequence("Ctrl+K")}},
                  [palette](bool) { palette->open(); });
    commands_.add({"help.shortcuts",
                   tr("Shortcuts"),
                   tr("Help"),
                   tr("All keys and gestures on one sheet"),
                   "",
                   {QKeySequence("F1")}},
                  [this](bool) {
                      auto* sheet = new widgets::ShortcutSheet(commands_, gestures, this);
                      sheet->setAttribute(Qt::WA_DeleteOnClose);
                      sheet->show();
                  });
}

void MainWindow::makeMenus() {
    const auto fill = [this](QMenu* menu, const char* ids) { commands_.fill(menu, QString(ids).split(' ')); };
    const auto add = [&](const QString& title, const char* ids) {
        QMenu* const menu = menuBar()->addMenu(title);
        fill(menu, ids);
        return menu;
    };
    add(tr("&File"), "file.open file.save - file.record file.open_recording - "
                     "file.export file.folder file.show_folder - file.quit");
    add(tr("&Mission"), "mission.area - mission.start mission.start_again mission.pause mission.land mission.stop - "
                        "mission.stop_all");
    add(tr("&Robots"), "robot.select_1 robot.select_2 robot.select_3 robot.select_4 robot.select_5 robot.select_6 "
                       "robot.select_7 robot.select_8 robot.select_9 - radio.station robot.spawn_again robot.remove - "
                       "drive.take drive.stop drive.faster drive.slower - robot.trace - plugins.rescan");
    QMenu* const server = add(tr("&Server"), "link.connect link.disconnect -");
    fillWorldMenu(server->addMenu(tr("&World of the embedded simulator")));
    fill(server, "simulator.open_robot simulator.save_snapshot simulator.open_snapshot simulator.cancel_opening - "
                 "time.pause time.step time.faster time.slower time.real time.max - "
                 "faults.inject faults.end faults.end_all - link.figures");
    add(tr("&Objects"), "view.dock.world - world.turn_left world.turn_right world.spin - world.waypoints "
                        "world.clear_way world.go world.halt - world.undo world.delete world.delete_all - "
                        "map.wipe_trace");
    add(tr("P&lan"), "plan.open plan.edit plan.new - "
                     "plan.continue plan.halt plan.step_cycle plan.step_epoch plan.run_to - "
                     "plan.back plan.forward plan.live plan.look_back - "
                     "plan.break_before plan.break_after plan.break_result plan.break_verdict plan.break_interruption "
                     "plan.break_key plan.break_edit plan.break_switch plan.break_clear - "
                     "plan.pin plan.drive_off plan.release - plan.report plan.save_picture");
    add(tr("M&essages"), "messages.find messages.command - messages.pause messages.follow messages.details "
                         "messages.cause messages.resend - messages.only_trouble messages.only_type "
                         "messages.hide_type messages.all_robots messages.no_filter - messages.copy "
                         "messages.copy_text messages.copy_json messages.copy_shown messages.save messages.clear");
    add(tr("Re&play"), "replay.play replay.step - replay.back replay.forward replay.begin - "
                       "replay.faster replay.slower - replay.close");
    add(tr("&Camera"), "camera.zoom_in camera.zoom_out camera.zoom_default - camera.left camera.right camera.up "
                       "camera.down camera.center - camera.light - camera.save camera.port");
    QMenu* const view = add(tr("&View"), "map.fit map.fit_world map.follow map.zoom_in map.zoom_out radio.map "
                                         "radio.show - view.operate view.analyse view.debug - view.dark view.hint "
                                         "view.palette -");
    for (const QDockWidget* dock : views_.docks)
        view->addAction(dock->toggleViewAction());
    add(tr("&Help"), "help.shortcuts");
}

} // namespace usar::app
