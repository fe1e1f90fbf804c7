// Commands sent before there is a robot: the query for start poses, and INIT, which spawns the robot.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/text.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// The class of base stations of the radio network, which never send data (protocol.md 2.4).
inline constexpr std::string_view station_class = "USARBot.ComStation";
/// True for a station's class name, with or without the package, in any case.
constexpr bool isStation(std::string_view class_name) {
    return sameWord(class_name.substr(class_name.rfind('.') + 1), "ComStation");
}

/// INIT: spawns a robot. No source shows that UT2004 servers accept the name of a start pose; send them the pose
/// itself.
/// On the wire: `INIT {ClassName USARBot.AirRobot} {Name R1} {Location 4.5,1.9,-1.8} {Rotation 0.5,0,1.5}`.
struct Init {
    Token class_name;                      ///< with its package: "USARBot.AirRobot"
    Name robot_name{};                     ///< empty lets the server choose
    std::variant<Pose, Token> start{};     ///< a pose in the map frame, or the name of a start pose
    std::optional<Pose> fallback_in_map{}; ///< used if no start pose has the name in `start`
    std::optional<Seconds> battery_life{}; ///< accepted by the Gazebo server only
    bool operator==(const Init&) const = default;

    /// A world controller has no body; its connection accepts the commands in world_control.h.
    static Init worldController(Name name, Dialect dialect) {
        return {dialect == Dialect::Udk ? Token("USARBotAPI.WorldController") : Token("USARBot.WorldController"),
                std::move(name)};
    }

    static constexpr CommandWord word{
        "INIT", "spawns the robot of this connection",
        "INIT {ClassName USARBot.P2DX} {Name R1} {Location 4.5,1.9,1.8} {Rotation 0,0,0}"};
    /// Classes for completion; any other class is sent as it is.
    static constexpr auto usual_classes =
        texts("USARBot.P2DX", "USARBot.P2AT", "USARBot.P3AT", "USARBot.AirRobot", "USARBot.Kenaf", "USARBot.TeleMax",
              "USARBot.ATRVJr", "USARBot.Zerg", "USARBot.Hummer", "USARBot.Submarine", "USARBot.QRIO", "USARBot.ERS",
              "USARBot.ComStation", "USARBot.WorldController");
    static void segments(auto& io, auto& init) {
        io.text({"ClassName", "the robot's class, Package.Class", usual_classes}, init.class_name);
        io.text({"Name", "the robot's name; without it the server invents one"}, init.robot_name);
        io.start({"Start", "a start pose by name, instead of Location and Rotation (UDK)"}, init.start,
                 &init.fallback_in_map);
        io.number({"Battery", "seconds of battery (Gazebo)"}, init.battery_life);
    }
};

/// GETSTARTPOSES; the answer is StartPoses.
/// It has no segments, and needs no robot.
struct GetStartPoses {
    bool operator==(const GetStartPoses&) const = default;

    static constexpr CommandWord word{"GETSTARTPOSES", "asks where robots may start", "GETSTARTPOSES", "STARTPOSES"};
    static void segments(auto&, auto&) {}
};

} // namespace usar::protocol
