// Recordings that a fleet writes and opens.
#include <algorithm>
#include <utility>

#include <QDateTime>
#include <QFileInfo>

#include "core/mission/files/result_writer.h"
#include "core/mission/fleet/fleet_private.h"
#include "core/mission/fleet/robot_words.h"

namespace usar::mission {

void Fleet::setRecording(bool on) {
    if (std::exchange(d_->recording, on) == on)
        return;
    for (Robot* robot : robots())
        if (!robot->isReplay())
            on ? d_->record(*robot, robot->view().spawn) : robot->stopRecording();
}

bool Fleet::recording() const {
    return d_->recording;
}

void Fleet::setRecordingLimit(RecordingLimit limit_bytes) {
    d_->recording_limit = limit_bytes;
    for (Robot* robot : robots())
        robot->setRecordingLimit(limit_bytes);
}

void Fleet::Private::record(Robot& robot, const SpawnRequest& as) {
    robot.setRecordingLimit(recording_limit);
    robot.startRecording(
        newRecordingIn(keeper.folder(), QString::fromStdString(as.robot_name), QDateTime::currentDateTime()),
        {{"robot", as.robot_name},
         {"class", as.class_name},
         {"level", place.level.toStdString()},
         {"program", "mission-control"}});
}

void Fleet::openRecording(const QString& path, const ReplayOrder& first, const QString& title) {
    if (!title.isEmpty())
        d_->replay_titles[QFileInfo(path).absoluteFilePath()] = title;
    d_->openReplay(path, {}, first);
}

void Fleet::Private::openReplay(const QString& path, ConnectionId looks_back_on, const ReplayOrder& first) {
    connectRobot(opening.open(path, looks_back_on, first));
}

void Fleet::lookBack(RobotId id, Seconds moment) {
    Robot* const flies = robot(id);
    if (!flies || flies->isReplay())
        return;
    for (const Robot* other : robots())
        if (other->view().looks_back_on == flies->view().connection)
            remove(other->view().id);
    d_->wanted_moments[flies->view().connection] = moment;
    flies->flushRecording();
}

RobotId Fleet::lookedBackOn(RobotId id) const {
    const Robot* const replay = robot(id);
    const Robot* const flies = replay ? d_->robotOn(replay->view().looks_back_on) : nullptr;
    return flies ? flies->view().id : RobotId{};
}

void Fleet::Private::addReplay(std::unique_ptr<Robot> robot, const RecordingFacts& facts, const QString& complaint) {
    if (roster.full()) {
        q.note(Severity::Error, "replay",
               tr("There can be no more than %1 robots. Remove one, then open the recording again.")
                   .arg(Roster::most_robots));
        robot.release()->deleteLater();
        return;
    }
    const RobotId id = roster.nextId();
    const QString title = replay_titles.take(robot->view().recording);
    const QString name = title.isEmpty() ? replayNameOf(facts) : replayNameOf({{"robot", title.toStdString()}});
    robot->becomeReplay(id, roster.unusedName(name), facts);
    const QString file = QFileInfo(robot->view().recording).fileName();
    roster.add(std::move(robot));
    emit q.cured("replay");
    emit q.replayAdded(id);
    emit q.robotAdded(id);
    if (!complaint.isEmpty())
        q.note(Severity::Warning, "replay-damage", file + ": " + complaint);
}

} // namespace usar::mission
