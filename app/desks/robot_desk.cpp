#include "app/desks/robot_desk.h"

#include "core/protocol/commands/spawn.h"

namespace usar::app {

RobotDesk::RobotDesk(const DeskContext& context) : desk_(context), presenter_(context.control, context.views) {
    listClasses();
}

void RobotDesk::registerCommands() {
    for (int id = 1; id <= 9; ++id)
        desk_.commands.add(
            {QString("robot.select_%1").arg(id),
             tr("Select robot %1").arg(id),
             tr("Robots"),
             tr("Shows its instruments, sensors and map"),
             "",
             {QKeySequence(QString::number(id))}},
            [this, id](bool) { desk_.selection.select(id); },
            [this, id] { return desk_.control.robot(id) != nullptr; });
    desk_.commands.add(
        {"robot.spawn_again",
         tr("Spawn again"),
         tr("Robots"),
         tr("For a robot that did not come, or was lost with its link: same class, name and start pose"),
         "",
         {QKeySequence("Ctrl+R")}},
        [this](bool) { desk_.control.spawnAgain(desk_.selection.id()); },
        [this] {
            const Robot* robot = desk_.selection.robot();
            return robot && !robot->isReplay() && !robot->view().figures.spawned &&
                   robot->view().link.state == link::LinkState::Connected;
        });
    desk_.commands.add(
        {"robot.remove",
         tr("Remove robot"),
         tr("Robots"),
         tr("Saves what it scanned and closes its connection; the server takes it away"),
         "",
         {}},
        [this](bool) { desk_.control.remove(desk_.selection.id()); }, [this] { return desk_.selection.id() != 0; });
    registerTraceCommands();
}

void RobotDesk::registerTraceCommands() {
    const auto traceable = [this] {
        const Robot* robot = desk_.selection.robot();
        return robot && robot->view().figures.spawned && !robot->isReplay() &&
               robot->view().figures.dialect != protocol::Dialect::Udk;
    };
    desk_.commands.add(
        {"robot.trace",
         tr("Trace"),
         tr("Robots"),
         tr("The selected robot leaves colored marks where it goes, here and in the game (UT2004 servers)"),
         "trace",
         {QKeySequence("Ctrl+M")},
         true},
        [this](bool on) { trace(on); }, traceable);
    for (const protocol::TraceColor color : widgets::all_trace_colors)
        desk_.commands.add(
            {"robot.trace_" + widgets::traceColorName(color).toLower(),
             tr("Trace in %1").arg(widgets::traceColorName(color).toLower()),
             tr("Robots"),
             tr("The selected robot leaves marks of this color from now on"),
             "",
             {}},
            [this, color](bool) {
                desk_.views.world->setTraceColor(color);
                trace(true);
            },
            traceable);
    desk_.commands.add(
        {"map.wipe_trace",
         tr("Wipe trace marks"),
         tr("Map"),
         tr("Takes the marks of all robots off the map; a game keeps its own"),
         "clear",
         {}},
        [this](bool) {
            desk_.views.map->clearTraceMarks();
            desk_.commands.refresh();
        },
        [this] { return !desk_.views.map->traces().empty(); });
}

void RobotDesk::wire() {
    wireRobots();
    wireSpawning();
    wireMarks();
    connect(&desk_.selection, &Selection::changed, this, [this](int id) {
        presenter_.select(id);
        desk_.views.robots->selectRobot(id);
        showTrace();
    });
    connect(desk_.views.robots, &widgets::RobotList::robotSelected, &desk_.selection, &Selection::select);
    connect(desk_.views.robots, &widgets::RobotList::removeRequested, &desk_.control, &MissionControl::remove);
    connect(desk_.views.map, &widgets::MapView::robotClicked, this, &RobotDesk::select);
}

void RobotDesk::wireRobots() {
    connect(&desk_.control, &MissionControl::robotAdded, this, &RobotDesk::welcome);
    connect(&desk_.control, &MissionControl::robotRemoved, this, &RobotDesk::dismiss);
    connect(&desk_.control, &MissionControl::robotLinkChanged, this, [this](int id) {
        presenter_.showRow(id);
        if (id == desk_.selection.id())
            presenter_.showLinkState(id);
    });
    connect(&desk_.control, &MissionControl::behaviorFinished, this, [this](int id) { presenter_.showRow(id); });
    connect(&desk_.control, &MissionControl::linkUpdated, this, [this](const auto& update) {
        presenter_.showLink(desk_.control.connectionOf(0), *update, desk_.selection.id() == 0);
    });
    connect(&desk_.control, &MissionControl::robotUpdated, this,
            [this](int id, const auto& update) { show(id, *update); });
}

void RobotDesk::wireSpawning() {
    connect(&desk_.control, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses& poses) { desk_.views.map->setStartPoses(poses.poses); });
    connect(&desk_.control, &MissionControl::classesChanged, this, &RobotDesk::listClasses);
    auto* const card = desk_.views.spawn_card;
    connect(desk_.views.map, &widgets::MapView::spawnRequested, this,
            [this, card](int pose) { spawn(card->lastChoice(pose, desk_.control.nextRobotName())); });
    connect(desk_.views.map, &widgets::MapView::startPoseClicked, this, [this, card](int pose, const QPoint& at) {
        const auto& start = desk_.control.startPoses()[static_cast<std::size_t>(pose)];
        card->openFor(pose, QString::fromStdString(start.name), desk_.control.nextRobotName(), at);
    });
    connect(card, &widgets::SpawnCard::spawnRequested, this, &RobotDesk::spawn);
}

