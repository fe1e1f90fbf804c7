#include "app/host/mission_control.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/host/true_figures.h"
#include "core/mission/files/mission_check.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::app {

namespace {

constexpr std::chrono::seconds closing_patience{5};

} // namespace

MissionControl::MissionControl(QObject* parent) : QObject(parent) {
    plugins_.setNews([this](const auto& changes) { emit pluginsChanged(changes); });
    patience_.setSingleShot(true);
    patience_.setInterval(closing_patience);
    connect(&patience_, &QTimer::timeout, this, [this] {
        keeper_.giveUpWaiting();
        emit readyToClose();
    });
    connect(&keeper_, &mission::ScanKeeper::saved, this, &MissionControl::exported);
    connect(&keeper_, &mission::ScanKeeper::failed, this, [this](int id, const QString& reason) {
        patience_.stop();
        note(Severity::Error, "export", reason);
        emit exportFailed(id, reason);
    });
    wireSimulator();
}

void MissionControl::wireSimulator() {
    connect(&simulator_, &server::SimulatorHost::ready, this,
            [this](quint16 port, const server::WorldPicture& world, const auto& waiting) {
                port_ = port;
                waiting_ = waiting;
                world_ = world;
                emit worldKnown(world);
                emit classesChanged();
                openNext();
            });
    connect(&simulator_, &server::SimulatorHost::robotLearned, this,
            [this](const QString&, const QString& class_name, bool has_camera) { learn(class_name, has_camera); });
    connect(&simulator_, &server::SimulatorHost::failed, this, [this](const QString& reason) {
        note(Severity::Error, "simulator", tr("The embedded simulator did not start. %1").arg(reason));
    });
    connect(&simulator_, &server::SimulatorHost::noted, this,
            [this](const QString& sentence) { note(Severity::Note, "simulator-log", sentence); });
    connect(&simulator_, &server::SimulatorHost::robotRefused, this,
            [this](const QString& sentence) { note(Severity::Warning, "robot-file", sentence); });
    connect(&simulator_, &server::SimulatorHost::movedPort, this,
            [this](const QString& sentence) { note(Severity::Warning, "simulator-port/" + sentence, sentence); });
    connect(&simulator_, &server::SimulatorHost::faultTurned, this, [this](const QString& sentence) {
        for (const auto& [id, robot] : robots_)
            if (!robot->isReplay())
                robot->noteFault(sentence);
    });
    connect(&simulator_, &server::SimulatorHost::robotsChanged, this,
            [this](const std::vector<sim::RobotTruth>& truths) {
                for (const auto& [id, robot] : robots_)
                    for (const sim::RobotTruth& truth : truths)
                        if (truth.name == robot->view().spawn.robot_name)
                            truths_[id] = trueFiguresOf(truth);
            });
}

MissionControl::~MissionControl() = default;

void MissionControl::isolatePlugins(const QStringList& names, const QString& marks_folder) {
    plugins_.setPolicy(
        {.host_program = server::behaviorHostProgram(), .isolated = names, .marks = agent::PluginMarks(marks_folder)});
}

void MissionControl::connectTo(const ServerTarget& target) {
    disconnectFromServer();
    target_ = target;
    host_ = target.embedded ? QString("127.0.0.1") : target.host;
    port_ = target.port;
    if (target.embedded)
        return simulator_.start(target.simulator);
    openNext();
}

void MissionControl::disconnectFromServer() {
    for (const Robot* robot : robots())
        if (!robot->isReplay()) // A replay needs no server.
            remove(robot->view().id);
    next_.reset();
    waiting_.clear();
    time_stopped_ = false;
    simulator_.stop();
    level_.clear();
    start_poses_.clear();
    world_ = {};
    emit classesChanged();
    emit linkChanged({});
}

void MissionControl::learn(const QString& class_name, bool has_camera) {
    for (auto [classes, is_one] :
         {std::pair(&world_.robot_classes, true), std::pair(&world_.camera_classes, has_camera)}) {
        classes->removeAll(class_name);
        if (is_one)
            classes->append(class_name);
    }
    emit classesChanged();
}

std::vector<agent::RobotDescription> MissionControl::robotsToSpawn() const {
    std::vector<agent::RobotDescription> robots = plugins_.kinds();
    for (const QString& name : world_.robot_classes) {
        const std::string class_name = "USARBot." + name.toStdString();
        const bool known = std::ranges::any_of(
            robots, [&](const agent::RobotDescription& robot) { return robot.class_name == class_name; });
        if (!known)
            robots.push_back({class_name, name.toStdString(), {}, {}});
    }
    return robots;
}

