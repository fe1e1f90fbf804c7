// The part of MissionControl that writes and opens recordings.
#include <algorithm>
#include <utility>

#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include "app/host/mission_control.h"

namespace usar::app {

namespace {

/// "R1_2026-11-21_18-21-29.usarrec" in the folder, followed by a number if there is such a file already.
QString newRecordingIn(const QString& folder, const QString& robot_name) {
    QString safe = robot_name;
    for (QChar& c : safe)
        if (!c.isLetterOrNumber() && c != '-' && c != '_')
            c = '_';
    const QString stem = safe + '_' + QDateTime::currentDateTime().toString("yyyy-MM-dd_HH-mm-ss");
    QString name = stem;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(name + ".usarrec")); ++number)
        name = stem + '_' + QString::number(number);
    return QDir(folder).filePath(name + ".usarrec");
}

} // namespace

void MissionControl::setRecording(bool on) {
    if (std::exchange(recording_, on) == on)
        return;
    for (Robot* robot : robots()) {
        if (robot->isReplay())
            continue;
        if (on)
            record(*robot, robot->view().spawn);
        else
            robot->stopRecording();
    }
}

void MissionControl::record(Robot& robot, const mission::SpawnRequest& as) {
    robot.startRecording(newRecordingIn(resultFolder(), QString::fromStdString(as.robot_name)),
                         {{"robot", as.robot_name},
                          {"class", as.class_name},
                          {"level", level_.toStdString()},
                          {"program", "mission-control"}});
}

void MissionControl::openRecording(const QString& path) {
    open(path, 0, std::nullopt);
}

void MissionControl::open(const QString& path, int looks_back_on, std::optional<Seconds> moment) {
    auto robot = std::make_unique<Robot>();
    connectReplay(robot.get());
    robot->openRecording(QFileInfo(path).absoluteFilePath(), looks_back_on);
    if (moment)
        robot->orderReplay({.seek_clock = moment});
    opening_.push_back(std::move(robot));
}

void MissionControl::lookBack(int id, Seconds moment) {
    Robot* const flies = robot(id);
    if (!flies || flies->isReplay())
        return;
    for (const Robot* other : robots())
        if (other->view().looks_back_on == flies->view().connection)
            remove(other->view().id);
    wanted_moments_[flies->view().connection] = moment;
    flies->flushRecording();
}

int MissionControl::lookedBackOn(int id) const {
    const Robot* const replay = robot(id);
    const Robot* const flies = replay ? robotOn(replay->view().looks_back_on) : nullptr;
    return flies ? flies->view().id : 0;
}

void MissionControl::connectReplay(Robot* robot) {
    connect(robot, &Robot::replayOpened, this,
            [this, robot](const mission::RecordingFacts& facts, const QString& complaint) {
                addReplay(robot, facts, complaint);
            });
    connect(robot, &Robot::replayFailed, this, [this, robot](const QString& reason) {
        note(Severity::Error, "replay", reason);
        const auto found = std::ranges::find(opening_, robot, &std::unique_ptr<Robot>::get);
        if (found == opening_.end())
            return;
        found->release()->deleteLater(); // Later, because the robot is the sender of this signal.
        opening_.erase(found);
    });
    connect(robot, &Robot::linkChanged, this, [this, robot] {
        if (robot->spawned())
            emit robotLinkChanged(robot->view().id);
    });
    connect(robot, &Robot::updated, this, [this, robot](const auto& update) {
        if (robot->spawned())
            emit robotUpdated(robot->view().id, update);
    });
    connect(robot, &Robot::noticed, this, [this, robot](const mission::Notice& notice) { tell(robot, notice); });
    keeper_.watch(*robot, [] { return std::nullopt; });
}

void MissionControl::addReplay(Robot* robot, const mission::RecordingFacts& facts, const QString& complaint) {
    const auto found = std::ranges::find(opening_, robot, &std::unique_ptr<Robot>::get);
    if (found == opening_.end())
        return;
    const int id = nextId();
    if (id > most_robots) {
        note(Severity::Error, "replay", tr("Nine robots are the most. Remove one, then open the recording again."));
        found->release()->deleteLater();
        opening_.erase(found);
        return;
    }
    const auto name = facts.find("robot");
    const QString recorded = name == facts.end() ? QString() : QString::fromStdString(name->second);
    robot->becomeReplay(id, unusedName(recorded.isEmpty() ? tr("Replay") : tr("%1 replay").arg(recorded)), facts);
    robots_[id] = std::move(*found);
    opening_.erase(found);
    emit cured("replay");
    emit replayAdded(id);
    emit robotAdded(id);
    if (!complaint.isEmpty())
        note(Severity::Warning, "replay-damage", QFileInfo(robot->view().recording).fileName() + ": " + complaint);
}

QString MissionControl::unusedName(const QString& name) const {
    const auto taken = [this](const QString& candidate) {
        return std::ranges::any_of(robots_, [&](const auto& entry) {
            return entry.second->view().spawn.robot_name == candidate.toStdString();
        });
    };
    QString unused = name;
    for (int number = 2; taken(unused); ++number)
        unused = name + ' ' + QString::number(number);
    return unused;
}

} // namespace usar::app
