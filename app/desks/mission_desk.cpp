#include "app/desks/mission_desk.h"

#include <algorithm>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>

#include "core/mission/files/mission_writer.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/simulator_files.h"

namespace usar::app {

MissionDesk::MissionDesk(const DeskContext& context, ServerDesk& server, TaskDesk& task)
    : desk_(context)
    , server_(server)
    , task_(task) {}

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
        [this](bool) { chooseWhereToSave(); }, [this] { return task_.complete(); });
}

void MissionDesk::wire() {
    connect(&desk_.control, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses&, const QString& level) {
                if (awaiting_world_ && awaiting_world_->world == level.toStdString())
                    setUp(*std::exchange(awaiting_world_, std::nullopt));
            });
}

void MissionDesk::takePlugins() {
    if (awaiting_plugin_)
        setUp(*std::exchange(awaiting_plugin_, std::nullopt)); // or continues to wait
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
    if (task_.draft().behavior_id != mission.behavior)
        return desk_.notices.complain(
            "mission", mission::atValue(mission, "behavior",
                                        {"this behavior does not drive the mission's robot", mission.robot_class,
                                         "Name the robot that " + mission.behavior + " is for"}));
    task_.setUp(mission, *prepared);
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
    task_.preferClass(robot_class);
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

void MissionDesk::saveMission(const QString& path) {
    const mission::TaskDraft& draft = task_.draft();
    const auto* behavior = desk_.control.plugins().behavior(draft.behavior_id);
    if (!behavior)
        return desk_.notices.say(Severity::Warning, "mission",
                                 tr("No behavior is chosen. Choose what the robot is to do first."));
    if (!task_.complete())
        return desk_.notices.say(Severity::Warning, "mission",
                                 tr("There is no mission area to save. Draw one on the map first."));
    mission::Mission mission = draft.mission();
    mission.name = QFileInfo(path).completeBaseName().toStdString();
    mission.world = desk_.control.level().toStdString();
    if (const Robot* robot = desk_.selection.robot())
        mission.robot_class = robot->view().spawn.class_name;
    mission.start = startName();
    mission.isolate = task_.isolated();
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
