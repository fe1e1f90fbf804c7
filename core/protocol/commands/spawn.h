// Commands before there is a robot: where it may start, and to start it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/text.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// A base of the radio network; no data ever come from it (usarsim-protocol 2.4).
inline constexpr std::string_view station_class = "USARBot.ComStation";
/// With or without the package, in any case.
constexpr bool isStation(std::string_view class_name) {
    return sameWord(class_name.substr(class_name.rfind('.') + 1), "ComStation");
}

/// INIT: spawn a robot. A start name is not attested for UT2004 servers; send the pose it stands for there.
struct Init {
    Token class_name;                      ///< "USARBot.AirRobot"
    Name robot_name{};                     ///< empty lets the server choose
    std::variant<Pose, Token> start{};     ///< a pose in the map frame, or the name of a start pose
    std::optional<Pose> fallback_in_map{}; ///< where to spawn when no start pose has that name
    std::optional<Seconds> battery_life{}; ///< Gazebo's server only
    bool operator==(const Init&) const = default;

    static Init at(Token class_name, Name robot_name, const Pose& start_in_map) {
        return {std::move(class_name), std::move(robot_name), start_in_map};
    }
    static Init atStart(Token class_name, Name robot_name, Token start_name) {
        return {std::move(class_name), std::move(robot_name), std::move(start_name)};
    }
    /// Has no body; its connection takes the commands of world_control.h.
    static Init worldController(Name name, Dialect dialect) {
        return {dialect == Dialect::Udk ? Token("USARBotAPI.WorldController") : Token("USARBot.WorldController"),
                std::move(name)};
    }
    /// A base of the radio network; it says nothing by itself.
    static Init communicationStation(Name name, std::variant<Pose, Token> start) {
        return {"USARBot.ComStation", std::move(name), std::move(start)};
    }
};

struct GetStartPoses {
    bool operator==(const GetStartPoses&) const = default;
};

} // namespace usar::protocol
