#include "app/desks/task_desk.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QScopedValueRollback>

#include "core/mission/fleet/robot_words.h"
#include "core/server/embedded/simulator_files.h"
#include "widgets/models/preview_text.h"

namespace usar::app {

namespace {

/// Notification key of a start that was refused.
QString startKey(RobotId id) {
    return QStringLiteral("start-%1").arg(id.value);
}

} // namespace

TaskDesk::TaskDesk(const DeskContext& context, PluginDesk& plugins) : Desk(context), plugins_(plugins) {
    preview_due_.setSingleShot(true);
    preview_due_.setInterval(std::chrono::milliseconds(150)); // so that a quick preview does not flicker
    connect(&preview_due_, &QTimer::timeout, this,
            [this] { clearPreview(tr("Asking the plugin's process for a preview…")); });
}

void TaskDesk::registerCommands() {
    add("mission.area", [this](bool on) { views_.map->setTool(on ? widgets::MapTool::Area : widgets::MapTool::Pan); });
    const auto runs = [this] { return !chosenAtWork().empty(); };
    const auto ready = [this] {
        return std::ranges::any_of(chosen(), [this](const Robot* robot) { return mayStart(*robot); });
    };
    add("mission.start", ready, [this] { start(); });
    const auto broke = [this] { return brokenRobot().valid(); };
    add("mission.start_again", broke, [this] { startAgain(brokenRobot()); });
    add("mission.pause", runs, [this] { pauseOrResume(); });
    const auto lands = [this] {
        return std::ranges::any_of(chosenAtWork(), [](const Robot* one) { return one->view().equipment.mayFly(); });
    };
    add("mission.land", lands, [this] { give(agent::Order::LandNow); });
    add("mission.stop", runs, [this] { std::ranges::for_each(chosenAtWork(), &Robot::stop); });
    add("mission.stop_all", [this] { control_.stopAll(); });
}

void TaskDesk::wire() {
    auto* const panel = views_.behavior;
    panel->setActions(action("mission.start"), action("mission.pause"), action("mission.land"), action("mission.stop"));
    connect(panel, &widgets::BehaviorPanel::behaviorChosen, this, [this] {
        const mission::TaskDraft before = drafts_.shown();
        showChosenBehavior();
        if (!showing_ && !before.behavior_id.empty())
            edits_.replaced(before, tr("choose behavior"));
    });
    connect(panel, &widgets::BehaviorPanel::isolationChosen, this,
            [this](bool isolated) { plugins_.setIsolated(plugins_.pluginOf(drafts_.shown().behavior_id), isolated); });
    connect(panel, &widgets::BehaviorPanel::adjustChosen, this, [this](bool adjust) {
        const mission::TaskDraft before = drafts_.shown();
        drafts_.shown().adjust = adjust;
        edits_.replaced(before, tr("correct the map"));
    });
    connect(panel, &widgets::BehaviorPanel::limitChosen, this, [this](std::optional<double> hours) {
        const mission::TaskDraft before = drafts_.shown();
        drafts_.shown().limit_h = hours;
        edits_.replaced(before, tr("set the time limit"));
    });
    connect(&plugins_, &PluginDesk::isolationChanged, this, &TaskDesk::showIsolation);
    connect(views_.parameters, &widgets::ParameterForm::changed, this, &TaskDesk::applyParameters);
    connect(&selection_, &Selection::changed, this, &TaskDesk::show);
    connect(&control_, &MissionControl::worldKnown, this,
            [panel](const server::WorldPicture& world) { panel->setAreaLimits(world.extent_in_map); });
    connect(&control_, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses&, const QString& level) { bringBackArea(level); });
    wireArea();
    connect(views_.robots, &widgets::RobotList::chosenChanged, this, [this] {
        refreshRunState();
        commands_.refresh();
    });
    connectUpdates([this](const mission::SessionUpdate& update) {
        takeTask(update);
        refreshRunState();
    });
    connect(&control_, &MissionControl::restBegun, this, &TaskDesk::takeBegun);
    connect(&control_, &MissionControl::behaviorFinished, this, &TaskDesk::refreshRunState);
    connect(&control_, &MissionControl::behaviorBroke, this, &TaskDesk::offerToStartAgain);
    connect(&control_, &MissionControl::replayAdded, this, [this](RobotId id) {
        drafts_.copy(control_.lookedBackOn(id), id); // the selected task was not set up for the replay
    });
    connect(&control_, &MissionControl::robotRemoved, this, [this](RobotId id) {
        if (notices_.offers(missionKey(id)))
            notices_.cure(missionKey(id));
        edits_.forget(id);
        drafts_.forget(id);
    });
}

