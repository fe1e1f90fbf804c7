#include "core/mission/fleet/fleet.h"

#include <algorithm>
#include <utility>

#include "core/mission/files/mission_check.h"
#include "core/mission/fleet/fleet_private.h"

namespace usar::mission {

Fleet::Private::Private(Fleet& fleet, const QString& host_program)
    : q(fleet)
    , behavior_host(host_program)
    , opening({[this](auto robot, const auto& facts, const auto& complaint) {
                   addReplay(std::move(robot), facts, complaint);
               },
               [this](const QString& reason) { q.note(Severity::Error, "replay", reason); }}) {
    plugins.setNews([this](const auto& changes) { emit q.pluginsChanged(changes); });
    patience.setSingleShot(true);
    patience.setInterval(std::chrono::seconds(5)); // As prepareToClose says.
    connect(&patience, &QTimer::timeout, &q, [this] {
        keeper.giveUpWaiting();
        emit q.readyToClose();
    });
    connect(&keeper, &ScanKeeper::saved, &q, [this](RobotId id, const RunSummary& summary, const QString& name) {
        emit q.cured("export");
        emit q.resultsWritten(id, summary, name);
        closeWhenSaved();
    });
    connect(&keeper, &ScanKeeper::failed, &q, [this](RobotId id, const QString& reason) {
        patience.stop();
        q.note(Severity::Error, "export", reason);
        emit q.exportFailed(id, reason);
    });
    connect(&keeper, &ScanKeeper::cancelled, &q, [this](RobotId id, const QString& reason) {
        patience.stop();
        q.note(Severity::Note, "export", reason);
        emit q.exportFailed(id, reason);
    });
    connect(&keeper, &ScanKeeper::exported, &q, [this](const QStringList& files, const QString& name) {
        emit q.cured("map_export");
        emit q.mapExported(files, name);
        closeWhenSaved();
    });
    connect(&keeper, &ScanKeeper::exportRefused, &q, [this](const QString& reason, bool cancelled) {
        q.note(cancelled ? Severity::Note : Severity::Error, "map_export", reason);
        closeWhenSaved();
    });
    connect(&keeper, &ScanKeeper::writingChanged, &q, &Fleet::savingChanged);
}

Fleet::Fleet(const QString& behavior_host, QObject* parent)
    : QObject(parent)
    , d_(std::make_unique<Private>(*this, behavior_host)) {}

Fleet::~Fleet() = default;

void Fleet::isolatePlugins(const QStringList& names, const QString& marks_folder) {
    d_->plugins.setPolicy(
        {.host_program = d_->behavior_host, .isolated = names, .marks = agent::PluginMarks(marks_folder)});
}

agent::PluginLoader& Fleet::plugins() {
    return d_->plugins;
}

const agent::PluginLoader& Fleet::plugins() const {
    return d_->plugins;
}

void Fleet::openLink(const QString& host, quint16 port, bool lockstep, const QString& equipment_advice) {
    d_->host = host;
    d_->port = port;
    d_->lockstep = lockstep;
    d_->equipment_advice = equipment_advice;
    d_->openNext();
}

void Fleet::disconnectFromServer() {
    for (const Robot* robot : robots())
        if (!robot->isReplay()) // it needs no server
            remove(robot->view().id);
    d_->next.reset();
    d_->silence_expected = false;
    d_->place = {};
    d_->start_poses.clear();
    d_->seed.reset();
    d_->make_truth = {};
    emit serverLeft();
    emit linkChanged({});
}

const QString& Fleet::level() const {
    return d_->place.level;
}

const std::vector<protocol::StartPose>& Fleet::startPoses() const {
    return d_->start_poses;
}

void Fleet::setDryAbove(std::optional<double> z_m) {
    d_->place.dry_above_m = z_m;
}

void Fleet::setWorldExtent(const Rectangle& extent_in_map) {
    d_->place.extent_in_map = extent_in_map;
}

void Fleet::expectSilence(bool expected) {
    d_->silence_expected = expected;
    for (Robot* robot : robots())
        robot->expectSilence(expected);
    if (d_->next)
        d_->next->expectSilence(expected);
}

void Fleet::noteFault(const QString& sentence) {
    for (Robot* robot : robots())
        if (!robot->isReplay())
            robot->noteFault(sentence);
}

void Fleet::setTruth(const std::string& robot_name, const TrueFigures& truth) {
    for (const Robot* robot : robots())
        if (robot->view().spawn.robot_name == robot_name)
            d_->truths[robot->view().id] = truth;
}

void Fleet::setSeed(std::optional<std::uint64_t> seed) {
    d_->seed = seed;
}

void Fleet::setTruthMaker(std::function<Truth()> make) {
    d_->make_truth = std::move(make);
}

SimulatorFacts Fleet::Private::factsOf(const Robot& robot) const {
    if (robot.isReplay())
        return {};
    const auto truth = truths.find(robot.view().id);
    return {truth == truths.end() ? std::nullopt : std::optional(truth->second), seed, make_truth,
            robot.started() ? flightLimitsOf(robot.view().spawn.start_in_map, robot.started()->parameters)
                            : std::nullopt};
}

void Fleet::Private::openNext() {
    next = std::make_unique<Robot>();
    Robot* const robot = next.get();
    connectRobot(robot);
    connect(robot, &Robot::startPosesKnown, &q, [this](const protocol::StartPoses& poses, const QString& level) {
        place.level = level;
        start_poses = poses.poses;
        emit q.startPosesKnown(poses, level);
    });
    connect(robot, &Robot::behaviorFinished, &q,
            [this, robot](bool success, const QString& reason) { finished(robot, success, reason); });
    connect(robot, &Robot::recordingFlushed, &q, [this, robot](const QString& path) {
        const auto wanted = wanted_moments.extract(robot->view().connection);
        if (!wanted.empty() && !path.isEmpty())
            openReplay(path, wanted.key(), {.seek_clock = wanted.mapped()});
    });
    robot->expectSilence(silence_expected);
    robot->open(host, port, lockstep, equipment_advice);
}

void Fleet::Private::connectRobot(Robot* robot) {
    connect(robot, &Robot::linkChanged, &q, [this, robot] { linkMoved(robot); });
    connect(robot, &Robot::updated, &q, [this, robot](const auto& update) {
        if (robot->spawned())
            emit q.robotUpdated(robot->view().id, update);
        else if (!robot->isReplay())
            emit q.linkUpdated(update);
        startRest(*robot);
    });
    connect(robot, &Robot::noticed, &q, [this, robot](const Notice& notice) { tell(robot, notice); });
    keeper.watch(*robot, [this, robot] { return factsOf(*robot); });
}

void Fleet::Private::tell(Robot* robot, const Notice& notice) {
    if (notice.topic == "fault" && !robot->isReplay())
        return; // the simulator says it, once for all robots
    const QString who = robot->spawned() ? nameOf(*robot) : tr("Link");
    const QString key = who + "/" + QString::fromStdString(notice.topic);
    if (notice.over)
        return emit q.cured(key);
    emit q.noticed(key, {notice.severity, who.toStdString() + ": " + notice.text, notice.topic, false});
}

void Fleet::Private::linkMoved(Robot* robot) {
    const link::LinkStatus& status = robot->view().link;
    const bool connected = status.state == link::LinkState::Connected;
    if (robot == next.get()) {
        emit q.linkChanged(status);
        if (connected)
            emit q.nextConnected();
    } else if (robot->spawned()) {
        emit q.robotLinkChanged(robot->view().id);
    }
    if (robot->isReplay())
        return; // it needs no server
    if (connected)
        emit q.cured("link");
    else if (!status.reason.isEmpty())
        q.note(Severity::Error, "link", status.reason);
}

QString Fleet::nextRobotName() const {
    return d_->roster.nextName();
}

Result<RobotId> Fleet::spawn(SpawnRequest request) {
    if (!d_->next || d_->next->view().link.state != link::LinkState::Connected)
        return failure("there is no link to a server yet", request.robot_name, "Connect first, then spawn");
    const auto accepted = d_->roster.accept(std::move(request));
    if (!accepted)
        return tl::unexpected(accepted.error());
    const RobotId id = d_->roster.nextId();
    if (d_->recording)
        d_->record(*d_->next, *accepted);
    d_->next->spawn(id, *accepted);
    d_->roster.add(std::move(d_->next));
    emit robotAdded(id);
    d_->openNext();
    return id;
}

Robot* Fleet::robot(RobotId id) const {
    return d_->roster.robot(id);
}

std::vector<Robot*> Fleet::robots() const {
    return d_->roster.robots();
}

ConnectionId Fleet::connectionOf(RobotId id) const {
    const Robot* found = !id.valid() ? d_->next.get() : robot(id);
    return found ? found->view().connection : ConnectionId{};
}

Robot* Fleet::Private::robotOn(ConnectionId connection) const {
    return next && next->view().connection == connection ? next.get() : roster.on(connection);
}

Result<void> Fleet::checkLine(ConnectionId connection) const {
    const Robot* robot = d_->robotOn(connection);
    return checkLineTo(robot ? &robot->view() : nullptr);
}

Result<void> Fleet::sendLine(ConnectionId connection, const QString& line, const by::Source& source) {
    if (const auto sendable = checkLine(connection); !sendable)
        return sendable;
    d_->robotOn(connection)->send(protocol::RawCommand{line.toStdString()}, source);
    return {};
}

void Fleet::remove(RobotId id) {
    std::unique_ptr<Robot> robot = d_->roster.take(id);
    if (!robot)
        return;
    robot->disconnect(this);
    const QString name = nameOf(*robot);
    const Robot* const looked_back_on = d_->robotOn(robot->view().looks_back_on);
    const RobotId instead = looked_back_on ? looked_back_on->view().id : d_->roster.first();
    d_->keeper.takeLeave(std::move(robot));
    d_->truths.erase(id);
    d_->rests.remove(id);
    emit robotRemoved(id, name, instead);
}

void Fleet::spawnAgain(RobotId id) {
    if (Robot* robot = this->robot(id); robot && !robot->isReplay())
        robot->spawn(id, robot->view().spawn);
}

Result<void> Fleet::startBehavior(RobotId id, const std::string& behavior_id, const Rectangle& area_in_map,
                                  const std::map<std::string, agent::ParameterValue>& values, const QString& plan_path,
                                  bool isolate) {
    Robot* robot = this->robot(id);
    if (!robot)
        return failure("there is no such robot", std::to_string(id.value), "Spawn one on a start pose first");
    const auto plan = readOwnPlan(plan_path, behavior_id, plugins());
    if (!plan)
        return tl::unexpected(plan.error());
    return d_->start(*robot, {behavior_id, area_in_map, values, *plan, isolate});
}

Result<void> Fleet::startAgain(RobotId id) {
    Robot* robot = this->robot(id);
    if (!robot || !robot->started())
        return failure("no behavior has been started on it", std::to_string(id.value),
                       "Choose a behavior, then start it");
    StartedBehavior start = *robot->started();
    start.isolated = true;
    return robot->view().figures.spawned
               ? d_->start(*robot, start)
               : failure("the robot is gone", robot->view().spawn.robot_name, "Spawn it again first");
}

Result<void> Fleet::Private::start(Robot& robot, const StartedBehavior& start) {
    const auto parameters = checkStart(start, plugins, place);
    if (!parameters)
        return tl::unexpected(parameters.error());
    const auto begun = robot.startBehavior(plugins, start, {*parameters, place.dry_above_m, place.extent_in_map},
                                           behavior_host, missionNote(robot.view(), start, seed, site()));
    if (const std::string notice = beyondWorldNotice(start.area_in_map, place.extent_in_map); begun && !notice.empty())
        q.note(Severity::Warning, missionKey(robot.view().id) + "/area", QString::fromStdString(notice));
    return begun;
}

Result<RobotId> Fleet::flyRest(const std::shared_ptr<const RecordedScan>& earlier) {
    auto request = spawnRequestFor(*earlier, d_->site());
    if (!request)
        return tl::unexpected(request.error());
    const auto id = spawn(*std::move(request));
    if (!id)
        return id;
    robot(*id)->setTaskOptions(earlier->flown.mission);
    d_->rests.add(*id, earlier);
    return id;
}

void Fleet::Private::startRest(Robot& robot) {
    const auto rest = rests.take(robot.view(), site());
    if (!rest)
        return;
    const Result<void> begun = *rest ? start(robot, **rest) : tl::unexpected(rest->error());
    if (!begun)
        return q.note(Severity::Error, missionKey(robot.view().id), QString::fromStdString(begun.error().text()));
    emit q.restBegun(robot.view().id);
}

Result<std::map<std::string, agent::ParameterValue>> Fleet::prepareMission(const Mission& mission) const {
    return checkMission(mission, plugins(), d_->place);
}

void Fleet::stopAll() {
    for (Robot* robot : robots())
        robot->stop();
}

void Fleet::preview(RobotId id, const std::string& behavior_id, const Rectangle& area_in_map,
                    const std::map<std::string, agent::ParameterValue>& values,
                    const agent::PluginLoader::Told& told) const {
    const auto parameters = checkParameters(behavior_id, values, plugins());
    if (!parameters)
        return told(tl::unexpected(parameters.error()));
    const Robot* robot = this->robot(id);
    const Pose start_in_map = robot ? robot->view().spawn.start_in_map : Pose{};
    const Rectangle inside = areaWithin(area_in_map, d_->place.extent_in_map); // As the behavior will be given it.
    plugins().preview(behavior_id, {{"", start_in_map, inside.empty() ? area_in_map : inside}, *parameters}, told);
}

void Fleet::setResultFolder(const QString& folder) {
    d_->keeper.setFolder(folder);
}

QString Fleet::resultFolder() const {
    return d_->keeper.folder();
}

bool Fleet::resultFolderChosen() const {
    return d_->keeper.folderChosen();
}

void Fleet::exportResults(RobotId id) {
    if (Robot* robot = this->robot(id))
        d_->keeper.save(*robot);
}

void Fleet::exportMap(RobotId id, const FormatList& formats, const QString& folder) {
    if (Robot* robot = this->robot(id))
        d_->keeper.exportMap(*robot, formats, folder);
}

void Fleet::cancelSaving() {
    d_->keeper.cancel();
}

void Fleet::Private::finished(Robot* robot, bool success, const QString& reason) {
    const RobotId id = robot->view().id;
    const QString key = missionKey(id);
    const QString text = QString("%1: %2").arg(nameOf(*robot), reason);
    if (robot->view().broke)
        emit q.behaviorBroke(id, key, text);
    else
        q.note(success ? Severity::Note : Severity::Warning, key, text);
    emit q.behaviorFinished(id, success, reason);
    if (!robot->view().tiles.empty())
        keeper.save(*robot); // even where all was saved before: now the end belongs to it
    closeWhenSaved();
}

void Fleet::Private::closeWhenSaved() {
    if (!closing || q.anythingToSave())
        return;
    patience.stop();
    emit q.readyToClose();
}

void Fleet::setPictureLook(const mapping::HeightLook& look) {
    d_->keeper.setPictureLook(look);
}

bool Fleet::anythingToSave() const {
    return d_->keeper.busy() ||
           std::ranges::any_of(robots(), [](const Robot* robot) { return robot->view().unsaved || robot->running(); });
}

void Fleet::prepareToClose() {
    d_->closing = true;
    d_->patience.start();
    d_->keeper.retry();
    for (Robot* robot : robots()) {
        if (robot->running())
            robot->stop(); // what it scanned is saved when it has stopped
        else if (robot->view().unsaved)
            d_->keeper.save(*robot);
    }
    d_->closeWhenSaved();
}

bool Fleet::closing() const {
    return d_->closing;
}

void Fleet::stayOpen() {
    d_->closing = false;
    d_->patience.stop();
}

void Fleet::note(Severity severity, const QString& key, const QString& text) {
    emit noticed(key, {.severity = severity, .text = text.toStdString()});
}

void Fleet::endSessions() {
    d_->opening.clear();
    d_->next.reset();
    d_->roster.clear();
}

} // namespace usar::mission
