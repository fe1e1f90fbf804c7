#include "app/desks/task_desk.h"

#include <algorithm>
#include <chrono>

#include "core/server/embedded/simulator_files.h"
#include "widgets/models/figures.h"

namespace usar::app {

TaskDesk::TaskDesk(const DeskContext& context, PluginDesk& plugins) : desk_(context), plugins_(plugins) {
    preview_due_.setSingleShot(true);
    preview_due_.setInterval(std::chrono::milliseconds(150)); // so that a quick preview does not flicker
    connect(&preview_due_, &QTimer::timeout, this,
            [this] { clearPreview(tr("Asking the plugin's process what this would come to…")); });
}

void TaskDesk::registerCommands() {
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

void TaskDesk::registerRunCommands() {
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

void TaskDesk::wire() {
    auto* const panel = desk_.views.behavior;
    panel->setActions(desk_.commands.action("mission.start"), desk_.commands.action("mission.pause"),
                      desk_.commands.action("mission.land"), desk_.commands.action("mission.stop"));
    connect(panel, &widgets::BehaviorPanel::behaviorChosen, this, &TaskDesk::showChosenBehavior);
    connect(panel, &widgets::BehaviorPanel::isolationChosen, this,
            [this](bool isolated) { plugins_.setIsolated(plugins_.pluginOf(drafts_.shown().behavior_id), isolated); });
    connect(&plugins_, &PluginDesk::isolationChanged, this, &TaskDesk::showIsolation);
    connect(desk_.views.parameters, &widgets::ParameterForm::changed, this, &TaskDesk::applyParameters);
    connect(&desk_.selection, &Selection::changed, this, &TaskDesk::show);
    connect(&desk_.control, &MissionControl::worldKnown, this,
            [panel](const server::WorldPicture& world) { panel->setAreaLimits(world.extent_in_map); });
    wireArea();
    wireRun();
}

void TaskDesk::wireArea() {
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

void TaskDesk::wireRun() {
    connect(&desk_.control, &MissionControl::robotUpdated, this, [this](int id, const auto& update) {
        if (id != desk_.selection.id())
            return;
        takeTask(*update);
        refreshRunState();
    });
    connect(&desk_.control, &MissionControl::behaviorFinished, this, &TaskDesk::refreshRunState);
    connect(&desk_.control, &MissionControl::behaviorBroke, this, &TaskDesk::offerToStartAgain);
    connect(&desk_.control, &MissionControl::replayAdded, this, [this](int id) {
        drafts_.copy(desk_.control.lookedBackOn(id), id); // the selected task was not set up for the replay
    });
    connect(&desk_.control, &MissionControl::robotRemoved, this, [this](int id) {
        if (desk_.notices.offers(missionKey(id)))
            desk_.notices.cure(missionKey(id));
        drafts_.forget(id);
    });
}

void TaskDesk::leaveWorld() {
    desk_.views.behavior->setArea(std::nullopt);
    desk_.views.behavior->clearAreaLimits(); // until the world is known; that of a real server never is
    drafts_.forgetAreas();
}

void TaskDesk::show(int robot_id) {
    drafts_.show(robot_id);
    const mission::TaskDraft draft = drafts_.shown(); // a copy: another list may choose another behavior for a moment
    const Robot* robot = desk_.selection.robot();
    const auto known = desk_.control.plugins().kinds();
    const auto described = std::ranges::find_if(known, [&](const agent::RobotDescription& description) {
        const std::string& wanted = robot ? robot->view().spawn.class_name : wanted_class_;
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

void TaskDesk::showChosenBehavior() {
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
    if (behavior) { // a plugin that has not answered yet has no form; the draft is kept for it
        draft.values = form->values();
        draft.plan_path = panel->plan().path().toStdString();
    }
    showIsolation();
    emit situationChanged();
    askForPreview();
}

void TaskDesk::showIsolation() {
    desk_.views.behavior->setIsolated(isolated());
}

void TaskDesk::takePlan() {
    drafts_.shown().plan_path = desk_.views.behavior->plan().path().toStdString();
}

void TaskDesk::setUp(const mission::Mission& mission, const std::map<std::string, agent::ParameterValue>& values) {
    if (mission.isolate)
        plugins_.setIsolated(plugins_.pluginOf(mission.behavior), true);
    drafts_.shown().take(mission, values);
    show(desk_.selection.id());
    desk_.views.map->fit();
    applyParameters(drafts_.shown().values);
}

bool TaskDesk::isolated() const {
    return plugins_.isolates(plugins_.pluginOf(drafts_.shown().behavior_id));
}

bool TaskDesk::complete() const {
    const mission::TaskDraft& draft = drafts_.shown();
    return !draft.behavior_id.empty() && !(desk_.views.behavior->needsArea() && draft.area().empty());
}

void TaskDesk::setArea(const Rectangle& area_in_map) {
    drafts_.shown().area_in_map = area_in_map.empty() ? std::nullopt : std::optional(area_in_map);
    askForPreview();
}

/// Shows the area that the running behavior reports.
void TaskDesk::takeTask(const mission::SessionUpdate& update) {
    auto* const map = desk_.views.map;
    if (!update.task || map->area() == update.task->area_in_map)
        return;
    drafts_.shown().area_in_map = update.task->area_in_map;
    desk_.views.behavior->setArea(update.task->area_in_map);
    map->setArea(update.task->area_in_map);
    map->fit();
}

void TaskDesk::askForPreview() {
    desk_.commands.refresh();
    desk_.control.plugins().forgetPreview();
    preview_due_.stop();
    const mission::TaskDraft& draft = drafts_.shown();
    const Robot* robot = desk_.selection.robot();
    if (robot && (robot->running() || robot->isReplay()))
        return;
    desk_.views.hint->setDone(1, !draft.area().empty());
    if (draft.area().empty() || !desk_.views.behavior->needsArea() || draft.behavior_id.empty())
        return clearPreview({}); // the area form says what to do
    preview_due_.start();
    desk_.control.preview(desk_.selection.id(), draft.behavior_id, draft.area(), draft.values,
                          [this](const auto& preview) { showPreview(preview); });
}

void TaskDesk::showPreview(const Result<agent::TaskPreview>& preview) {
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

void TaskDesk::clearPreview(const QString& instead) {
    desk_.views.map->setLanes(std::vector<Vec2>{});
    desk_.views.map->setAreaSummary({});
    desk_.views.behavior->setPlanSummary(instead);
}

void TaskDesk::start() {
    const int id = desk_.selection.id();
    const mission::TaskDraft& draft = drafts_.shown();
    if (Robot* robot = desk_.selection.robot(); robot && robot->setCellSize(draft.cell_size_m))
        desk_.views.map->heights().clear(draft.cell_size_m);
    const auto started = desk_.control.startBehavior(id, draft.behavior_id, draft.area(), draft.values,
                                                     QString::fromStdString(draft.plan_path), isolated());
    if (!started)
        return desk_.notices.complain("start", started.error());
    desk_.control.plugins().forgetPreview(); // from now on the behavior itself reports its task
    preview_due_.stop();
    begin(id);
    emit faultsWanted(server::textsOf(draft.faults));
    desk_.views.hint->setDone(2, true);
    desk_.views.map->setAreaSummary({}); // the summary showed the preview's figures
    desk_.views.map->fit();
    refreshRunState();
}

void TaskDesk::begin(int id) {
    desk_.notices.cure("start");
    if (desk_.notices.offers(missionKey(id)))
        desk_.notices.cure(missionKey(id));
    emit begun(id);
}

void TaskDesk::startAgain(int id) {
    if (const auto started = desk_.control.startAgain(id); !started)
        return desk_.notices.complain("start", started.error());
    begin(id);
    refreshRunState();
    desk_.commands.refresh();
}

int TaskDesk::brokenRobot() const {
    const auto broke = [](const Robot* robot) { return robot && robot->view().broke && robot->view().figures.spawned; };
    if (broke(desk_.selection.robot()))
        return desk_.selection.id();
    const auto robots = desk_.control.robots();
    const auto found = std::ranges::find_if(robots, broke);
    return found == robots.end() ? 0 : (*found)->view().id;
}

void TaskDesk::offerToStartAgain(int id, const QString& key, const QString& text) {
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

void TaskDesk::give(agent::Order order) {
    if (Robot* robot = desk_.selection.robot())
        robot->order(order);
    refreshRunState();
}

bool TaskDesk::running() const {
    const Robot* robot = desk_.selection.robot();
    return robot && robot->running();
}

void TaskDesk::refreshRunState() {
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

void TaskDesk::applyParameters(const std::map<std::string, agent::ParameterValue>& values) {
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

} // namespace usar::app
