#include "app/desks/mission_desk.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>

#include "core/mission/files/mission_writer.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"
#include "widgets/models/figures.h"

namespace usar::app {

MissionDesk::MissionDesk(const DeskContext& context, PluginDesk& plugins, ServerDesk& server)
    : desk_(context)
    , plugins_(plugins)
    , server_(server) {
    preview_due_.setSingleShot(true);
    preview_due_.setInterval(std::chrono::milliseconds(150)); // Avoids flicker if the preview is quick.
    connect(&preview_due_, &QTimer::timeout, this,
            [this] { clearPreview(tr("Asking the plugin's process what this would come to…")); });
}

void MissionDesk::registerCommands() {
    desk_.commands.add({"file.open",
                        tr("Open mission…"),
                        tr("File"),
                        tr("Area, behavior and parameters from a mission file"),
                        "open",
                        {QKeySequence::Open}},
                       [this](bool) { chooseFile(); });
    desk_.commands.add(
        {"file.save",
         tr("Save mission as…"),
         tr("File"),
         tr("Area, behavior and parameters of the selected robot as a mission file"),
         "",
         {QKeySequence::SaveAs}},
        [this](bool) { chooseWhereToSave(); }, [this] { return mayBeSaved(); });
    desk_.commands.add(
        {"mission.area",
         tr("Draw mission area"),
         tr("Mission"),
         tr("Drag a rectangle on the map"),
         "area",
         {QKeySequence("A")},
         true},
        [this](bool on) { desk_.views.map->setTool(on ? widgets::MapTool::Area : widgets::MapTool::Pan); });
    registerRunCommands();
}

void MissionDesk::registerRunCommands() {
    const auto runs = [this] { return running(); };
    desk_.commands.add(
        {"mission.start",
         tr("Start behavior"),
         tr("Mission"),
         tr("With this area and these parameters"),
         "play",
         {QKeySequence("Ctrl+Return")}},
        [this](bool) { start(); },
        [this] {
            const Robot* robot = desk_.selection.robot();
            return robot && robot->view().figures.spawned && !running() && !robot->isReplay() &&
                   desk_.control.plugins().behavior(drafts_.shown().behavior_id);
        });
    desk_.commands.add(
        {"mission.start_again",
         tr("Start again what broke"),
         tr("Mission"),
         tr("A behavior that threw, hung or died: the same with the same parameters, in a process of its own"),
         "play",
         {QKeySequence("Ctrl+Shift+Return")}},
        [this](bool) { startAgain(brokenRobot()); }, [this] { return brokenRobot() != 0; });
    desk_.commands.add(
        {"mission.pause",
         tr("Pause or resume"),
         tr("Mission"),
         tr("The robot holds its position"),
         "pause",
         {QKeySequence("P")}},
        [this](bool) {
            const Robot* robot = desk_.selection.robot();
            give(robot && robot->view().paused ? agent::Order::Resume : agent::Order::Pause);
        },
        runs);
    desk_.commands.add(
        {"mission.land",
         tr("Land now"),
         tr("Mission"),
         tr("Here; what was scanned is kept"),
         "land",
         {QKeySequence("L")}},
        [this](bool) { give(agent::Order::LandNow); }, runs);
    desk_.commands.add(
        {"mission.stop",
         tr("Stop this robot"),
         tr("Mission"),
         tr("Ends its behavior with its safe command; what was scanned is kept"),
         "stop",
         {QKeySequence("Ctrl+Backspace")}},
        [this](bool) {
            if (Robot* robot = desk_.selection.robot())
                robot->stop();
        },
        runs);
    desk_.commands.add({"mission.stop_all",
                        tr("Stop all robots"),
                        tr("Mission"),
                        tr("At once; Escape twice does the same"),
                        "stop",
                        {QKeySequence("Ctrl+.")}},
                       [this](bool) { desk_.control.stopAll(); });
}

void MissionDesk::wire() {
    auto* const panel = desk_.views.behavior;
    panel->setActions(desk_.commands.action("mission.start"), desk_.commands.action("mission.pause"),
                      desk_.commands.action("mission.land"), desk_.commands.action("mission.stop"));
    connect(panel, &widgets::BehaviorPanel::behaviorChosen, this, &MissionDesk::showChosenBehavior);
    connect(panel, &widgets::BehaviorPanel::isolationChosen, this,
            [this](bool isolated) { plugins_.setIsolated(plugins_.pluginOf(drafts_.shown().behavior_id), isolated); });
    connect(&plugins_, &PluginDesk::isolationChanged, this, &MissionDesk::showIsolation);
    connect(desk_.views.parameters, &widgets::ParameterForm::changed, this, &MissionDesk::applyParameters);
    connect(&desk_.selection, &Selection::changed, this, &MissionDesk::show);
    connect(&desk_.control, &MissionControl::worldKnown, this,
            [panel](const server::WorldPicture& world) { panel->setAreaLimits(world.extent_in_map); });
    connect(&desk_.control, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses&, const QString& level) {
                if (awaiting_world_ && awaiting_world_->world == level.toStdString())
                    setUp(*std::exchange(awaiting_world_, std::nullopt));
            });
    wireArea();
    wireRun();
}

