// A user's orders to a session: the robot to spawn, time limits, and commands to a replay.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include "core/agent/patience.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/link/tcp_link.h"
#include "core/protocol/silence.h"

namespace usar::mission {

/// Facts about a recording besides its records: robot, class, level, host …
using RecordingFacts = std::map<std::string, std::string>;

/// The most bytes that a recording may have: before there are more, its oldest parts are deleted. With nullopt, it may
/// have any number.
using RecordingLimit = std::optional<std::uint64_t>;

/// User's orders to a replay. All members that are set are carried out.
struct ReplayOrder {
    std::optional<bool> play{};
    std::optional<double> speed{};       ///< 0.1 to 100, or infinity for as fast as possible
    std::optional<Seconds> seek{};       ///< time since the recording's beginning
    std::optional<Seconds> seek_by{};    ///< relative to the position, or to the target of a running seek
    std::optional<Seconds> seek_clock{}; ///< time on the robot's clock
    bool step = false;                   ///< advances to the next bytes from the server
};

/// The robot to spawn, its name, and its start pose in the map frame.
struct SpawnRequest {
    std::string class_name = "USARBot.AirRobot";
    std::string robot_name = "R1";
    Pose start_in_map;
};

/// How long a session waits before it reports that something is missing, or ends its behavior. Tests shorten the
/// limits.
struct SessionLimits {
    link::LinkLimits link;
    Seconds greeting{5.0};                    ///< wall: no start poses after connecting
    Seconds spawn{5.0};                       ///< wall: silence after INIT means a failed spawn (protocol.md 2.4)
    Seconds stale = protocol::silence::robot; ///< wall: silence of a spawned robot
    Seconds sensor_silence = protocol::silence::sensor; ///< protocol clock: silence of a sensor that used to send
    Seconds hand{0.3};          ///< wall: silence of an input device that drives; it then counts as released
    agent::Patience behavior{}; ///< wall: the behavior's answers
    /// protocol clock: how long a behavior may run, from its start, before it is ended
    Seconds flight{std::numeric_limits<double>::infinity()};
    std::size_t unsent_bytes = 1u << 16; ///< above this, DRIVEs wait, and newer ones replace older ones
};

} // namespace usar::mission
