// Opens recordings as robots.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/mission/fleet/robot.h"

namespace usar::mission {

/// Owns the robots of recordings until their files are open. Used in the GUI thread, as they are.
class ReplayOpener {
public:
    /// Takes a robot whose recording is open, paused at its beginning; `complaint` is a sentence about what is missing
    /// from the file, or empty.
    using Taker =
        std::function<void(std::unique_ptr<Robot> robot, const RecordingFacts& facts, const QString& complaint)>;
    using Refused = std::function<void(const QString& reason)>;

    /// Both are called from the event loop, once for each recording.
    ReplayOpener(Taker taker, Refused refused) : taker_(std::move(taker)), refused_(std::move(refused)) {}

    /// Opens the file and returns its robot, which is not open yet, so that the caller can connect to it. With `moment`
    /// (protocol clock) the replay begins there. `looks_back_on`: see RobotIdentity.
    Robot& open(const QString& path, ConnectionId looks_back_on, std::optional<Seconds> moment);
    /// Gives up all recordings that are not open yet.
    void clear() { opening_.clear(); }

private:
    std::unique_ptr<Robot> take(const Robot* robot);

    Taker taker_;
    Refused refused_;
    std::vector<std::unique_ptr<Robot>> opening_;
};

} // namespace usar::mission