void MissionControl::setPace(server::Pace pace, double factor) {
    simulator_.setPace(pace, std::isinf(factor) ? 1.0 : factor);
    time_stopped_ = simulator_.running() && pace == server::Pace::Paused;
    for (const auto& [id, robot] : robots_)
        robot->expectSilence(time_stopped_);
    if (next_)
        next_->expectSilence(time_stopped_);
}

void MissionControl::openNext() {
    next_ = std::make_unique<Robot>();
    connectRobot(next_.get());
    next_->expectSilence(time_stopped_);
    next_->open(host_, port_, target_.embedded);
}

void MissionControl::connectRobot(Robot* robot) {
    connect(robot, &Robot::linkChanged, this, [this, robot] { linkMoved(robot); });
    connect(robot, &Robot::startPosesKnown, this, [this](const protocol::StartPoses& poses, const QString& level) {
        level_ = level;
        start_poses_ = poses.poses;
        emit startPosesKnown(poses, level);
    });
    connect(robot, &Robot::updated, this, [this, robot](const auto& update) {
        if (robot->spawned())
            emit robotUpdated(robot->view().id, update);
        else
            emit linkUpdated(update);
    });
    connect(robot, &Robot::behaviorFinished, this,
            [this, robot](bool success, const QString& reason) { finished(robot, success, reason); });
    connect(robot, &Robot::recordingFlushed, this, [this, robot](const QString& path) {
        const auto wanted = wanted_moments_.extract(robot->view().connection);
        if (!wanted.empty() && !path.isEmpty())
            open(path, wanted.key(), wanted.mapped());
    });
    keeper_.watch(*robot, [this, robot]() -> std::optional<mission::TrueFigures> {
        const auto truth = truths_.find(robot->view().id);
        return truth == truths_.end() ? std::nullopt : std::optional(truth->second);
    });
    connect(robot, &Robot::noticed, this, [this, robot](const mission::Notice& notice) { tell(robot, notice); });
}

void MissionControl::tell(Robot* robot, const mission::Notice& notice) {
    if (notice.topic == "fault" && !robot->isReplay())
        return; // The simulator reports it once for all robots.
    const QString who = robot->spawned() ? QString::fromStdString(robot->view().spawn.robot_name) : tr("Link");
    const QString key = who + "/" + QString::fromStdString(notice.topic);
    if (notice.over)
        return emit cured(key);
    emit noticed(key, {notice.severity, who.toStdString() + ": " + notice.text, notice.topic, false});
}

void MissionControl::linkMoved(Robot* robot) {
    const link::LinkStatus& status = robot->view().link;
    if (robot == next_.get())
        emit linkChanged(status);
    else
        emit robotLinkChanged(robot->view().id);
    if (robot == next_.get() && status.state == link::LinkState::Connected && !waiting_.empty())
        goOnWithNext();
    if (status.state == link::LinkState::Connected)
        emit cured("link");
    else if (!status.reason.isEmpty())
        note(Severity::Error, "link", status.reason);
}

void MissionControl::goOnWithNext() {
    const sim::Simulation::Orphan orphan = waiting_.front();
    waiting_.erase(waiting_.begin());
    if (const auto id = spawn({orphan.class_name, orphan.name, orphan.base_in_map}); !id) {
        note(Severity::Warning, "snapshot",
             tr("The snapshot goes on without some of its robots. %1").arg(QString::fromStdString(id.error().text())));
        waiting_.clear();
        simulator_.letOrphansGo();
    }
}

int MissionControl::nextId() const {
    int id = 1;
    while (robots_.contains(id))
        ++id;
    return id;
}

QString MissionControl::nextRobotName() const {
    return QString("R%1").arg(nextId());
}