void MissionDesk::wireArea() {
    auto* const map = desk_.views.map;
    auto* const panel = desk_.views.behavior;
    connect(map, &widgets::MapView::areaEdited, this, [this, panel](const Rectangle& area) {
        panel->setArea(area);
        setArea(area);
    });
    connect(map, &widgets::MapView::areaChanged, this, [this, map, panel](const Rectangle& area) {
        panel->setArea(area);
        map->setTool(widgets::MapTool::Pan);
        desk_.notices.cure("area");
        setArea(area);
    });
    connect(map, &widgets::MapView::areaRefused, this,
            [this](const QString& reason) { desk_.notices.say(Severity::Warning, "area", reason); });
    connect(map, &widgets::MapView::toolChanged, this, [this, panel](widgets::MapTool tool) {
        const bool drawing = tool == widgets::MapTool::Area;
        panel->setAreaToolActive(drawing);
        desk_.commands.action("mission.area")->setChecked(drawing);
    });
    connect(panel, &widgets::BehaviorPanel::areaTyped, this, [this, map](const Rectangle& area) {
        map->setArea(area.empty() ? std::nullopt : std::optional(area));
        setArea(area);
    });
    connect(panel, &widgets::BehaviorPanel::areaToolToggled, map,
            [map](bool active) { map->setTool(active ? widgets::MapTool::Area : widgets::MapTool::Pan); });
}

void MissionDesk::wireRun() {
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this](int id, const auto& update) {
        if (id != desk_.selection.id())
            return;
        takeTask(*update);
        refreshRunState();
    });
    connect(&desk_.control, &MissionControl::behaviorFinished, this, &MissionDesk::refreshRunState);
    connect(&desk_.control, &MissionControl::behaviorBroke, this, &MissionDesk::offerToStartAgain);
    connect(&desk_.control, &MissionControl::replayAdded, this, [this](int id) {
        drafts_.copy(desk_.control.lookedBackOn(id), id); // A replay starts from the draft of its robot.
    });
    connect(&desk_.control, &MissionControl::robotRemoved, this, [this](int id) {
        if (desk_.notices.offers(missionKey(id)))
            desk_.notices.cure(missionKey(id));
        drafts_.forget(id);
    });
}

void MissionDesk::leaveWorld() {
    desk_.views.behavior->setArea(std::nullopt);
    desk_.views.behavior->clearAreaLimits(); // Until the world is known, which a real server's never is.
    drafts_.forgetAreas();
}

void MissionDesk::show(int robot_id) {
    drafts_.show(robot_id);
    const mission::TaskDraft draft = drafts_.shown(); // A copy: setBehaviors may briefly choose another behavior.
    const Robot* robot = desk_.selection.robot();
    const auto known = desk_.control.plugins().kinds();
    const auto described = std::ranges::find_if(known, [&](const agent::RobotDescription& description) {
        const std::string& wanted = robot ? robot->view().spawn.class_name : next_class_;
        return wanted.empty() || description.class_name == wanted;
    });
    auto* const panel = desk_.views.behavior;
    panel->setBehaviors(described == known.end() ? std::vector<agent::BehaviorDescription>() : described->behaviors);
    drafts_.shown() = draft;
    panel->chooseBehavior(draft.behavior_id);
    showChosenBehavior();
    panel->setArea(draft.area_in_map);
    desk_.views.map->setArea(draft.area_in_map);
    refreshRunState();
    askForPreview();
}

