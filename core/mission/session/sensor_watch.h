// Notices sensors that used to send readings and have stopped.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
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

} // namespace usar::mission
