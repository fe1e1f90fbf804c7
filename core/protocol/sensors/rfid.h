// The SEN message of an RFID reader: the radio tags in reach.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// One tag. The server's version and configuration decide which values it sends besides the id.
struct SeenTag {
    long long id = 0;
    std::optional<Vec3> tag_in_reader_m{}; ///< position in the reader's frame
    std::optional<std::string> memory{};   ///< text stored in the tag; may contain spaces

    static constexpr auto items() {
        return std::tuple(item("ID", &SeenTag::id, "id"),
                          item("Location", &SeenTag::tag_in_reader_m, "", "m", Crossing::Vector, Decimals::TwoRounded),
                          item("Mem", &SeenTag::memory, "memory"));
    }
    bool operator==(const SeenTag&) const = default;
};

/// All tags in reach. Sent when the list changes.
/// On the wire: `SEN {Time 8} {Type RFID} {Name R} {ID 21} {Location 3,4.5,0.25} {Mem seen by robot 2} {ID 22}`.
struct RfidReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<SeenTag> tags{};
    std::string type = "RFID"; ///< value of Type on the wire

    static constexpr std::string_view wire_types = "RFID|RFIDTag";
    static constexpr bool speaks_always = false;
    static constexpr auto groups() { return protocol::groups("ID", &RfidReading::tags); }
    bool operator==(const RfidReading&) const = default;
};

} // namespace usar::protocol
