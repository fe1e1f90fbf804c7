// Watches a session for missing start poses, a silent robot or sensor, and a server that does not read.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/mission/session/notices.h"
#include "core/mission/session/session_orders.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Watches each sensor by type and name ("Sonar F1", "RangeScanner Scanner1", "INS"), including unknown types. Types
/// that send only when there is something to report (RFID, victims, sound) are not watched; a sonar message without a
/// number does not count as a reading. Names beyond `sensor_limit` are garbage and not watched. Times are on the
/// protocol clock. For one robot and one connection.
class SensorWatch {
public:
    static constexpr std::size_t sensor_limit = 100;

    explicit SensorWatch(Seconds limit) : limit_(limit) {}

    /// Takes a message; returns the names of sensors that were reported silent and send again with this message.
    std::vector<std::string> saw(const protocol::InfoMessage& message, Seconds now);
    /// Returns the names of sensors that have been silent for longer than the limit; each is reported once per silence.
    std::vector<std::string> newlySilent(Seconds now);
    void reset() { sensors_.clear(); }

private:
    struct Seen {
        Seconds last{0.0};
        bool reported = false; ///< as silent
    };
    using Sensors = std::map<std::string, Seen, std::less<>>;

    Seconds limit_;
    Sensors sensors_;
    std::string key_; ///< scratch, so that a message costs no allocation
};

/// Reads no clock: wall times are arguments, and count from any moment that stays the same. `now` is the protocol's
/// clock. Belongs to one session and its thread.
class Vigil {
public:
    /// `notices` must outlive this object.
    explicit Vigil(Notices& notices) : notices_(notices) {}

    /// Sets the time limits and forgets the sensors.
    void setLimits(const SessionLimits& limits);
    /// Forgets the sensors and everything that was reported missing.
    void beginConnection();
    /// Expects start poses from now on because the server was reached.
    void connected(Seconds wall) { connected_at_ = wall; }
    /// Resets the count of lines that were too long.
    void rewind() { overlong_ = 0; }

    void heardStartPoses();
    /// Takes a message from the robot itself. `now` is the protocol's clock after that message; a server that tells
    /// earlier times than that again and again has gone back in time, and is reported until it has caught up.
    void heardRobot(const protocol::InfoMessage& message, const std::string& robot_name, Seconds now, Seconds wall);
    /// Restarts the measurement of the robot's silence, which was not its fault so far.
    void forgive(Seconds wall) { heard_at_ = wall; }
    /// `expected`: the server's time is stopped on purpose, so silence is not reported.
    void expectSilence(bool expected, Seconds wall);
    /// Wall time since the last message from the robot; nullopt before the first one.
    std::optional<Seconds> silentFor(Seconds wall) const;

    void lookForStartPoses(Seconds wall);
    /// True from the report of a silent robot until it sends again or another connection begins.
    bool robotIsSilent() const { return silence_said_; }
    /// Reports a silent robot; to be called while a spawned robot should send.
    void lookForRobot(const std::string& robot_name, Seconds wall);
    /// Reports sensors that fell silent; an empty battery explains their silence.
    void lookForSensors(Seconds now, bool battery_is_empty);
    /// Reports that `unsent_bytes` are waiting because the server at `place` does not read.
    void lookAtQueue(std::size_t unsent_bytes, const std::string& place);
    /// Reports lines that were too long to read; `count` is their number so far.
    void lookAtOverlong(std::uint64_t count);
    std::uint64_t overlong() const { return overlong_; }

private:
    void heardTime(Seconds time, Seconds now);

    Notices& notices_;
    SessionLimits limits_;
    SensorWatch sensors_{limits_.sensor_silence};
    std::optional<Seconds> connected_at_; ///< wall
    std::optional<Seconds> heard_at_;     ///< wall
    std::uint64_t overlong_ = 0;
    int earlier_times_ = 0;            ///< in a row, told by the server although its clock had been further
    bool start_poses_settled_ = false; ///< they came, or their absence was reported
    bool silence_said_ = false;
    bool silence_expected_ = false;
};

} // namespace usar::mission