Result<int> MissionControl::spawn(mission::SpawnRequest request) {
    if (!next_ || next_->view().link.state != link::LinkState::Connected)
        return failure("there is no link to a server yet", request.robot_name, "Connect first, then spawn");
    if (request.class_name.empty())
        return failure("no plugin says which robot to spawn", request.robot_name, "Start with --plugins FOLDER");
    const int id = nextId();
    if (id > most_robots)
        return failure("nine robots are the most", request.robot_name, "Remove one first");
    if (request.robot_name.empty())
        request.robot_name = nextRobotName().toStdString();
    for (const Robot* other : robots())
        if (other->view().spawn.robot_name == request.robot_name)
            return failure("there is a robot of this name already", request.robot_name, "Choose another name");
    if (recording_)
        record(*next_, request);
    next_->spawn(id, request);
    robots_[id] = std::move(next_);
    emit robotAdded(id);
    openNext();
    return id;
}

Robot* MissionControl::robot(int id) const {
    const auto found = robots_.find(id);
    return found == robots_.end() ? nullptr : found->second.get();
}

std::vector<Robot*> MissionControl::robots() const {
    std::vector<Robot*> all;
    for (const auto& [id, robot] : robots_)
        all.push_back(robot.get());
    return all;
}

int MissionControl::connectionOf(int id) const {
    const Robot* found = id == 0 ? next_.get() : robot(id);
    return found ? found->view().connection : 0;
}

Robot* MissionControl::robotOn(int connection) const {
    if (next_ && next_->view().connection == connection)
        return next_.get();
    for (const auto& [id, robot] : robots_)
        if (robot->view().connection == connection)
            return robot.get();
    return nullptr;
}

Result<void> MissionControl::checkLine(int connection) const {
    const Robot* robot = robotOn(connection);
    if (!robot)
        return failure("there is no connection to send it on", "", "Connect to a server first");
    if (robot->view().figures.replay)
        return failure("this is a recording, and nothing can be sent into it", "", "Connect to a server first");
    if (robot->view().link.state != link::LinkState::Connected)
        return failure("the connection is lost", robot->view().spawn.robot_name,
                       "Wait until it is back, or connect anew");
    return {};
}

Result<void> MissionControl::sendLine(int connection, const QString& line, const std::string& source) {
    if (const auto sendable = checkLine(connection); !sendable)
        return sendable;
    robotOn(connection)->send(protocol::RawCommand{line.toStdString()}, source);
    return {};
}

void MissionControl::remove(int id) {
    const auto found = robots_.find(id);
    if (found == robots_.end())
        return;
    std::unique_ptr<Robot> robot = std::move(found->second);
    robots_.erase(found);
    robot->disconnect(this);
    const QString name = QString::fromStdString(robot->view().spawn.robot_name);
    const Robot* const looked_back_on = robotOn(robot->view().looks_back_on);
    const int instead = looked_back_on ? looked_back_on->view().id : robots_.empty() ? 0 : robots_.begin()->first;
    keeper_.takeLeave(std::move(robot));
    truths_.erase(id);
    emit robotRemoved(id, name, instead);
}

void MissionControl::spawnAgain(int id) {
    if (Robot* robot = this->robot(id); robot && !robot->isReplay())
        robot->spawn(id, robot->view().spawn);
}

Result<void> MissionControl::checkArea(const Rectangle& area_in_map) const {
    return mission::checkAreaInside(area_in_map, world_.extent_in_map);
}

Result<void> MissionControl::startBehavior(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                                           const std::map<std::string, agent::ParameterValue>& values,
                                           const QString& plan_path, bool isolate) {
    Robot* robot = this->robot(id);
    if (!robot)
        return failure("there is no such robot", std::to_string(id), "Spawn one on a start pose first");
    const auto plan = mission::readOwnPlan(plan_path, behavior_id, plugins_);
    if (!plan)
        return tl::unexpected(plan.error());
    return startOn(*robot, {behavior_id, area_in_map, values, *plan, isolate});
}

Result<void> MissionControl::startOn(Robot& robot, const StartedBehavior& start) {
    const agent::BehaviorDescription* description = plugins_.behavior(start.id);
    if (!description)
        return tl::unexpected(plugins_.pluginFor(start.id).error());
    if (description->needs_area && start.area_in_map.empty())
        return failure("it needs a mission area", description->name, "Draw one on the map with the area tool");
    if (const auto inside = checkArea(start.area_in_map); !inside)
        return tl::unexpected(inside.error());
    const auto parameters = agent::ParameterSet::make(description->parameters, start.parameters);
    if (!parameters)
        return tl::unexpected(parameters.error());
    std::optional<agent::Isolation> isolation;
    if (start.isolated)
        isolation = {server::behaviorHostProgram()};
    return robot.startBehavior(plugins_, start.id, start.area_in_map, *parameters, start.plan, isolation);
}

