// Notices what is missing in a session: start poses, the robot's voice, a sensor, a server that reads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/mission/session/notices.h"
#include "core/mission/session/sensor_watch.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Reads no clock: wall times are arguments, and count from any moment that stays the same. `now` is the protocol's
/// clock. Belongs to one session and its thread.
class Vigil {
public:
    /// `notices` must outlive this object.
    explicit Vigil(Notices& notices) : notices_(notices) {}

    /// Forgets the sensors.
    void setLimits(const SessionLimits& limits);
    /// Forgets the sensors, and all that was missing.
    void beginConnection();
    /// The server was reached; start poses are expected from now on.
    void connected(Seconds wall) { connected_at_ = wall; }
    /// Forgets how many lines were too long.
    void rewind() { overlong_ = 0; }

    void heardStartPoses();
    /// Takes a message of the robot itself.
    void heardRobot(const protocol::InfoMessage& message, const std::string& robot_name, Seconds now, Seconds wall);
    /// The silence until now was not the robot's fault.
    void forgive(Seconds wall) { heard_at_ = wall; }
    /// `expected`: the server's time is stopped on purpose, so silence is not reported.
    void expectSilence(bool expected, Seconds wall);
    /// For how long nothing has come from a robot; absent before the first word.
    std::optional<Seconds> silentFor(Seconds wall) const;

    void lookForStartPoses(Seconds wall);
    /// For a robot that has spawned and should speak.
    void lookForRobot(const std::string& robot_name, Seconds wall);
    /// An empty battery explains a sensor's silence.
    void lookForSensors(Seconds now, bool battery_is_empty);
    /// `unsent_bytes` wait because the server at `place` does not read.
    void lookAtQueue(std::size_t unsent_bytes, const std::string& place);
    /// `count`: lines so far that were too long to read.
    void lookAtOverlong(std::uint64_t count);
    std::uint64_t overlong() const { return overlong_; }

private:
    Notices& notices_;
    SessionLimits limits_;
    SensorWatch sensors_{limits_.sensor_silence};
    std::optional<Seconds> connected_at_; ///< wall
    std::optional<Seconds> heard_at_;     ///< wall
    std::uint64_t overlong_ = 0;
    bool start_poses_settled_ = false; ///< they came, or their absence was reported
    bool silence_said_ = false;
    bool silence_expected_ = false;
};

} // namespace usar::mission
