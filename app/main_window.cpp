#include "app/main_window.h"

#include <cmath>
#include <utility>

#include <QApplication>
#include <QScreen>

#include "app/locations.h"
#include "widgets/escape_twice.h"
#include "widgets/models/figures.h"
#include "widgets/own_keys.h"
#include "widgets/theme.h"

namespace usar::app {

namespace {

widgets::ConnectionStatus barStatus(const link::LinkStatus& status, const QString& where) {
    using widgets::ConnectionState;
    static const std::map<link::LinkState, ConnectionState> states{
        {link::LinkState::Disconnected, ConnectionState::Disconnected},
        {link::LinkState::Connecting, ConnectionState::Connecting},
        {link::LinkState::Connected, ConnectionState::Connected},
        {link::LinkState::Waiting, ConnectionState::Waiting}};
    return {states.at(status.state), where, status.trouble, status.retry_in};
}

} // namespace

MainWindow::MainWindow(const Options& options, QWidget* parent)
    : QMainWindow(parent)
    , options_(options)
    , commands_(this)
    , views_(makeViews(*this))
    , presenter_(control_, views_)
    , camera_(std::make_unique<CameraDesk>(control_, *views_.camera))
    , radio_(control_, views_) {
    const QStringList plugin_folders = options.plugin_folders.isEmpty() ? pluginFolders() : options.plugin_folders;
    loadPlugins(plugin_folders);
    control_.setResultFolder(options.result_folder);
    views_.hint->setSteps(widgets::HintStrip::firstSteps());
    views_.spawn_card->setRobots(control_.plugins().kinds());
    registerCommands();
    makeMenus();
    wireControl();
    wireRobots();
    wireBars();
    wireMap();
    wirePanels();
    wireMission();
    wireMessages();
    wireReplay();
    wireLoading();
    wireFaults();
    wirePlan();
    wireCamera();
    wireDrive();
    wireObjects();
    new widgets::OwnKeys(this);
    wirePlugins();
    layout()->invalidate(); // or the least size would be that of all docks side by side, before they became tabs
    layout()->activate();
    constexpr int frame_px = 40; // title bar and borders, which the size does not count
    resize(QSize(1280, 800).boundedTo(screen()->availableSize() - QSize(0, frame_px)));
    first_layout_ = saveState(layout_version);
    restoreSettings();
    selectRobot(0);
    showTitle();
    tellPlugins(plugin_folders);
}

MainWindow::~MainWindow() = default;

void MainWindow::begin() {
    const ServerTarget& server = options_.server;
    if (!options_.recording.isEmpty()) {
        views_.time->setSteerable(false); // until a simulator is connected to
        return openRecording(options_.recording);
    }
    views_.connection->setServer(server.embedded ? widgets::ServerChoice::Embedded : widgets::ServerChoice::Real);
    if (!server.embedded)
        views_.connection->setAddress(server.host, server.port);
    connectTo(views_.connection->server(), server.host, server.port);
    if (!options_.mission_file.isEmpty())
        openFile(options_.mission_file);
}

void MainWindow::wireControl() {
    connect(&control_, &MissionControl::linkChanged, this, [this](const link::LinkStatus& status) {
        link_state_ = status.state;
        views_.connection->setStatus(barStatus(status, control_.level()));
        if (status.state != link::LinkState::Connected)
            views_.connection->setRate(std::nullopt);
        followConnection();
        showFaultChoices();
        commands_.refresh();
    });
    connect(&control_, &MissionControl::worldKnown, this, &MainWindow::showWorld);
    connect(&control_, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses& poses, const QString& level) {
                start_poses_ = poses.poses;
                views_.map->setStartPoses(poses.poses);
                views_.connection->setStatus({widgets::ConnectionState::Connected, level, {}, Seconds{0.0}});
                commands_.refresh();
                if (awaiting_world_ && awaiting_world_->world == level.toStdString())
                    setUp(*std::exchange(awaiting_world_, std::nullopt));
            });
    connect(&control_.simulator(), &SimulatorHost::figuresChanged, this, [this](const link::SimulatorFigures& figures) {
        views_.time->setRealTimeFactor(figures.real_time_factor);
        server_now_ = figures.now;
        showClock();
    });
}