void MissionDesk::showChosenBehavior() {
    auto* const panel = desk_.views.behavior;
    auto* const form = desk_.views.parameters;
    const std::string id = panel->behaviorId();
    const auto* behavior = desk_.control.plugins().behavior(id);
    desk_.views.spawn_card->preferBehavior(QString::fromStdString(id));
    form->setSpecs(behavior ? behavior->parameters : std::vector<agent::ParameterSpec>());
    mission::TaskDraft& draft = drafts_.shown();
    if (draft.behavior_id == id) {
        form->setValues(draft.values);
        panel->plan().choose(QString::fromStdString(draft.plan_path));
    }
    draft.choose(id);
    if (behavior) { // Otherwise its plugin has not answered yet and has no form, so the draft is kept.
        draft.values = form->values();
        draft.plan_path = panel->plan().path().toStdString();
    }
    showIsolation();
    emit situationChanged();
    askForPreview();
}

void MissionDesk::showIsolation() {
    desk_.views.behavior->setIsolated(plugins_.isolates(plugins_.pluginOf(drafts_.shown().behavior_id)));
}

void MissionDesk::takePlan() {
    drafts_.shown().plan_path = desk_.views.behavior->plan().path().toStdString();
}

void MissionDesk::takePlugins() {
    desk_.selection.select(desk_.selection.id());
    if (awaiting_plugin_)
        setUp(*std::exchange(awaiting_plugin_, std::nullopt)); // It may have to wait again.
}

void MissionDesk::setArea(const Rectangle& area_in_map) {
    drafts_.shown().area_in_map = area_in_map.empty() ? std::nullopt : std::optional(area_in_map);
    askForPreview();
}

/// Shows the area that a behavior in a replay works on.
void MissionDesk::takeTask(const mission::SessionUpdate& update) {
    auto* const map = desk_.views.map;
    if (!update.task || map->area() == update.task->area_in_map)
        return;
    drafts_.shown().area_in_map = update.task->area_in_map;
    desk_.views.behavior->setArea(update.task->area_in_map);
    map->setArea(update.task->area_in_map);
    map->fit();
}

void MissionDesk::askForPreview() {
    desk_.commands.refresh();
    desk_.control.forgetPreview();
    preview_due_.stop();
    const mission::TaskDraft& draft = drafts_.shown();
    const Robot* robot = desk_.selection.robot();
    if (robot && (robot->running() || robot->isReplay()))
        return;
    desk_.views.hint->setDone(1, !draft.area().empty());
    if (draft.area().empty() || !desk_.views.behavior->needsArea() || draft.behavior_id.empty())
        return clearPreview({}); // The area form says what to do.
    preview_due_.start();
    desk_.control.preview(desk_.selection.id(), draft.behavior_id, draft.area(), draft.values,
                          [this](const auto& preview) { showPreview(preview); });
}

void MissionDesk::showPreview(const Result<agent::TaskPreview>& preview) {
    preview_due_.stop();
    if (!preview) {
        desk_.views.map->setLanes(std::vector<Vec2>{});
        return desk_.views.behavior->setPlanSummary(QString::fromStdString(preview.error().text()));
    }
    const QString summary = tr("%1 · %2 m · %3")
                                .arg(QString::fromStdString(preview->summary), widgets::figure(preview->length_m, 0),
                                     widgets::durationText(preview->duration));
    desk_.views.map->setLanes(preview->path_in_map_m);
    desk_.views.map->setAreaSummary(summary);
    desk_.views.behavior->setPlanSummary(summary);
}

void MissionDesk::clearPreview(const QString& instead) {
    desk_.views.map->setLanes(std::vector<Vec2>{});
    desk_.views.map->setAreaSummary({});
    desk_.views.behavior->setPlanSummary(instead);
}

void MissionDesk::start() {
    const int id = desk_.selection.id();
    const mission::TaskDraft& draft = drafts_.shown();
    if (Robot* robot = desk_.selection.robot(); robot && robot->setCellSize(draft.cell_size_m))
        desk_.views.map->clearHeights(draft.cell_size_m);
    const bool isolated = plugins_.isolates(plugins_.pluginOf(draft.behavior_id));
    const auto started = desk_.control.startBehavior(id, draft.behavior_id, draft.area(), draft.values,
                                                     QString::fromStdString(draft.plan_path), isolated);
    if (!started)
        return desk_.notices.complain("start", started.error());
    desk_.control.forgetPreview(); // The behavior now publishes its own path.
    preview_due_.stop();
    begin(id);
    emit faultsWanted(server::textsOf(draft.faults));
    desk_.views.hint->setDone(2, true);
    desk_.views.map->setAreaSummary({}); // It showed the preview's figures.
    desk_.views.map->fit();
    refreshRunState();
}

