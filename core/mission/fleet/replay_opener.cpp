#include "core/mission/fleet/replay_opener.h"

#include <algorithm>
#include <utility>

#include <QFileInfo>

namespace usar::mission {

Robot& ReplayOpener::open(const QString& path, ConnectionId looks_back_on, std::optional<Seconds> moment) {
    Robot* const robot = opening_.emplace_back(std::make_unique<Robot>()).get();
    const auto opened = [this, robot](const RecordingFacts& facts, const QString& complaint) {
        if (auto open = take(robot))
            taker_(std::move(open), facts, complaint);
    };
    const auto failed = [this, robot](const QString& reason) {
        refused_(reason);
        if (auto refused = take(robot))
            refused.release()->deleteLater(); // it is the robot itself that is speaking
    };
    QObject::connect(robot, &Robot::replayOpened, robot, opened);
    QObject::connect(robot, &Robot::replayFailed, robot, failed);
    robot->openRecording(QFileInfo(path).absoluteFilePath(), looks_back_on);
    if (moment)
        robot->orderReplay({.seek_clock = moment});
    return *robot;
}

/// Null if the robot was taken already.
std::unique_ptr<Robot> ReplayOpener::take(const Robot* robot) {
    const auto found = std::ranges::find(opening_, robot, &std::unique_ptr<Robot>::get);
    if (found == opening_.end())
        return nullptr;
    std::unique_ptr<Robot> taken = std::move(*found);
    opening_.erase(found);
    return taken;
}

} // namespace usar::mission
