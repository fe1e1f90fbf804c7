// Recordings that a fleet writes and opens.
#include <algorithm>
#include <utility>

#include <QDateTime>
#include <QFileInfo>

#include "core/mission/files/recording_name.h"
#include "core/mission/fleet/fleet_private.h"
#include "core/mission/fleet/robot_name.h"

namespace usar::mission {

void Fleet::setRecording(bool on) {
    if (std::exchange(d_->recording, on) == on)
        return;
    for (Robot* robot : robots()) {
        if (robot->isReplay())
            continue;
        if (on)
            d_->record(*robot, robot->view().spawn);
        else
            robot->stopRecording();
    }
}

bool Fleet::recording() const {
    return d_->recording;
}

void Fleet::Private::record(Robot& robot, const SpawnRequest& as) {
    robot.startRecording(
        newRecordingIn(keeper.folder(), QString::fromStdString(as.robot_name), QDateTime::currentDateTime()),
        {{"robot", as.robot_name},
         {"class", as.class_name},
         {"level", place.level.toStdString()},
         {"program", "mission-control"}});
}

void Fleet::openRecording(const QString& path) {
    d_->openReplay(path, 0, std::nullopt);
}

void Fleet::Private::openReplay(const QString& path, int looks_back_on, std::optional<Seconds> moment) {
    auto robot = std::make_unique<Robot>();
    connectReplay(robot.get());
    robot->openRecording(QFileInfo(path).absoluteFilePath(), looks_back_on);
    if (moment)
        robot->orderReplay({.seek_clock = moment});
    opening.push_back(std::move(robot));
}

void Fleet::lookBack(int id, Seconds moment) {
    Robot* const flies = robot(id);
    if (!flies || flies->isReplay())
        return;
    for (const Robot* other : robots())
        if (other->view().looks_back_on == flies->view().connection)
            remove(other->view().id);
    d_->wanted_moments[flies->view().connection] = moment;
    flies->flushRecording();
}

int Fleet::lookedBackOn(int id) const {
    const Robot* const replay = robot(id);
    const Robot* const flies = replay ? d_->robotOn(replay->view().looks_back_on) : nullptr;
    return flies ? flies->view().id : 0;
}

void Fleet::Private::connectReplay(Robot* robot) {
    connect(robot, &Robot::replayOpened, &q, [this, robot](const RecordingFacts& facts, const QString& complaint) {
        addReplay(robot, facts, complaint);
    });
    connect(robot, &Robot::replayFailed, &q, [this, robot](const QString& reason) {
        q.note(Severity::Error, "replay", reason);
        if (auto failed = takeOpening(robot))
            failed.release()->deleteLater(); // it is the robot itself that is speaking
    });
    connect(robot, &Robot::linkChanged, &q, [this, robot] {
        if (robot->spawned())
            emit q.robotLinkChanged(robot->view().id);
    });
    connect(robot, &Robot::updated, &q, [this, robot](const auto& update) {
        if (robot->spawned())
            emit q.robotUpdated(robot->view().id, update);
    });
    connect(robot, &Robot::noticed, &q, [this, robot](const Notice& notice) { tell(robot, notice); });
    keeper.watch(*robot, [] { return SimulatorFacts{}; });
}

std::unique_ptr<Robot> Fleet::Private::takeOpening(const Robot* robot) {
    const auto found = std::ranges::find(opening, robot, &std::unique_ptr<Robot>::get);
    if (found == opening.end())
        return nullptr;
    std::unique_ptr<Robot> taken = std::move(*found);
    opening.erase(found);
    return taken;
}

void Fleet::Private::addReplay(Robot* robot, const RecordingFacts& facts, const QString& complaint) {
    std::unique_ptr<Robot> opened = takeOpening(robot);
    if (!opened)
        return;
    if (roster.full()) {
        q.note(Severity::Error, "replay", tr("Nine robots are the most. Remove one, then open the recording again."));
        opened.release()->deleteLater();
        return;
    }
    const int id = roster.nextId();
    const auto name = facts.find("robot");
    const QString recorded = name == facts.end() ? QString() : QString::fromStdString(name->second);
    robot->becomeReplay(id, roster.unusedName(recorded.isEmpty() ? tr("Replay") : tr("%1 replay").arg(recorded)),
                        facts);
    roster.add(std::move(opened));
    emit q.cured("replay");
    emit q.replayAdded(id);
    emit q.robotAdded(id);
    if (!complaint.isEmpty())
        q.note(Severity::Warning, "replay-damage", QFileInfo(robot->view().recording).fileName() + ": " + complaint);
}

} // namespace usar::mission