void MissionDesk::begin(int id) {
    desk_.notices.cure("start");
    if (desk_.notices.offers(missionKey(id)))
        desk_.notices.cure(missionKey(id));
    emit begun(id);
}

void MissionDesk::startAgain(int id) {
    if (const auto started = desk_.control.startAgain(id); !started)
        return desk_.notices.complain("start", started.error());
    begin(id);
    refreshRunState();
    desk_.commands.refresh();
}

int MissionDesk::brokenRobot() const {
    const auto broke = [](const Robot* robot) { return robot && robot->view().broke && robot->view().figures.spawned; };
    if (broke(desk_.selection.robot()))
        return desk_.selection.id();
    const auto robots = desk_.control.robots();
    const auto found = std::ranges::find_if(robots, broke);
    return found == robots.end() ? 0 : (*found)->view().id;
}

void MissionDesk::offerToStartAgain(int id, const QString& key, const QString& text) {
    const QString name = QString::fromStdString(desk_.control.robot(id)->view().spawn.robot_name);
    const bool was_isolated = desk_.control.robot(id)->started()->isolated;
    QString help = was_isolated ? tr("The same behavior with the same parameters")
                                : tr("The same behavior with the same parameters, in a process of its own, where it "
                                     "can disturb nothing else");
    help += " (" + desk_.commands.action("mission.start_again")->shortcut().toString(QKeySequence::NativeText) + ")";
    desk_.notices.offer(Severity::Warning, key, text, {tr("Start %1 again").arg(name), help},
                        [this, id] { startAgain(id); });
    desk_.commands.refresh();
}

void MissionDesk::give(agent::Order order) {
    if (Robot* robot = desk_.selection.robot())
        robot->order(order);
    refreshRunState();
}

bool MissionDesk::running() const {
    const Robot* robot = desk_.selection.robot();
    return robot && robot->running();
}

void MissionDesk::refreshRunState() {
    using widgets::RunState;
    const Robot* robot = desk_.selection.robot();
    RunState state = RunState::NoRobot;
    if (robot && robot->running())
        state = robot->view().paused ? RunState::Paused : RunState::Running;
    else if (robot && robot->isReplay())
        state = RunState::Replay;
    else if (robot && robot->view().figures.spawned)
        state = RunState::Ready;
    const QString name = robot ? QString::fromStdString(robot->view().spawn.robot_name) : QString();
    if (!desk_.views.behavior->setRunState(state, name))
        return;
    desk_.commands.refresh();
    emit situationChanged();
}

void MissionDesk::applyParameters(const std::map<std::string, agent::ParameterValue>& values) {
    drafts_.shown().values = values;
    if (!running())
        return askForPreview();
    Robot* robot = desk_.selection.robot();
    const auto* behavior = desk_.control.plugins().behavior(robot->view().behavior_id);
    if (!behavior)
        return;
    const auto parameters = agent::ParameterSet::make(behavior->parameters, values);
    if (!parameters)
        return desk_.notices.complain("parameters", parameters.error());
    robot->setParameters(*parameters);
}

void MissionDesk::openMission(const QString& path) {
    const auto mission = mission::readMissionFile(path);
    if (!mission)
        return desk_.notices.complain("mission", mission.error());
    awaiting_plugin_.reset();
    if (const QString world = worldToOpenFor(*mission); !world.isEmpty()) {
        server_.openWorld(world);
        awaiting_world_ = *mission;
        return;
    }
    setUp(*mission);
}

QString MissionDesk::worldToOpenFor(const mission::Mission& mission) const {
    const QString wanted = QString::fromStdString(mission.world);
    const bool may_change = desk_.control.server().embedded && desk_.control.robots().empty();
    return may_change && server_.world() != wanted && server::worldNames().contains(wanted) ? wanted : QString();
}

