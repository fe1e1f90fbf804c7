// Commands about path nodes and the avatars that walk along them; UDK only.
#pragma once

#include <variant>

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// GETPATHNODES; the answer is PathNodes.
struct GetPathNodes {
    bool operator==(const GetPathNodes&) const = default;
};
/// GETCLOSESTPATHNODE; the answer is ClosestPathNode.
/// On the wire: `GETCLOSESTPATHNODE {Location 3,4,0}`.
struct GetClosestPathNode {
    Vec3 point_in_map_m = Vec3::Zero();
    bool operator==(const GetClosestPathNode&) const = default;
};

/// GOTO: sends an avatar to a path node.
/// On the wire: `GOTO {Name PathNode_3}`.
struct GoToNode {
    Token node_name;
    bool operator==(const GoToNode&) const = default;
};

enum class Gait { WalkForward, WalkBackward, Run };
/// MOVE with the action New, which replaces all goals of an avatar, or Append, which adds one after them.
/// On the wire: `MOVE {Action New} {Type Walk_Forward} {Location 3.5,-2}`.
struct WalkTo {
    std::variant<Vec2, Token> goal = Vec2::Zero(); ///< a point in the map frame in meters, or a path node
    Gait gait = Gait::WalkForward;
    bool append = false;
    bool operator==(const WalkTo&) const = default;
};
/// MOVE with the action Pause.
struct PauseWalk {
    bool operator==(const PauseWalk&) const = default;
};
/// MOVE with the action Resume.
struct ResumeWalk {
    bool operator==(const ResumeWalk&) const = default;
};

} // namespace usar::protocol
