// Commands about path nodes and the avatars that walk along them; UDK only.
#pragma once

#include <variant>

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"

namespace usar::protocol {

/// GETPATHNODES; the answer is PathNodes.
/// It has no segments.
struct GetPathNodes {
    bool operator==(const GetPathNodes&) const = default;

    static constexpr CommandWord word{"GETPATHNODES", "asks for the path nodes (UDK)", "GETPATHNODES"};
    static void segments(auto&, auto&) {}
};
/// GETCLOSESTPATHNODE; the answer is ClosestPathNode.
/// On the wire: `GETCLOSESTPATHNODE {Location 3,4,0}`.
struct GetClosestPathNode {
    /// A line without Location is refused.
    Vec3 point_in_map_m = Vec3::Zero();
    bool operator==(const GetClosestPathNode&) const = default;

    static constexpr CommandWord word{"GETCLOSESTPATHNODE", "asks for the path node next to a place (UDK)",
                                      "GETCLOSESTPATHNODE {Location 3,4,0}"};
    static void segments(auto& io, auto& get) { io.position(location_key, get.point_in_map_m); }
};

/// GOTO: sends an avatar to a path node.
/// On the wire: `GOTO {Name PathNode_3}`.
struct GoToNode {
    Token node_name;
    bool operator==(const GoToNode&) const = default;

    static constexpr CommandWord word{"GOTO", "sends an avatar to a path node (UDK)", "GOTO {Name PathNode_3}"};
    static void segments(auto& io, auto& go) { io.text({"Name", "the path node"}, go.node_name); }
};

/// The way in which an avatar walks to a goal; no command sets its speed.
enum class Gait { WalkForward, WalkBackward, Run };
template <>
inline constexpr std::array wire_words<Gait> = {WireWord{"Walk_Forward", Gait::WalkForward},
                                                WireWord{"Walk_Backward", Gait::WalkBackward},
                                                WireWord{"Run", Gait::Run}};

/// The word of all commands to an avatar's walk; Action tells them apart.
inline constexpr CommandWord move_word{"MOVE", "tells an avatar to walk (UDK)",
                                       "MOVE {Action New} {Type Run} {Location 3.5,-2}"};
inline constexpr Key move_action{"Action", "New and Append give a goal"};

/// MOVE with the action New, which replaces all goals of an avatar, or Append, which adds one after them.
/// On the wire: `MOVE {Action New} {Type Walk_Forward} {Location 3.5,-2}`.
struct WalkTo {
    std::variant<Vec2, Token> goal = Vec2::Zero(); ///< a point in the map frame in meters, or a path node
    Gait gait = Gait::WalkForward;
    bool append = false;
    bool operator==(const WalkTo&) const = default;

    static constexpr auto& word = move_word;
    static void segments(auto& io, auto& walk) {
        io.mark(move_action, walk.append, std::array{WireWord{"New", false}, WireWord{"Append", true}});
        io.choice({"Type", "the gait"}, walk.gait);
        io.goal({"Location", "x,y in meters"}, {"Pathnode", "a path node, instead of Location"}, walk.goal);
    }
};
/// MOVE with the action Pause.
/// On the wire: `MOVE {Action Pause}`.
struct PauseWalk {
    bool operator==(const PauseWalk&) const = default;

    static constexpr auto& word = move_word;
    static void segments(auto& io, auto&) { io.mark(move_action, "Pause"); }
};
/// MOVE with the action Resume.
/// On the wire: `MOVE {Action Resume}`.
struct ResumeWalk {
    bool operator==(const ResumeWalk&) const = default;

    static constexpr auto& word = move_word;
    static void segments(auto& io, auto&) { io.mark(move_action, "Resume"); }
};

} // namespace usar::protocol
