#include "app/desks/mission_desk.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

#include "core/mission/files/mission_check.h"
#include "core/mission/files/mission_file.h"
#include "core/mission/fleet/roster.h"
#include "core/server/embedded/simulator_files.h"
#include "widgets/panels/dialogs.h"

namespace usar::app {

void MissionDesk::registerCommands() {
    add("file.open", [this] {
        widgets::askForFile(window_, tr("Open mission"), folder_, tr("Missions (*.json)"),
                            [this](const QString& path) { openMission(path); });
    });
    const auto complete = [this] { return task_.complete(); };
    add("file.save", complete, [this] {
        widgets::askWhereToSave(window_, tr("Save mission"), tr("my.mission.json"), tr("Missions (*.json)"),
                                [this](const QString& path) { saveMission(path); });
    });
}

void MissionDesk::wire() {
    connect(&control_, &MissionControl::startPosesKnown, this,
            [this](const protocol::StartPoses&, const QString& level) {
                if (awaiting_world_ && awaiting_world_->world == level.toStdString())
                    setUp(*std::exchange(awaiting_world_, std::nullopt));
                flyRests();
            });
}

void MissionDesk::flyRest(const std::shared_ptr<const mission::RecordedScan>& earlier) {
    rests_.push_back(earlier);
    flyRests();
}

void MissionDesk::flyRests() {
    if (rests_.empty() || control_.startPoses().empty() ||
        control_.plugins().isAsked(rests_.front()->flown.mission.behavior))
        return;
    if (const QString world = worldToOpenFor(rests_.front()->flown.mission); !world.isEmpty())
        return server_.openWorld(world);
    if (!control_.checkLine(control_.connectionOf({})))
        return; // Each robot needs a connection of its own, and the next one is not open yet.
    const auto earlier = rests_.front();
    rests_.erase(rests_.begin());
    const mission::Mission& mission = earlier->flown.mission;
    const auto values = control_.prepareMission(mission);
    const Result<RobotId> id = values ? control_.flyRest(earlier) : tl::unexpected(values.error());
    if (!id) {
        notices_.complain("mission", id.error());
        return flyRests();
    }
    selection_.select(*id);
    views_.behavior->chooseBehavior(mission.behavior);
    task_.setUp(mission, *values);
}

void MissionDesk::takePlugins() {
    if (awaiting_plugin_)
        setUp(*std::exchange(awaiting_plugin_, std::nullopt)); // or continues to wait
    flyRests();
}

void MissionDesk::openMission(const QString& path) {
    const auto mission = mission::readMissionFile(path);
    if (!mission)
        return notices_.complain("mission", mission.error());
    remember(path);
    if (!mission->claims.empty())
        notices_.note("mission", tr("%1 is a test. The window flies its mission, but checks no claims, and a mission "
                                    "that is saved here has none: save it under another name.")
                                     .arg(QFileInfo(path).fileName()));
    awaiting_plugin_.reset();
    if (const QString world = worldToOpenFor(*mission); !world.isEmpty()) {
        server_.openWorld(world);
        awaiting_world_ = *mission;
        return;
    }
    setUp(*mission);
}

void MissionDesk::remember(const QString& path) {
    folder_ = QFileInfo(path).absolutePath();
    emit fileUsed(path);
}

QString MissionDesk::worldToOpenFor(const mission::Mission& mission) const {
    const QString wanted = QString::fromStdString(mission.world);
    const bool may_change = control_.server().embedded && control_.robots().empty();
    return may_change && server_.world() != wanted && server::worldNames().contains(wanted) ? wanted : QString();
}

void MissionDesk::setUp(const mission::Mission& mission) {
    if (control_.plugins().isAsked(mission.behavior)) {
        awaiting_plugin_ = mission;
        return;
    }
    const auto prepared = control_.prepareMission(mission);
    if (!prepared)
        return notices_.complain("mission", prepared.error());
    if (const auto faults = server::readFaults(server::textsOf(mission.faults)); !faults)
        return notices_.complain("mission", mission::atValue(mission, "faults", faults.error()));
    start_ = mission.start;
    selectRobotFor(mission.robot_class);
    views_.behavior->chooseBehavior(mission.behavior);
    if (task_.draft().behavior_id != mission.behavior)
        return notices_.complain(
            "mission", mission::atValue(mission, "behavior",
                                        {"this behavior does not drive the mission's robot", mission.robot_class,
                                         "Name the robot that " + mission.behavior + " is for"}));
    task_.setUp(mission, *prepared);
    last_ = mission;
    notices_.cure("mission");
    if (const std::string beyond = mission::beyondWorldNotice(mission.area_in_map, control_.world().extent_in_map);
        !beyond.empty())
        notices_.say(Severity::Warning, "mission-area", QString::fromStdString(beyond));
    const QString name = QString::fromStdString(mission.name);
    notices_.say(
        Severity::Note, "mission-ready",
        !selection_.id().valid()
            ? tr("Mission %1 is ready. Double-click the start pose %2 to spawn the robot (%3), then press Start.")
                  .arg(name, QString::fromStdString(mission.start),
                       QString::fromStdString(mission.robot_class).section('.', -1))
            : tr("Mission %1 is ready. Press Start.").arg(name));
}

void MissionDesk::selectRobotFor(const std::string& robot_class) {
    const Robot* const found = mission::robotFor(control_.robots(), robot(), robot_class);
    if (found && found == robot())
        return;
    task_.preferClass(robot_class);
    views_.spawn_card->chooseClass(QString::fromStdString(robot_class));
    selection_.select(found ? found->view().id : RobotId{});
}

Result<mission::Mission> MissionDesk::setUpNow(const std::string& name) const {
    const mission::TaskDraft& draft = task_.draft();
    if (!control_.plugins().behavior(draft.behavior_id))
        return failure("no behavior is chosen", {}, "Choose one first");
    if (!task_.complete())
        return failure("there is no mission area", {}, "Draw one on the map first");
    mission::Mission mission = draft.mission();
    mission.name = name;
    mission.world = control_.level().toStdString();
    for (const agent::RobotDescription& kind : control_.plugins().kinds())
        if (std::ranges::find(kind.behaviors, draft.behavior_id, &agent::BehaviorDescription::id) !=
            kind.behaviors.end())
            mission.robot_class = kind.class_name;
    if (robot())
        mission.robot_class = robot()->view().spawn.class_name;
    const auto& poses = control_.startPoses();
    const bool has_start = std::ranges::find(poses, start_, &protocol::StartPose::name) != poses.end();
    mission.start = !robot() && has_start ? start_ : mission::startName(poses, robot(), mission.start);
    mission.isolate = task_.isolated();
    return mission;
}

std::string MissionDesk::name() const {
    const bool is_same = last_ && task_.complete() && task_.draft().mission().area_in_map == last_->area_in_map &&
                         control_.level().toStdString() == last_->world;
    return is_same ? last_->name : std::string();
}

void MissionDesk::saveMission(const QString& path) {
    QString name = QFileInfo(path).completeBaseName();
    if (name.endsWith(".mission"))
        name = name.section('.', 0, -2);
    const auto mission = setUpNow(name.toStdString());
    if (!mission)
        return notices_.say(Severity::Warning, "mission", QString::fromStdString(mission.error().text()));
    const auto* const behavior = control_.plugins().behavior(mission->behavior);
    if (const auto saved = mission::writeMissionFile(*mission, behavior->parameters, path); !saved)
        return notices_.complain("mission", saved.error());
    remember(path);
    notices_.cure("mission");
    notices_.note("mission-saved", tr("Saved the mission %1; usar-mission run flies it, too.").arg(path));
}

} // namespace usar::app