void MainWindow::wireRobots() {
    connect(&control_, &MissionControl::robotAdded, this, [this](int id) {
        presenter_.showRow(id);
        selectRobot(id);
        showFaultChoices();
        if (!control_.robot(id)->isReplay())
            views_.hint->setDone(0, true);
    });
    connect(&control_, &MissionControl::robotRemoved, this, [this](int id, const QString& name, int instead) {
        views_.robots->removeRobot(id);
        if (offers_.contains(missionKey(id)))
            control_.cure(missionKey(id));
        presenter_.remove(name);
        drafts_.erase(id);
        showFaultChoices();
        if (id == selected_)
            selectRobot(instead);
    });
    connect(&control_, &MissionControl::robotLinkChanged, this, [this](int id) {
        presenter_.showRow(id);
        if (id == selected_)
            presenter_.showLinkState(id);
        drive_.refresh();
        followConnection();
        commands_.refresh();
    });
    connect(&control_, &MissionControl::linkUpdated, this,
            [this](const auto& update) { presenter_.showLink(control_.connectionOf(0), *update, selected_ == 0); });
    connect(&control_, &MissionControl::robotUpdated, this,
            [this](int id, const auto& update) { showRobot(id, *update); });
}

void MainWindow::showRobot(int id, const mission::SessionUpdate& update) {
    presenter_.show(id, update, id == selected_);
    plan_.take(id, update);
    drive_.take(id, update);
    if (id != selected_)
        return;
    views_.connection->setRate(update.figures.replay ? std::nullopt : std::optional(update.figures.lines_per_second));
    showClock();
    if (update.task && views_.map->area() != update.task->area_in_map) {
        views_.behavior->setArea(update.task->area_in_map);
        views_.map->setArea(update.task->area_in_map);
        views_.map->fit();
    }
    showReplay();
    showTrace();
    refreshRunState();
    showTitle();
}

void MainWindow::showClock() {
    const auto timed = [](const Robot* robot) { return robot && robot->view().figures.now.count() > 0.0; };
    const Robot* const shown = control_.robot(selected_);
    if (shown && (shown->isReplay() || timed(shown)))
        return views_.time->setClock(shown->view().figures.now);
    if (server_now_)
        return views_.time->setClock(*server_now_);
    for (const Robot* robot : control_.robots()) // a base station hears no time; robots on its server do
        if (!robot->isReplay() && timed(robot))
            return views_.time->setClock(robot->view().figures.now);
}

void MainWindow::wireDrive() {
    connect(&drive_, &DriveDesk::changed, &commands_, &widgets::CommandRegistry::refresh);
    connect(&drive_, &DriveDesk::realTimeWanted, this, [this] {
        if (views_.time->speed() > 1.0)
            setSpeed(1.0);
    });
    const auto openDock = [this] {
        auto* const dock = findChild<QDockWidget*>("drive");
        dock->show();
        dock->raise();
    };
    connect(views_.driver, &widgets::ControlBadge::clicked, this, openDock);
    connect(&drive_.gamepad(), &Gamepad::plugged, this, [this](const QString& name) {
        views_.notifications->push("gamepad", Severity::Note, tr("The gamepad %1 is plugged in.").arg(name), true);
    });
}

void MainWindow::wireMission() {
    connect(&control_, &MissionControl::behaviorFinished, this, [this](int id, bool, const QString&) {
        presenter_.showRow(id);
        refreshRunState();
        showTitle();
        returnToRealTime();
    });
    connect(&control_, &MissionControl::behaviorBroke, this, &MainWindow::offerToStartAgain);
    connect(views_.notifications->model(), &widgets::NotificationModel::offerTaken, this, [this](const QString& key) {
        if (const auto offered = offers_.find(key); offered != offers_.end())
            std::function<void()>(offered->second)(); // a copy: it may cure what it was offered for
    });
    connect(views_.notifications->model(), &widgets::NotificationModel::cured, this,
            [this](const QString& key) { offers_.erase(key); });
    connect(&control_, &MissionControl::resultsWritten, this, [this](int, const QStringList& files) {
        views_.notifications->push("saved", Severity::Note,
                                   tr("Saved %n file(s): %1", "", static_cast<int>(files.size())).arg(files.value(0)),
                                   true);
    });
    connect(&control_, &MissionControl::exportFailed, this,
            [this](int, const QString& reason) { exportFailed(reason); });
    connect(&control_, &MissionControl::noticed, this, [this](const QString& key, const mission::Notice& notice) {
        say(notice.severity, key, QString::fromStdString(notice.text));
    });
    connect(&control_, &MissionControl::cured, views_.notifications, &widgets::NotificationCenter::cured);
    connect(views_.notifications, &widgets::NotificationCenter::unreadChanged, this, [this](int unread) {
        views_.notifications_dock->setWindowTitle(unread ? tr("Notifications (%1)").arg(unread) : tr("Notifications"));
    });
    connect(views_.toasts, &widgets::ToastStack::openRequested, this, [this] {
        views_.notifications_dock->show();
        views_.notifications_dock->raise();
    });
    connect(&control_, &MissionControl::readyToClose, this, [this] {
        may_close_ = true;
        close();
    });
    auto* escape = new widgets::EscapeTwice(this);
    connect(escape, &widgets::EscapeTwice::pressedTwice, &control_, &MissionControl::stopAll);
}

