// NFO: information about the server and its world, and the places where robots may start.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace usar::protocol {

/// NFO sent when a client connects. `level` is the name of the map; a time limit of 0 minutes means that there is none.
/// On the wire: `NFO {Gametype BotDeathMatch} {Level DM-X_250} {TimeLimit 20}`.
struct GameInfo {
    std::string game_type{};
    std::string level{};
    std::optional<int> time_limit_min{};
    bool operator==(const GameInfo&) const = default;
};

/// A named place at which a robot can be spawned. Names need not be unique.
struct StartPose {
    std::string name{};
    Pose pose_in_map{};
    bool operator==(const StartPose&) const = default;
};

/// NFO that answers GETSTARTPOSES.
/// On the wire: `NFO {StartPoses 2} {A_1 1.00,2.00,3.00 0.10,0.20,0.30 B 4,5,6 0,0,0}`.
struct StartPoses {
    std::vector<StartPose> poses{};
    bool operator==(const StartPoses&) const = default;
};

/// NFO that answers GETPATHNODES (UDK): the places along which avatars walk. A node has the fields of a start pose.
/// On the wire: `NFO {PathNodes 1} {Door1 4.5,2,1.5 0,0,-1.5}`.
struct PathNodes {
    std::vector<StartPose> nodes{};
    bool operator==(const PathNodes&) const = default;
};

/// NFO that answers GETCLOSESTPATHNODE (UDK).
/// On the wire: `NFO {Pathnode Door1} {Location 4.5,2,1.5}`.
struct ClosestPathNode {
    std::string name{};
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const ClosestPathNode&) const = default;
};

/// NFO {Lockstep True}: our own server's answer to LOCKSTEP; a real server never sends it.
struct LockstepInfo {
    bool on = false;
    bool operator==(const LockstepInfo&) const = default;
};

} // namespace usar::protocol
