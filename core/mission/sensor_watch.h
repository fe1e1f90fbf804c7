// Notices sensors that used to speak and have stopped.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/info_message.h"

namespace usar::mission {

/// Watches the sensor types that speak on every tick; types that speak only when something changes (RFID, victims) are
/// nobody's worry. Times are the protocol clock's. One robot, one connection.
class SensorWatch {
public:
    explicit SensorWatch(Seconds limit) : limit_(limit) {}

    void saw(const protocol::InfoMessage& message, Seconds now);
    /// Types silent for longer than the limit that were not reported yet; each is reported once per silence.
    std::vector<std::string> newlySilent(Seconds now);
    void reset() { sensors_ = {}; }

private:
    struct Seen {
        Seconds last{0.0};
        bool reported = false;
    };
    Seconds limit_;
    std::array<std::optional<Seen>, 6> sensors_;
};

} // namespace usar::mission