void TaskDesk::wireArea() {
    auto* const map = views_.map;
    connect(&map->gestures(), &widgets::MapGestures::areaEdited, this, &TaskDesk::setArea);
    connect(&map->gestures(), &widgets::MapGestures::areaChanged, this, [this](const Rectangle& area) {
        notices_.cure("area");
        setArea(area);
        control_.history().endStep();
    });
    connect(&map->gestures(), &widgets::MapGestures::areaRefused, this,
            [this](const QString& reason) { notices_.say(Severity::Warning, "area", reason); });
    connect(&map->gestures(), &widgets::MapGestures::toolChanged, this, [this](widgets::MapTool tool) {
        control_.history().endStep(); // A drag is never one step with what was typed before.
        action("mission.area")->setChecked(tool == widgets::MapTool::Area);
    });
    connect(views_.behavior, &widgets::BehaviorPanel::areaTyped, this, &TaskDesk::setArea);
}

void TaskDesk::restore(const QSettings& settings) {
    last_area_ = mission::LastArea::from(settings);
}

void TaskDesk::save(SettingsSheet& settings) const {
    if (control_.level().isEmpty() || (robot() && robot()->isReplay()))
        return; // The area that was drawn last still counts.
    mission::LastArea{control_.level(), drafts_.shown().area()}.save(settings);
}

void TaskDesk::bringBackArea(const QString& world) {
    if (last_area_.area_in_map.empty() || world != last_area_.world)
        return;
    const Rectangle area = std::exchange(last_area_, {}).area_in_map;
    if (drafts_.shown().area_in_map || (robot() && robot()->isReplay()))
        return;
    views_.behavior->setArea(area);
    views_.map->setArea(area);
    drafts_.shown().area_in_map = area;
    askForPreview();
}

void TaskDesk::leaveWorld() {
    views_.behavior->setArea(std::nullopt);
    views_.behavior->setAreaLimits({}); // until the world is known; that of a real server never is
    edits_.forgetAreas();
    drafts_.forgetAreas();
}

void TaskDesk::showEdited(RobotId robot) {
    selection_.select(robot);
    if (running())
        applyParameters(drafts_.shown().values);
}

void TaskDesk::takePlan() {
    const mission::TaskDraft before = drafts_.shown();
    drafts_.shown().plan_path = views_.behavior->plan().path().toStdString();
    edits_.replaced(before, tr("choose plan"));
}

void TaskDesk::show(RobotId robot_id) {
    const QScopedValueRollback showing(showing_, true);
    drafts_.show(robot_id);
    const mission::TaskDraft draft = drafts_.shown(); // a copy: another list may choose another behavior for a moment
    const Robot* robot = selection_.robot();
    const auto known = control_.plugins().kinds();
    const auto described = std::ranges::find_if(known, [&](const agent::RobotDescription& description) {
        const std::string& wanted = robot ? robot->view().spawn.class_name : wanted_class_;
        return wanted.empty() || description.class_name == wanted;
    });
    auto* const panel = views_.behavior;
    panel->setBehaviors(described == known.end() ? std::vector<agent::BehaviorDescription>() : described->behaviors);
    drafts_.shown() = draft;
    panel->chooseBehavior(draft.behavior_id);
    showChosenBehavior();
    panel->setAdjust(draft.adjust);
    panel->setLimit(draft.limit_h);
    panel->setArea(draft.area_in_map);
    views_.map->setArea(draft.area_in_map);
    refreshRunState();
    askForPreview();
}