void MissionDesk::setUp(const mission::Mission& mission) {
    if (desk_.control.plugins().isAsked(mission.behavior)) {
        awaiting_plugin_ = mission;
        return;
    }
    const auto prepared = desk_.control.prepareMission(mission);
    if (!prepared)
        return desk_.notices.complain("mission", prepared.error());
    if (const auto faults = server::readFaults(server::textsOf(mission.faults)); !faults)
        return desk_.notices.complain("mission", mission::atValue(mission, "faults", faults.error()));
    selectRobotFor(mission.robot_class);
    desk_.views.behavior->chooseBehavior(mission.behavior);
    if (drafts_.shown().behavior_id != mission.behavior)
        return desk_.notices.complain(
            "mission", mission::atValue(mission, "behavior",
                                        {"this behavior does not drive the mission's robot", mission.robot_class,
                                         "Name the robot that " + mission.behavior + " is for"}));
    if (mission.isolate)
        plugins_.setIsolated(plugins_.pluginOf(mission.behavior), true);
    drafts_.shown().take(mission, *prepared);
    show(desk_.selection.id());
    desk_.views.map->fit();
    applyParameters(drafts_.shown().values);
    desk_.notices.cure("mission");
    const QString name = QString::fromStdString(mission.name);
    desk_.notices.say(Severity::Note, "mission-ready",
                      desk_.selection.id() == 0
                          ? tr("Mission %1 is ready. Double-click the start pose %2: a %3 comes. Then press Start.")
                                .arg(name, QString::fromStdString(mission.start),
                                     QString::fromStdString(mission.robot_class).section('.', -1))
                          : tr("Mission %1 is ready. Press Start.").arg(name));
}

void MissionDesk::selectRobotFor(const std::string& robot_class) {
    const auto fits = [&](const Robot* robot) {
        return robot && !robot->isReplay() && robot->view().spawn.class_name == robot_class;
    };
    if (fits(desk_.selection.robot()))
        return;
    const std::vector<Robot*> robots = desk_.control.robots();
    const auto idle = std::ranges::find_if(robots, [&](const Robot* one) { return fits(one) && !one->running(); });
    next_class_ = robot_class;
    desk_.views.spawn_card->chooseClass(QString::fromStdString(robot_class));
    desk_.selection.select(idle == robots.end() ? 0 : (*idle)->view().id);
}

std::string MissionDesk::startName() const {
    const Robot* robot = desk_.selection.robot();
    const auto& poses = desk_.control.startPoses();
    for (const protocol::StartPose& pose : poses)
        if (robot && pose.pose_in_map.position_m.isApprox(robot->view().spawn.start_in_map.position_m))
            return pose.name;
    return poses.empty() ? mission::Mission{}.start : poses.front().name;
}

bool MissionDesk::mayBeSaved() const {
    const mission::TaskDraft& draft = drafts_.shown();
    return !draft.behavior_id.empty() && !(desk_.views.behavior->needsArea() && draft.area().empty());
}

void MissionDesk::saveMission(const QString& path) {
    const mission::TaskDraft& draft = drafts_.shown();
    const auto* behavior = desk_.control.plugins().behavior(draft.behavior_id);
    if (!behavior)
        return desk_.notices.say(Severity::Warning, "mission",
                                 tr("No behavior is chosen. Choose what the robot is to do first."));
    if (!mayBeSaved())
        return desk_.notices.say(Severity::Warning, "mission",
                                 tr("There is no mission area to save. Draw one on the map first."));
    mission::Mission mission = draft.mission();
    mission.name = QFileInfo(path).completeBaseName().toStdString();
    mission.world = desk_.control.level().toStdString();
    if (const Robot* robot = desk_.selection.robot())
        mission.robot_class = robot->view().spawn.class_name;
    mission.start = startName();
    mission.isolate = plugins_.isolates(plugins_.pluginOf(draft.behavior_id));
    if (const auto saved = mission::writeMissionFile(mission, behavior->parameters, path); !saved)
        return desk_.notices.complain("mission", saved.error());
    desk_.notices.cure("mission");
    desk_.notices.note("mission-saved", tr("Saved the mission %1; usar-mission run flies it, too.").arg(path));
}

void MissionDesk::chooseFile() {
    const QString path = QFileDialog::getOpenFileName(desk_.window, tr("Open mission"), {}, tr("Missions (*.json)"));
    if (!path.isEmpty())
        openMission(path);
}

void MissionDesk::chooseWhereToSave() {
    const QString path =
        QFileDialog::getSaveFileName(desk_.window, tr("Save mission"), tr("mission.json"), tr("Missions (*.json)"));
    if (!path.isEmpty())
        saveMission(QFileInfo(path).suffix().isEmpty() ? path + ".json" : path);
}

} // namespace usar::app