void MainWindow::wireBars() {
    connect(views_.connection, &widgets::ConnectionBar::connectRequested, this, &MainWindow::connectTo);
    connect(views_.connection, &widgets::ConnectionBar::disconnectRequested, this, &MainWindow::disconnectFromServer);
    connect(views_.time, &widgets::TimeBar::pauseRequested, this, &MainWindow::pauseTime);
    connect(views_.time, &widgets::TimeBar::stepRequested, this, &MainWindow::stepTime);
    connect(views_.time, &widgets::TimeBar::speedRequested, this, &MainWindow::setSpeed);
    connect(views_.stop_all, &QPushButton::clicked, &control_, &MissionControl::stopAll);
    connect(views_.hint, &widgets::HintStrip::dismissed, this, [this] { views_.hint->hide(); });
}

void MainWindow::wireMap() {
    connect(views_.map, &widgets::MapView::spawnRequested, this,
            [this](int pose) { spawn(views_.spawn_card->lastChoice(pose, control_.nextRobotName())); });
    connect(views_.map, &widgets::MapView::startPoseClicked, this, [this](int pose, const QPoint& at) {
        const auto& start = start_poses_[static_cast<std::size_t>(pose)];
        views_.spawn_card->openFor(pose, QString::fromStdString(start.name), control_.nextRobotName(), at);
    });
    connect(views_.spawn_card, &widgets::SpawnCard::spawnRequested, this, &MainWindow::spawn);
    connect(views_.map, &widgets::MapView::areaEdited, this, [this](const Rectangle& area) {
        views_.behavior->setArea(area);
        showPlan();
    });
    connect(views_.map, &widgets::MapView::areaChanged, this, [this](const Rectangle& area) {
        views_.behavior->setArea(area);
        views_.map->setTool(widgets::MapTool::Pan);
        views_.notifications->cured("area");
        showPlan();
    });
    connect(views_.map, &widgets::MapView::areaRefused, this,
            [this](const QString& reason) { say(Severity::Warning, "area", reason); });
    connect(views_.map, &widgets::MapView::toolChanged, this, [this](widgets::MapTool tool) {
        const bool drawing = tool == widgets::MapTool::Area;
        views_.behavior->setAreaToolActive(drawing);
        commands_.action("mission.area")->setChecked(drawing);
    });
    connect(views_.map, &widgets::MapView::robotClicked, this, [this](const QString& name) {
        for (const Robot* robot : control_.robots())
            if (name == QString::fromStdString(robot->view().spawn.robot_name))
                selectRobot(robot->view().id);
    });
    connect(views_.map, &widgets::MapView::followingChanged, commands_.action("map.follow"), &QAction::setChecked);
    connect(views_.layers, &widgets::LayersPanel::layerChanged, views_.map, &widgets::MapView::setLayer);
}

void MainWindow::wirePanels() {
    connect(views_.robots, &widgets::RobotList::robotSelected, this, &MainWindow::selectRobot);
    connect(views_.robots, &widgets::RobotList::removeRequested, &control_, &MissionControl::remove);
    connect(views_.behavior, &widgets::BehaviorPanel::behaviorChosen, this, &MainWindow::showChosenBehavior);
    connect(views_.behavior, &widgets::BehaviorPanel::areaTyped, this, [this](const Rectangle& area) {
        views_.map->setArea(area.empty() ? std::nullopt : std::optional(area));
        showPlan();
    });
    connect(views_.behavior, &widgets::BehaviorPanel::areaToolToggled, this,
            [this](bool active) { views_.map->setTool(active ? widgets::MapTool::Area : widgets::MapTool::Pan); });
    views_.behavior->setActions(commands_.action("mission.start"), commands_.action("mission.pause"),
                                commands_.action("mission.land"), commands_.action("mission.stop"));
    connect(views_.parameters, &widgets::ParameterForm::changed, this, &MainWindow::applyParameters);
    connect(views_.sensors, &widgets::SensorPanel::plotRequested, views_.plots, &widgets::PlotView::addSeries);
    connect(views_.plots, &widgets::PlotView::failed, this,
            [this](const QString& reason) { say(Severity::Error, "plot", reason); });
}

} // namespace usar::app
