// SEN Sonar.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// One range; NaN where the server sent no number.
struct NamedRange {
    std::string name{};
    double range_m = 0.0;

    static constexpr auto items() { return std::tuple(item("Range", &NamedRange::range_m, "range", "m")); }
    bool operator==(const NamedRange&) const = default;
};

/// All sonars of a tick (UT2004) or one of them (UDK). The reading saturates at the maximum range.
struct SonarReadings {
    std::optional<Seconds> time{};
    std::vector<NamedRange> ranges{};

    static constexpr std::string_view wire_types = "Sonar";
    static constexpr auto groups() { return protocol::groups("Name", &SonarReadings::ranges); }
    bool operator==(const SonarReadings&) const = default;
};

/// Single rays, IR and UDK's Range, as sonars.
struct RangeReadings {
    std::optional<Seconds> time{};
    std::vector<NamedRange> ranges{};
    std::string type = "IR"; ///< on the wire

    static constexpr std::string_view wire_types = "IR|Range";
    static constexpr auto groups() { return protocol::groups("Name", &RangeReadings::ranges); }
    bool operator==(const RangeReadings&) const = default;
};

} // namespace usar::protocol
