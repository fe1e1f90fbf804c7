// Recordings whose files are being opened, each as the robot that it will be.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// GUI thread.
class OpeningReplays {
public:
    struct Answers {
        /// The file is open; `complaint`: what is damaged in it.
        std::function<void(std::unique_ptr<Robot> robot, const RecordingFacts& facts, const QString& complaint)> opened;
        std::function<void(const QString& reason)> failed;
    };

    explicit OpeningReplays(Answers answers) : answers_(std::move(answers)) {}

    /// Opens the file; one of the answers follows, unless `clear` comes first. The replay then carries out `first`.
    /// `looks_back_on`: see RobotIdentity. Returns the robot, so that it can be connected.
    Robot* open(const QString& path, ConnectionId looks_back_on, const ReplayOrder& first);
    void clear() { robots_.clear(); }

private:
    /// Takes a robot out; null if it is not among them.
    std::unique_ptr<Robot> take(const Robot* robot);

    Answers answers_;
    std::vector<std::unique_ptr<Robot>> robots_;
};

} // namespace usar::mission
