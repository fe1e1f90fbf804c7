// Notices sensors that used to speak and have stopped.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Watches each sensor by type and name ("Sonar F1", "RangeScanner Scanner1", "INS"), also those of types that no table
/// knows. Types that speak only when there is something to say (RFID, victims, sound) are nobody's worry; a sonar
/// without a number has not spoken. Names beyond `sensor_limit` are garbage and not watched. Times
/// are the protocol clock's. One robot, one connection.
class SensorWatch {
public:
    static constexpr std::size_t sensor_limit = 100;

    explicit SensorWatch(Seconds limit) : limit_(limit) {}

    /// Names of sensors that were reported silent and speak again with this message.
    std::vector<std::string> saw(const protocol::InfoMessage& message, Seconds now);
    /// Names of sensors silent for longer than the limit that were not reported yet; each once per silence.
    std::vector<std::string> newlySilent(Seconds now);
    void reset() { sensors_.clear(); }

private:
    struct Seen {
        Seconds last{0.0};
        bool reported = false;
    };
    using Sensors = std::map<std::string, Seen, std::less<>>;

    Seconds limit_;
    Sensors sensors_;
    std::string key_; ///< scratch, so that a message costs no allocation
};

} // namespace usar::mission
