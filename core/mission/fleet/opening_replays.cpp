#include "core/mission/fleet/opening_replays.h"

#include <algorithm>

#include <QFileInfo>

namespace usar::mission {

Robot* OpeningReplays::open(const QString& path, ConnectionId looks_back_on, const ReplayOrder& first) {
    Robot* const robot = robots_.emplace_back(std::make_unique<Robot>()).get();
    QObject::connect(robot, &Robot::replayOpened, robot,
                     [this, robot](const RecordingFacts& facts, const QString& complaint) {
                         if (auto opened = take(robot))
                             answers_.opened(std::move(opened), facts, complaint);
                     });
    QObject::connect(robot, &Robot::replayFailed, robot, [this, robot](const QString& reason) {
        answers_.failed(reason);
        if (auto refused = take(robot))
            refused.release()->deleteLater();
    });
    robot->openRecording(QFileInfo(path).absoluteFilePath(), looks_back_on);
    robot->orderReplay(first);
    return robot;
}

std::unique_ptr<Robot> OpeningReplays::take(const Robot* robot) {
    const auto found = std::ranges::find(robots_, robot, &std::unique_ptr<Robot>::get);
    if (found == robots_.end())
        return nullptr;
    std::unique_ptr<Robot> taken = std::move(*found);
    robots_.erase(found);
    return taken;
}

} // namespace usar::mission
