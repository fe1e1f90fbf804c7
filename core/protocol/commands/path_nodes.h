// UDK's path nodes and the avatars that walk along them.
#pragma once

#include <variant>

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

struct GetPathNodes {
    bool operator==(const GetPathNodes&) const = default;
};
struct GetClosestPathNode {
    Vec3 point_in_map_m = Vec3::Zero();
    bool operator==(const GetClosestPathNode&) const = default;
};

struct GoToNode {
    Token node_name;
    bool operator==(const GoToNode&) const = default;
};

/// MOVE: a new goal instead of the old ones, or one more behind them.
enum class Gait { WalkForward, WalkBackward, Run };
struct WalkTo {
    std::variant<Vec2, Token> goal = Vec2::Zero(); ///< a point in the map frame in metres, or a path node
    Gait gait = Gait::WalkForward;
    bool append = false;
    bool operator==(const WalkTo&) const = default;
};
struct PauseWalk {
    bool operator==(const PauseWalk&) const = default;
};
struct ResumeWalk {
    bool operator==(const ResumeWalk&) const = default;
};

} // namespace usar::protocol