void RobotDesk::wireMarks() {
    connect(desk_.views.world, &widgets::WorldPanel::traceColorChosen, this, [this] {
        if (presenter_.tracing(desk_.selection.id()))
            trace(true);
    });
    connect(&desk_.control.simulator(), &server::SimulatorHost::marksLeft, this,
            [this](const std::vector<sim::TraceMark>& marks) {
                const bool none_before = desk_.views.map->traces().empty();
                for (const sim::TraceMark& mark : marks)
                    desk_.views.map->addTraceMark(mark.position_in_map_m.head<2>(), widgets::traceColor(mark.color));
                if (none_before)
                    desk_.commands.refresh();
            });
}

void RobotDesk::listClasses() {
    desk_.views.spawn_card->setRobots(desk_.control.robotsToSpawn());
}

void RobotDesk::welcome(int id) {
    presenter_.showRow(id);
    desk_.selection.select(id);
    if (!desk_.control.robot(id)->isReplay())
        desk_.views.hint->setDone(0, true);
}

void RobotDesk::dismiss(int id, const QString& name, int instead) {
    desk_.views.robots->removeRobot(id);
    presenter_.remove(name);
    if (id == desk_.selection.id())
        desk_.selection.select(instead);
}

void RobotDesk::spawn(const widgets::SpawnChoice& choice) {
    const auto& poses = desk_.control.startPoses();
    if (choice.start_pose < 0 || choice.start_pose >= static_cast<int>(poses.size()))
        return;
    const protocol::StartPose& pose = poses[static_cast<std::size_t>(choice.start_pose)];
    const auto id =
        desk_.control.spawn({choice.class_name.toStdString(), choice.robot_name.toStdString(), pose.pose_in_map});
    if (!id)
        return desk_.notices.complain("spawn", id.error());
    if (!choice.behavior_id.isEmpty())
        desk_.views.behavior->chooseBehavior(choice.behavior_id.toStdString());
}

void RobotDesk::select(const QString& name) {
    for (const Robot* robot : desk_.control.robots())
        if (name == QString::fromStdString(robot->view().spawn.robot_name))
            desk_.selection.select(robot->view().id);
}

void RobotDesk::show(int id, const mission::SessionUpdate& update) {
    const bool selected = id == desk_.selection.id();
    presenter_.show(id, update, selected);
    if (selected)
        showTrace();
}

void RobotDesk::trace(bool on) {
    constexpr Seconds interval{0.2};
    Robot* robot = desk_.selection.robot();
    if (!robot)
        return;
    if (on)
        robot->send(protocol::Trace{true, interval, desk_.views.world->traceColor()}, "operator: trace");
    else
        robot->send(protocol::Trace{false, {}, {}}, "operator: trace");
}

void RobotDesk::showTrace() {
    const int id = desk_.selection.id();
    desk_.commands.action("robot.trace")->setChecked(presenter_.tracing(id));
    if (const auto color = presenter_.traceColor(id); color && presenter_.tracing(id))
        desk_.views.world->setTraceColor(*color);
}

} // namespace usar::app
