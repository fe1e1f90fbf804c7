// SEN RFID: radio tags in reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// Which parts there are beside the number depends on version and configuration of the server.
struct SeenTag {
    long long id = 0;
    std::optional<Vec3> tag_in_reader_m{};
    std::optional<std::string> memory{}; ///< may hold spaces

    static constexpr auto items() {
        return std::tuple(item("ID", &SeenTag::id, "id"),
                          item("Location", &SeenTag::tag_in_reader_m, "", "m", Crossing::Vector, Decimals::TwoRounded),
                          item("Mem", &SeenTag::memory, "memory"));
    }
    bool operator==(const SeenTag&) const = default;
};

/// Sent when the list changes.
struct RfidReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<SeenTag> tags{};
    std::string type = "RFID"; ///< on the wire

    static constexpr std::string_view wire_types = "RFID|RFIDTag";
    static constexpr auto groups() { return protocol::groups("ID", &RfidReading::tags); }
    bool operator==(const RfidReading&) const = default;
};

} // namespace usar::protocol
