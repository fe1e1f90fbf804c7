#include "app/mission_control.h"

#include <utility>

#include <QJsonArray>
#include <QTimer>

#include "core/mission/result_writer.h"

namespace usar::app {

namespace {

constexpr int most_robots = 9; // one key each

/// Figures of the robot for the summary beside the pictures.
QJsonObject summaryOf(const RobotView& view, const sim::RobotTruth* truth) {
    QJsonObject summary{
        {"behavior", QString::fromStdString(view.behavior_id)},
        {"lines_received", static_cast<qint64>(view.figures.lines_received)},
        {"protocol_time_s", view.figures.now.count()},
        {"success", view.finished && view.finished->success},
        {"reason", view.finished ? QString::fromStdString(view.finished->reason) : QString("saved before the end")}};
    if (view.status) {
        summary["duration_s"] = view.status->elapsed.count();
        summary["distance_m"] = view.status->distance_flown_m;
        summary["charges"] = view.status->charges;
    }
    summary["collisions"] = truth ? QJsonValue(truth->collisions) : QJsonValue();
    return summary;
}

} // namespace

MissionControl::MissionControl(QObject* parent) : QObject(parent) {
    export_pool_.setMaxThreadCount(1);
    connect(&simulator_, &SimulatorHost::ready, this, [this](quint16 port, const WorldPicture& world) {
        port_ = port;
        emit worldKnown(world);
        openNext();
    });
    connect(&simulator_, &SimulatorHost::failed, this, [this](const QString& reason) {
        note(Severity::Error, "simulator", tr("The embedded simulator did not start. %1").arg(reason));
    });
    connect(&simulator_, &SimulatorHost::noted, this,
            [this](const QString& sentence) { note(Severity::Note, "simulator-log", sentence); });
    connect(&simulator_, &SimulatorHost::robotsChanged, this, [this](const std::vector<sim::RobotTruth>& truths) {
        for (const auto& [id, robot] : robots_)
            for (const sim::RobotTruth& truth : truths)
                if (truth.name == robot->view().spawn.robot_name)
                    truths_[id] = truth;
    });
}

MissionControl::~MissionControl() {
    export_pool_.waitForDone();
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
    for (const auto& robot : robots())
        remove(robot->view().id);
    next_.reset();
    simulator_.stop();
    level_.clear();
    emit linkChanged({});
}

void MissionControl::openNext() {
    next_ = std::make_unique<Robot>();
    connectRobot(next_.get());
    next_->open(host_, port_, target_.embedded);
}

void MissionControl::connectRobot(Robot* robot) {
    connect(robot, &Robot::linkChanged, this, [this, robot] { linkMoved(robot); });
    connect(robot, &Robot::startPosesKnown, this, [this](const protocol::StartPoses& poses, const QString& level) {
        level_ = level;
        emit startPosesKnown(poses, level);
    });
    connect(robot, &Robot::updated, this, [this, robot](const auto& update) {
        if (robot->spawned())
            emit robotUpdated(robot->view().id, update);
    });
    connect(robot, &Robot::behaviorFinished, this,
            [this, robot](bool success, const QString& reason) { finished(robot, success, reason); });
    connect(robot, &Robot::recordReady, this, [this, robot](const auto& record) { write(robot, record); });
    connect(robot, &Robot::noticed, this, [this, robot](const mission::Notice& notice) {
        const QString who = robot->spawned() ? QString::fromStdString(robot->view().spawn.robot_name) : tr("Link");
        emit noticed(who, {notice.severity, who.toStdString() + ": " + notice.text, notice.topic, notice.over});
    });
}

void MissionControl::linkMoved(Robot* robot) {
    const link::LinkStatus& status = robot->view().link;
    if (robot == next_.get())
        emit linkChanged(status);
    if (status.state == link::LinkState::Connected)
        emit cured("link");
    else if (!status.reason.isEmpty())
        note(Severity::Error, "link", status.reason);
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
    int id = 1;
    while (robots_.contains(id))
        ++id;
    if (id > most_robots)
        return failure("nine robots are the most", request.robot_name, "Remove one first");
    if (request.robot_name.empty())
        request.robot_name = "R" + std::to_string(id);
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

void MissionControl::remove(int id) {
    const auto found = robots_.find(id);
    if (found == robots_.end())
        return;
    const QString name = QString::fromStdString(found->second->view().spawn.robot_name);
    robots_.erase(found);
    truths_.erase(id);
    emit robotRemoved(id, name);
}

Result<void> MissionControl::startBehavior(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                                           const std::map<std::string, agent::ParameterValue>& values) {
    Robot* robot = this->robot(id);
    if (!robot)
        return failure("there is no such robot", std::to_string(id), "Spawn one on a start pose first");
    const agent::BehaviorDescription* description = plugins_.behavior(behavior_id);
    if (!description)
        return tl::unexpected(plugins_.pluginFor(behavior_id).error());
    if (description->needs_area && area_in_map.empty())
        return failure("it needs a mission area", description->name, "Draw one on the map with the area tool");
    const auto parameters = agent::ParameterSet::make(description->parameters, values);
    if (!parameters)
        return tl::unexpected(parameters.error());
    return robot->startBehavior(plugins_, behavior_id, area_in_map, *parameters);
}

Result<agent::TaskPreview> MissionControl::preview(int id, const std::string& behavior_id, const Rectangle& area_in_map,
                                                   const std::map<std::string, agent::ParameterValue>& values) const {
    const auto plugin = plugins_.pluginFor(behavior_id);
    if (!plugin)
        return tl::unexpected(plugin.error());
    const auto parameters = agent::ParameterSet::make(plugins_.behavior(behavior_id)->parameters, values);
    if (!parameters)
        return tl::unexpected(parameters.error());
    const Robot* robot = this->robot(id);
    const Pose start_in_map = robot ? robot->view().spawn.start_in_map : Pose{};
    return (*plugin)->preview(behavior_id, {{"", start_in_map, area_in_map}, *parameters});
}

void MissionControl::stopAll() {
    for (Robot* robot : robots())
        robot->stop();
}

QString MissionControl::resultFolder() const {
    return result_folder_.isEmpty() ? mission::defaultResultFolder() : result_folder_;
}

void MissionControl::exportResults(int id) {
    if (Robot* robot = this->robot(id))
        robot->requestRecord();
}

void MissionControl::finished(Robot* robot, bool success, const QString& reason) {
    const int id = robot->view().id;
    note(success ? Severity::Note : Severity::Warning, QString("mission-%1").arg(id),
         QString("%1: %2").arg(QString::fromStdString(robot->view().spawn.robot_name), reason));
    emit behaviorFinished(id, success, reason);
    if (robot->view().unsaved)
        robot->requestRecord();
}

void MissionControl::write(Robot* robot, const std::shared_ptr<const mission::ScanRecord>& record) {
    const auto truth = truths_.find(robot->view().id);
    const QJsonObject summary = summaryOf(robot->view(), truth == truths_.end() ? nullptr : &truth->second);
    ++exports_running_;
    export_pool_.start([this, id = robot->view().id, record, summary, folder = resultFolder()] {
        const Result<QStringList> files = mission::writeResults(*record, summary, folder);
        QMetaObject::invokeMethod(this, [this, id, files] { exported(id, files); });
    });
}

void MissionControl::exported(int id, const Result<QStringList>& files) {
    --exports_running_;
    if (files) {
        if (Robot* robot = this->robot(id))
            robot->markSaved();
        emit cured("export");
        emit resultsWritten(id, *files);
    } else {
        note(Severity::Error, "export", QString::fromStdString(files.error().text()));
        emit exportFailed(id, QString::fromStdString(files.error().text()));
    }
    if (closing_ && files && !anythingToSave())
        emit readyToClose();
}

bool MissionControl::anythingToSave() const {
    for (const auto& [id, robot] : robots_)
        if (robot->view().unsaved)
            return true;
    return exports_running_ > 0;
}

void MissionControl::prepareToClose() {
    closing_ = true;
    for (Robot* robot : robots()) {
        if (robot->running())
            robot->stop(); // what it scanned is saved when it has stopped
        else if (robot->view().unsaved)
            robot->requestRecord();
    }
    // A session whose behavior hangs never hands out its record; the others' are on the disk by then.
    QTimer::singleShot(5000, this, [this] {
        if (closing_ && exports_running_ == 0)
            emit readyToClose();
    });
}

void MissionControl::note(Severity severity, const QString& key, const QString& text) {
    emit noticed(key, {.severity = severity, .text = text.toStdString()});
}

} // namespace usar::app
