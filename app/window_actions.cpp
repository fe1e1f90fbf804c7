// What MainWindow does when it is asked: each action is a few lines that ask MissionControl and tell the views.
#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "app/locations.h"
#include "app/main_window.h"
#include "app/simulator_files.h"
#include "core/mission/mission_writer.h"
#include "core/protocol/commands/spawn.h"
#include "widgets/models/figures.h"

namespace usar::app {

void MainWindow::connectTo(widgets::ServerChoice choice, const QString& host, quint16 port) {
    ServerTarget target = options_.server;
    target.embedded = choice == widgets::ServerChoice::Embedded;
    if (!target.embedded) {
        target.host = host;
        target.port = port;
    }
    cancelLoading();
    views_.map->clear();
    views_.behavior->setArea(std::nullopt);
    views_.behavior->clearAreaLimits(); // until the world is known; a real server's never is
    for (auto& [id, draft] : drafts_)
        draft.area_in_map.reset(); // of another world
    start_poses_.clear();
    server_now_.reset();
    views_.spawn_card->setRobots(control_.plugins().kinds());
    views_.time->setSteerable(target.embedded);
    control_.connectTo(target);
    if (control_.robot(selected_)) // a replay stays, and its map has gone with the old world's
        selectRobot(selected_);
}

void MainWindow::disconnectFromServer() {
    cancelLoading();
    control_.disconnectFromServer();
}

void MainWindow::showWorld(const WorldPicture& world) {
    world_picture_ = world;
    views_.map->setWorld(world.extent_in_map, world.name);
    views_.map->setBackground(world.relief, world.extent_in_map);
    views_.behavior->setAreaLimits(world.extent_in_map);
    views_.map->fitWorld();
    views_.spawn_card->setRobots(robotsToSpawn(world.robot_classes));
    views_.time->setSpeed(1.0);
    views_.time->setPaused(false);
    views_.sensors->setPaused(false);
    showFaultChoices();
    world_.setPaused(false);
    commands_.refresh();
}

/// What plugins can drive, and then what the embedded simulator has besides: those are driven by commands alone.
std::vector<agent::RobotDescription> MainWindow::robotsToSpawn(const QStringList& classes) const {
    std::vector<agent::RobotDescription> robots = control_.plugins().kinds();
    for (const QString& name : classes) {
        const std::string class_name = "USARBot." + name.toStdString();
        const bool known = std::ranges::any_of(
            robots, [&](const agent::RobotDescription& robot) { return robot.class_name == class_name; });
        if (!known)
            robots.push_back({class_name, name.toStdString(), {}, {}});
    }
    return robots;
}

void MainWindow::spawn(const widgets::SpawnChoice& choice) {
    if (choice.start_pose < 0 || choice.start_pose >= static_cast<int>(start_poses_.size()))
        return;
    const protocol::StartPose& pose = start_poses_[static_cast<std::size_t>(choice.start_pose)];
    const auto id =
        control_.spawn({choice.class_name.toStdString(), choice.robot_name.toStdString(), pose.pose_in_map});
    if (!id)
        return complain("spawn", id.error());
    if (!choice.behavior_id.isEmpty())
        views_.behavior->chooseBehavior(choice.behavior_id.toStdString());
}

/// A robot's settings go with it: a new robot takes over what was set up before it came. The forms of a behavior whose
/// plugin is being asked are empty, and what was in them is kept.
void MainWindow::keepDraft() {
    const std::string id = views_.behavior->behaviorId();
    TaskDraft& draft = drafts_[selected_];
    const bool keep_forms = forms_wait_ && draft.behavior_id == id;
    draft = {id,
             keep_forms ? draft.plan_path : views_.behavior->plan().path(),
             views_.map->area(),
             keep_forms ? draft.values : views_.parameters->values(),
             cell_size_m_,
             mission_faults_};
}

void MainWindow::showDraft() {
    const auto draft = drafts_.find(selected_);
    if (draft == drafts_.end())
        return keepDraft();
    const TaskDraft shown = draft->second;
    views_.behavior->chooseBehavior(shown.behavior_id);
    if (views_.behavior->behaviorId() == shown.behavior_id) {
        views_.parameters->setValues(shown.values);
        views_.behavior->plan().choose(shown.plan_path);
    }
    views_.behavior->setArea(shown.area_in_map);
    views_.map->setArea(shown.area_in_map);
    cell_size_m_ = shown.cell_size_m;
    mission_faults_ = shown.faults;
}

void MainWindow::selectRobot(int id) {
    keepDraft();
    selected_ = control_.robot(id) ? id : 0;
    const Robot* robot = control_.robot(selected_);
    const auto known = control_.plugins().kinds();
    const auto described = std::ranges::find_if(known, [&](const agent::RobotDescription& description) {
        const std::string& wanted = robot ? robot->view().spawn.class_name : next_class_;
        return wanted.empty() || description.class_name == wanted;
    });
    views_.behavior->setBehaviors(described == known.end() ? std::vector<agent::BehaviorDescription>()
                                                           : described->behaviors);
    showDraft();
    presenter_.select(selected_);
    plan_.select(selected_);
    workshop_.follow(selected_);
    camera_->select(selected_);
    drive_.select(selected_);
    followConnection();
    views_.robots->selectRobot(selected_);
    refreshRunState();
    showReplay();
    showTrace();
    showPlan();
    showTitle();
    commands_.refresh();
}

void MainWindow::showPlan() {
    commands_.refresh();
    control_.forgetPreview();
    preview_due_.stop();
    const Rectangle area = views_.behavior->area();
    const Robot* robot = control_.robot(selected_);
    if (robot && (robot->running() || robot->isReplay()))
        return; // then the behavior itself says what it flies
    views_.hint->setDone(1, !area.empty());
    if (area.empty() || !views_.behavior->needsArea() || views_.behavior->behaviorId().empty()) {
        views_.map->setLanes(std::vector<Vec2>{});
        views_.map->setAreaSummary({});
        return views_.behavior->setPlanSummary({}); // the area form says what to do
    }
    preview_due_.start();
    control_.preview(selected_, views_.behavior->behaviorId(), area, views_.parameters->values(),
                     [this](const auto& preview) { showPreview(preview); });
}

void MainWindow::showPreview(const Result<agent::TaskPreview>& preview) {
    preview_due_.stop();
    if (!preview) {
        views_.map->setLanes(std::vector<Vec2>{});
        return views_.behavior->setPlanSummary(QString::fromStdString(preview.error().text()));
    }
    const QString summary = tr("%1 · %2 m · %3")
                                .arg(QString::fromStdString(preview->summary), widgets::figure(preview->length_m, 0),
                                     widgets::durationText(preview->duration));
    views_.map->setLanes(preview->path_in_map_m);
    views_.map->setAreaSummary(summary);
    views_.behavior->setPlanSummary(summary);
}

void MainWindow::start() {
    if (Robot* robot = control_.robot(selected_); robot && robot->setCellSize(cell_size_m_))
        views_.map->clearHeights(cell_size_m_);
    const auto started = control_.startBehavior(selected_, views_.behavior->behaviorId(), views_.behavior->area(),
                                                views_.parameters->values(), views_.behavior->plan().path(),
                                                views_.behavior->isolated());
    if (!started)
        return complain("start", started.error());
    control_.forgetPreview(); // the behavior itself says what it flies now
    preview_due_.stop();
    begun(selected_);
    beginMissionFaults();
    views_.hint->setDone(2, true);
    views_.map->setAreaSummary({}); // a plan's figures; the behavior says its own now
    views_.map->fit();
    refreshRunState();
}

void MainWindow::begun(int id) {
    control_.cure("start");
    if (offers_.contains(missionKey(id)))
        control_.cure(missionKey(id));
    plan_.begin(id);
}

void MainWindow::give(agent::Order order) {
    if (Robot* robot = control_.robot(selected_))
        robot->order(order);
    refreshRunState();
}

void MainWindow::refreshRunState() {
    using widgets::RunState;
    const Robot* robot = control_.robot(selected_);
    RunState state = RunState::NoRobot;
    if (robot && robot->running())
        state = robot->view().paused ? RunState::Paused : RunState::Running;
    else if (robot && robot->isReplay())
        state = RunState::Replay;
    else if (robot && robot->view().figures.spawned)
        state = RunState::Ready;
    const QString name = robot ? QString::fromStdString(robot->view().spawn.robot_name) : QString();
    if (!views_.behavior->setRunState(state, name))
        return;
    commands_.refresh();
    workshop_.follow(selected_);
}

void MainWindow::applyParameters() {
    if (Robot* robot = control_.robot(selected_); robot && robot->running()) {
        const auto* behavior = control_.plugins().behavior(robot->view().behavior_id);
        if (!behavior)
            return;
        const auto parameters = agent::ParameterSet::make(behavior->parameters, views_.parameters->values());
        if (!parameters)
            return complain("parameters", parameters.error());
        robot->setParameters(*parameters);
        return;
    }
    showPlan();
}

void MainWindow::pauseTime(bool paused) {
    held_by_plan_ = false;
    if (!paused)
        plan_.goOn(); // or it would hold its server's time
    views_.time->setPaused(paused);
    views_.sensors->setPaused(paused);
    world_.setPaused(paused);
    if (paused)
        control_.setPace(link::Pace::Paused, 1.0);
    else
        setSpeed(views_.time->speed());
    commands_.refresh();
}

void MainWindow::holdTime(bool hold) {
    if (!control_.simulator().running())
        return;
    if (hold && !views_.time->paused()) {
        pauseTime(true);
        held_by_plan_ = true;
    } else if (!hold && held_by_plan_) {
        pauseTime(false);
    } else if (views_.time->paused()) {
        control_.setPace(link::Pace::Paused, 1.0); // a step is over
    }
}

/// A plan that stands still decides once more.
void MainWindow::stepTime() {
    if (plan_.anyHalted())
        plan_.stepCycle();
    else
        control_.simulator().stepOnce();
}

void MainWindow::setSpeed(double speed) {
    views_.time->setSpeed(speed);
    if (!views_.time->paused())
        control_.setPace(std::isinf(speed) ? link::Pace::Fast : link::Pace::Factor, speed);
}

void MainWindow::returnToRealTime() {
    for (const Robot* robot : control_.robots())
        if (robot->running())
            return;
    if (views_.time->speed() <= 1.0 || views_.time->paused())
        return;
    setSpeed(1.0);
}

void MainWindow::showTitle() {
    const Robot* robot = control_.robot(selected_);
    QString title = QApplication::applicationName();
    if (robot && robot->running() && robot->view().status) {
        const agent::BehaviorStatus& status = *robot->view().status;
        const QString progress = status.progress_pct ? widgets::figure(*status.progress_pct, 0) + " % · " : QString();
        title = progress + QString::fromStdString(status.state) + " – " + title;
    }
    if (title != windowTitle())
        setWindowTitle(title);
}

void MainWindow::say(Severity severity, const QString& key, const QString& text) {
    views_.notifications->push(key, severity, text);
}

void MainWindow::offer(Severity severity, const QString& key, const QString& text, const widgets::Offer& offer,
                       std::function<void()> accept) {
    offers_[key] = std::move(accept);
    views_.notifications->push(key, severity, text, offer);
}

void MainWindow::complain(const QString& key, const Error& error) {
    say(Severity::Error, key, QString::fromStdString(error.text()));
}

void MainWindow::openMission(const QString& path) {
    const auto mission = mission::readMissionFile(path);
    if (!mission)
        return complain("mission", mission.error());
    awaiting_plugin_.reset();
    if (const QString world = worldToOpenFor(*mission); !world.isEmpty()) {
        chooseWorld(world);
        awaiting_world_ = *mission;
        return;
    }
    setUp(*mission);
}

QString MainWindow::worldToOpenFor(const mission::Mission& mission) const {
    const QString wanted = QString::fromStdString(mission.world);
    const QString here = control_.level().isEmpty() ? options_.server.simulator.world : control_.level();
    const bool may_change = control_.server().embedded && control_.robots().empty();
    return may_change && here != wanted && worldNames().contains(wanted) ? wanted : QString();
}

void MainWindow::setUp(const mission::Mission& mission) {
    if (control_.plugins().isAsked(mission.behavior)) {
        awaiting_plugin_ = mission;
        return;
    }
    const auto prepared = control_.prepareMission(mission);
    if (!prepared)
        return complain("mission", prepared.error());
    if (const auto faults = readFaults(textsOf(mission.faults)); !faults)
        return complain("mission", mission::atValue(mission, "faults", faults.error()));
    selectRobotFor(mission.robot_class);
    views_.behavior->chooseBehavior(mission.behavior);
    if (views_.behavior->behaviorId() != mission.behavior)
        return complain("mission",
                        mission::atValue(mission, "behavior",
                                         {"this behavior does not drive the mission's robot", mission.robot_class,
                                          "Name the robot that " + mission.behavior + " is for"}));
    views_.parameters->setValues(*prepared);
    views_.behavior->plan().choose(QString::fromStdString(mission.plan));
    setIsolated(chosenPlugin(), mission.isolate || views_.behavior->isolated());
    views_.behavior->setArea(mission.area_in_map);
    views_.map->setArea(mission.area_in_map);
    views_.map->fit();
    cell_size_m_ = mission.cell_size_m;
    mission_faults_ = textsOf(mission.faults);
    keepDraft();
    showPlan();
    applyParameters();
    control_.cure("mission");
    const QString name = QString::fromStdString(mission.name);
    say(Severity::Note, "mission-ready",
        selected_ == 0 ? tr("Mission %1 is ready. Double-click the start pose %2: a %3 comes. Then press Start.")
                             .arg(name, QString::fromStdString(mission.start),
                                  QString::fromStdString(mission.robot_class).section('.', -1))
                       : tr("Mission %1 is ready. Press Start.").arg(name));
}

/// The selected robot where it is of this class, or another one that has nothing to do; else none, and the next one
/// that is spawned will be.
void MainWindow::selectRobotFor(const std::string& robot_class) {
    const auto fits = [&](const Robot* robot) {
        return robot && !robot->isReplay() && robot->view().spawn.class_name == robot_class;
    };
    if (fits(control_.robot(selected_)))
        return;
    const std::vector<Robot*> robots = control_.robots();
    const auto idle = std::ranges::find_if(robots, [&](const Robot* one) { return fits(one) && !one->running(); });
    next_class_ = robot_class;
    views_.spawn_card->chooseClass(QString::fromStdString(robot_class));
    selectRobot(idle == robots.end() ? 0 : (*idle)->view().id);
}

void MainWindow::chooseMissionFile() {
    const QString path = QFileDialog::getOpenFileName(this, tr("Open mission"), {}, tr("Missions (*.json)"));
    if (!path.isEmpty())
        openMission(path);
}

std::string MainWindow::startName() const {
    const Robot* robot = control_.robot(selected_);
    for (const protocol::StartPose& pose : start_poses_)
        if (robot && pose.pose_in_map.position_m.isApprox(robot->view().spawn.start_in_map.position_m))
            return pose.name;
    return start_poses_.empty() ? mission::Mission{}.start : start_poses_.front().name;
}

bool MainWindow::mayBeSaved() const {
    return !views_.behavior->behaviorId().empty() && !(views_.behavior->needsArea() && views_.behavior->area().empty());
}

void MainWindow::saveMission(const QString& path) {
    const std::string behavior_id = views_.behavior->behaviorId();
    const auto* behavior = control_.plugins().behavior(behavior_id);
    if (!behavior)
        return say(Severity::Warning, "mission", tr("No behavior is chosen. Choose what the robot is to do first."));
    if (!mayBeSaved())
        return say(Severity::Warning, "mission", tr("There is no mission area to save. Draw one on the map first."));
    mission::Mission mission;
    mission.name = QFileInfo(path).completeBaseName().toStdString();
    mission.world = control_.level().toStdString();
    if (const Robot* robot = control_.robot(selected_))
        mission.robot_class = robot->view().spawn.class_name;
    for (const QString& fault : mission_faults_)
        mission.faults.push_back(fault.toStdString());
    mission.start = startName();
    mission.behavior = behavior_id;
    mission.plan = views_.behavior->plan().path().toStdString();
    mission.area_in_map = views_.behavior->area();
    mission.parameters = views_.parameters->values();
    mission.cell_size_m = cell_size_m_;
    mission.isolate = views_.behavior->isolated();
    if (const auto saved = mission::writeMissionFile(mission, behavior->parameters, path); !saved)
        return complain("mission", saved.error());
    control_.cure("mission");
    views_.notifications->push("mission-saved", Severity::Note,
                               tr("Saved the mission %1; usar-mission run flies it, too.").arg(path), true);
}

void MainWindow::chooseWhereToSaveMission() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save mission"), tr("mission.json"), tr("Missions (*.json)"));
    if (!path.isEmpty())
        saveMission(QFileInfo(path).suffix().isEmpty() ? path + ".json" : path);
}

