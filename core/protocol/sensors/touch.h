// SEN messages of touch sensors: Touch and TouchArray.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The state of one touch sensor.
struct NamedTouch {
    std::string name{};
    bool touched = false;

    static constexpr auto items() { return std::tuple(item("Touch", &NamedTouch::touched, "touched")); }
    bool operator==(const NamedTouch&) const = default;
};

/// All touch sensors of one tick (UT2004), or a single one or a ring of bumpers (UDK).
/// On the wire: `SEN {Type Touch} {Name L Touch False} {Name R Touch True}`.
struct TouchReadings {
    std::optional<Seconds> time{};
    std::vector<NamedTouch> touches{};
    std::string type = "Touch"; ///< value of Type on the wire

    static constexpr std::string_view wire_types = "Touch|TouchArray";
    static constexpr auto groups() { return protocol::groups("Name", &TouchReadings::touches); }
    bool operator==(const TouchReadings&) const = default;
};

} // namespace usar::protocol