Result<void> MissionControl::startAgain(int id) {
    Robot* robot = this->robot(id);
    if (!robot || !robot->started())
        return failure("nothing was started there", std::to_string(id), "Choose a behavior, then start it");
    if (!robot->view().figures.spawned)
        return failure("the robot is gone", robot->view().spawn.robot_name, "Spawn it again first");
    StartedBehavior start = *robot->started();
    start.isolated = true;
    return startOn(*robot, start);
}

Result<void> MissionControl::addFaults(const QStringList& texts) {
    if (!simulator_.running())
        return failure("faults can be made in the embedded simulator only", "", "Connect to it first");
    auto faults = server::readFaults(texts);
    if (!faults)
        return tl::unexpected(faults.error());
    simulator_.addFaults(*faults);
    return {};
}

void MissionControl::preview(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                             const std::map<std::string, agent::ParameterValue>& values,
                             const agent::PluginLoader::Told& told) const {
    const agent::BehaviorDescription* const behavior = plugins_.behavior(behavior_id);
    if (!behavior)
        return told(tl::unexpected(plugins_.pluginFor(behavior_id).error()));
    const auto parameters = agent::ParameterSet::make(behavior->parameters, values);
    if (!parameters)
        return told(tl::unexpected(parameters.error()));
    const Robot* robot = this->robot(id);
    const Pose start_in_map = robot ? robot->view().spawn.start_in_map : Pose{};
    plugins_.preview(behavior_id, {{"", start_in_map, area_in_map}, *parameters}, told);
}

Result<std::map<std::string, agent::ParameterValue>>
MissionControl::prepareMission(const mission::Mission& mission) const {
    if (!level_.isEmpty() && mission.world != level_.toStdString())
        return tl::unexpected(
            mission::atValue(mission, "world",
                             {"this mission belongs to the world " + mission.world, "",
                              "Here is " + level_.toStdString() + "; connect to a server with " + mission.world}));
    if (const auto prepared = mission::prepareBehavior(mission, plugins_); !prepared)
        return tl::unexpected(prepared.error());
    if (const auto inside = mission::checkAreaInside(mission, world_.extent_in_map); !inside)
        return tl::unexpected(inside.error());
    return mission::withAnglesInRadians(mission.parameters, plugins_.behavior(mission.behavior)->parameters);
}

void MissionControl::stopAll() {
    for (Robot* robot : robots())
        robot->stop();
}

void MissionControl::exportResults(int id) {
    if (Robot* robot = this->robot(id))
        keeper_.save(*robot);
}

void MissionControl::finished(Robot* robot, bool success, const QString& reason) {
    const int id = robot->view().id;
    const QString key = missionKey(id);
    const QString text = QString("%1: %2").arg(QString::fromStdString(robot->view().spawn.robot_name), reason);
    if (robot->view().broke)
        emit behaviorBroke(id, key, text);
    else
        note(success ? Severity::Note : Severity::Warning, key, text);
    emit behaviorFinished(id, success, reason);
    if (!robot->view().tiles.empty())
        keeper_.save(*robot); // Even if everything was saved before: the record now includes the end.
    closeWhenSaved();
}

void MissionControl::exported(int id, const QStringList& files) {
    emit cured("export");
    emit resultsWritten(id, files);
    closeWhenSaved();
}

void MissionControl::closeWhenSaved() {
    if (!closing_ || anythingToSave())
        return;
    patience_.stop();
    emit readyToClose();
}

bool MissionControl::anythingToSave() const {
    return keeper_.busy() || std::ranges::any_of(robots_, [](const auto& entry) {
               return entry.second->view().unsaved || entry.second->running();
           });
}

void MissionControl::prepareToClose() {
    closing_ = true;
    patience_.start();
    keeper_.retry();
    for (Robot* robot : robots()) {
        if (robot->running())
            robot->stop(); // Its scan is saved once it has stopped.
        else if (robot->view().unsaved)
            keeper_.save(*robot);
    }
    closeWhenSaved();
}

void MissionControl::stayOpen() {
    closing_ = false;
    patience_.stop();
}

void MissionControl::note(Severity severity, const QString& key, const QString& text) {
    emit noticed(key, {.severity = severity, .text = text.toStdString()});
}

} // namespace usar::app