void TaskDesk::showChosenBehavior() {
    auto* const panel = views_.behavior;
    auto* const form = views_.parameters;
    const std::string id = panel->behaviorId();
    const auto* behavior = control_.plugins().behavior(id);
    views_.spawn_card->preferBehavior(QString::fromStdString(id));
    form->setSpecs(behavior ? behavior->parameters : std::vector<agent::ParameterSpec>());
    form->setPresets(behavior ? behavior->presets : std::vector<agent::ParameterPreset>());
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

void TaskDesk::setUp(const mission::Mission& mission, const std::map<std::string, agent::ParameterValue>& values) {
    if (mission.isolate)
        plugins_.setIsolated(plugins_.pluginOf(mission.behavior), true);
    const mission::TaskDraft before = drafts_.shown();
    drafts_.shown().take(mission, values);
    edits_.replaced(before, tr("open mission"));
    show(selection_.id());
    views_.map->fit(robot() ? std::nullopt : placeOfStart(mission.start)); // A robot is to be spawned there first.
    applyParameters(drafts_.shown().values);
}

std::optional<Vec2> TaskDesk::placeOfStart(const std::string& name) const {
    const auto& poses = control_.startPoses();
    const auto found = std::ranges::find(poses, name, &protocol::StartPose::name);
    return found == poses.end() ? std::nullopt : std::optional<Vec2>(found->pose_in_map.position_m.head<2>());
}

bool TaskDesk::complete() const {
    const mission::TaskDraft& draft = drafts_.shown();
    return !draft.behavior_id.empty() && !(views_.behavior->needsArea() && draft.area().empty());
}

void TaskDesk::setArea(const Rectangle& area_in_map) {
    edits_.setArea(area_in_map);
    askForPreview();
}

/// Shows the area that the running behavior reports.
void TaskDesk::takeTask(const mission::SessionUpdate& update) {
    auto* const map = views_.map;
    if (!update.task || map->area() == update.task->area_in_map)
        return;
    drafts_.shown().area_in_map = update.task->area_in_map;
    views_.behavior->setArea(update.task->area_in_map);
    map->setArea(update.task->area_in_map);
    map->fit();
}

void TaskDesk::askForPreview() {
    commands_.refresh();
    control_.plugins().forgetPreview();
    preview_due_.stop();
    const mission::TaskDraft& draft = drafts_.shown();
    if (robot() && (robot()->running() || robot()->isReplay()))
        return;
    views_.hint->setAreaNeeded(views_.behavior->needsArea());
    if (!draft.area().empty())
        views_.hint->setDone(widgets::FirstStep::Area);
    if (draft.area().empty() || !views_.behavior->needsArea() || draft.behavior_id.empty())
        return clearPreview({}); // the area form says what to do
    preview_due_.start();
    control_.preview(selection_.id(), draft.behavior_id, draft.area(), draft.values,
                     [this](const auto& preview) { showPreview(preview); });
}

void TaskDesk::showPreview(const Result<agent::TaskPreview>& preview) {
    preview_due_.stop();
    if (!preview) {
        views_.map->setLanes(std::vector<Vec2>{});
        return views_.behavior->setPlanSummary(QString::fromStdString(preview.error().text()));
    }
    const QString summary = widgets::previewText(*preview);
    views_.map->setLanes(preview->path_in_map_m);
    views_.map->setAreaSummary(summary);
    views_.behavior->setPlanSummary(preview->outlook ? summary + QChar('\n') + widgets::outlookText(*preview->outlook)
                                                     : summary);
}

void TaskDesk::clearPreview(const QString& instead) {
    views_.map->setLanes(std::vector<Vec2>{});
    views_.map->setAreaSummary({});
    views_.behavior->setPlanSummary(instead);
}

std::vector<Robot*> TaskDesk::chosen() const {
    std::vector<Robot*> robots;
    for (const RobotId id : views_.robots->chosenRobots())
        if (Robot* const one = control_.robot(id))
            robots.push_back(one);
    if (std::ranges::find(robots, robot()) == robots.end()) // The list has not heard of the selection yet.
        robots.assign(robot() ? 1 : 0, robot());
    return robots;
}

std::vector<Robot*> TaskDesk::chosenAtWork() const {
    std::vector<Robot*> robots = chosen();
    std::erase_if(robots, [](const Robot* one) { return !one->running(); });
    return robots;
}

QString TaskDesk::addressees() const {
    QStringList names;
    for (const Robot* const one : chosen())
        names << nameOf(*one);
    return mission::robotsText(names);
}

bool TaskDesk::mayStart(const Robot& robot) {
    return robot.view().figures.spawned && !robot.running() && !robot.isReplay() &&
           control_.plugins().behavior(drafts_.of(robot.view().id).behavior_id);
}

void TaskDesk::start() {
    for (Robot* const one : chosen())
        if (mayStart(*one) && startOne(*one) && one == robot())
            showStarted();
    refreshRunState();
    commands_.refresh();
}

bool TaskDesk::startOne(Robot& robot) {
    const RobotId id = robot.view().id;
    const mission::TaskDraft& draft = drafts_.of(id);
    robot.setTaskOptions(draft.mission());
    const auto started = control_.startBehavior(id, draft.behavior_id, draft.area(), draft.values,
                                                QString::fromStdString(draft.plan_path),
                                                plugins_.isolates(plugins_.pluginOf(draft.behavior_id)));
    if (!started) {
        notices_.complain(startKey(id), started.error());
        return false;
    }
    begin(id);
    return true;
}

void TaskDesk::takeBegun(RobotId id) {
    begin(id);
    if (robot() && robot()->view().id == id)
        showStarted();
    refreshRunState();
    commands_.refresh();
}

void TaskDesk::showStarted() {
    control_.plugins().forgetPreview(); // from now on the behavior itself reports its task
    preview_due_.stop();
    emit faultsWanted(server::textsOf(drafts_.shown().faults));
    views_.hint->setDone(widgets::FirstStep::Start);
    views_.map->setAreaSummary({}); // the summary showed the preview's figures
    views_.map->fit();
}

void TaskDesk::begin(RobotId id) {
    notices_.cure(startKey(id));
    if (notices_.offers(missionKey(id)))
        notices_.cure(missionKey(id));
    emit begun(id);
}

void TaskDesk::startAgain(RobotId id) {
    if (const auto started = control_.startAgain(id); !started)
        return notices_.complain(startKey(id), started.error());
    begin(id);
    refreshRunState();
    commands_.refresh();
}

RobotId TaskDesk::brokenRobot() const {
    const Robot* const broken = mission::brokenRobot(control_.robots(), robot());
    return broken ? broken->view().id : RobotId{};
}

void TaskDesk::offerToStartAgain(RobotId id, const QString& key, const QString& text) {
    const QString name = QString::fromStdString(control_.robot(id)->view().spawn.robot_name);
    const bool was_isolated = control_.robot(id)->started()->isolated;
    QString help = was_isolated ? tr("The same behavior with the same parameters")
                                : tr("The same behavior with the same parameters, in a separate process, where it "
                                     "can disturb nothing else");
    help += " (" + action("mission.start_again")->shortcut().toString(QKeySequence::NativeText) + ")";
    notices_.offer(Severity::Warning, key, text, {tr("Start %1 again").arg(name), help},
                   [this, id] { startAgain(id); });
    commands_.refresh();
}

void TaskDesk::give(agent::Order order) {
    for (Robot* const one : chosenAtWork())
        one->order(order);
    refreshRunState();
}

void TaskDesk::pauseOrResume() {
    const std::vector<Robot*> robots = chosenAtWork();
    const bool all_paused = std::ranges::all_of(robots, [](const Robot* one) { return one->view().paused; });
    for (Robot* const one : robots)
        if (all_paused || !one->view().paused)
            one->order(all_paused ? agent::Order::Resume : agent::Order::Pause);
    refreshRunState();
}

void TaskDesk::refreshRunState() {
    using widgets::RunState;
    RunState state = RunState::NoRobot;
    if (running())
        state = robot()->view().paused ? RunState::Paused : RunState::Running;
    else if (robot() && robot()->isReplay())
        state = RunState::Replay;
    else if (robot() && robot()->view().figures.spawned)
        state = RunState::Ready;
    action("mission.land")->setVisible(!robot() || robot()->view().equipment.mayFly());
    if (!views_.behavior->setRunState(state, addressees()))
        return;
    commands_.refresh();
    emit situationChanged();
}

void TaskDesk::applyParameters(std::map<std::string, agent::ParameterValue> values) {
    const auto* chosen = control_.plugins().behavior(drafts_.shown().behavior_id);
    edits_.setValues(values, chosen ? chosen->parameters : std::vector<agent::ParameterSpec>());
    if (!running())
        return askForPreview();
    const auto* behavior = control_.plugins().behavior(robot()->view().behavior_id);
    if (!behavior)
        return;
    const auto parameters = agent::ParameterSet::make(behavior->parameters, values);
    if (!parameters)
        return notices_.complain("parameters", parameters.error());
    robot()->setParameters(*parameters);
}

} // namespace usar::app