bool MainWindow::chooseResultFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for results"), control_.resultFolder());
    if (folder.isEmpty())
        return false;
    control_.setResultFolder(folder);
    return true;
}

void MainWindow::exportFailed(const QString& reason) {
    if (!control_.closing() || asking_)
        return; // the notification says it; the scan is still there
    asking_ = true;
    QMessageBox box(QMessageBox::Warning, tr("The scan is not saved"), reason, QMessageBox::NoButton, this);
    auto* other = box.addButton(tr("Choose another folder…"), QMessageBox::AcceptRole);
    auto* discard = box.addButton(tr("Close without saving"), QMessageBox::DestructiveRole);
    box.addButton(tr("Keep the window open"), QMessageBox::RejectRole);
    box.exec();
    asking_ = false;
    if (box.clickedButton() == other && chooseResultFolder()) {
        control_.prepareToClose();
    } else if (box.clickedButton() == discard) {
        may_close_ = true;
        close();
    } else {
        control_.stayOpen();
    }
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (workshop_.hasChanges()) {
        event->ignore();
        return workshop_.letGo([this] { close(); });
    }
    saveSettings();
    drive_.leave();
    cancelLoading(); // nobody waits for it
    if (may_close_ || !control_.anythingToSave())
        return event->accept();
    event->ignore();
    if (control_.closing())
        return;
    say(Severity::Note, "closing", tr("Saving what was scanned, then closing…"));
    control_.prepareToClose();
}

void MainWindow::setTheme(widgets::Theme theme) {
    widgets::applyTheme(theme);
    commands_.action("view.dark")->setChecked(theme == widgets::Theme::Dark);
}

} // namespace usar::app
