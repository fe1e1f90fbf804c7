// SEN messages of sensors that measure a single range: Sonar, IR and Range.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The range measured by one sensor; NaN if the server sent no number.
struct NamedRange {
    std::string name{};
    double range_m = 0.0;

    static constexpr auto items() { return std::tuple(item("Range", &NamedRange::range_m, "range", "m")); }
    bool operator==(const NamedRange&) const = default;
};

/// All sonars of one tick (UT2004), or a single one (UDK). A sonar that hears no echo gives its maximum range.
/// On the wire: `SEN {Time 395.6055} {Type Sonar} {Name F1 Range 4.5604} {Name F2 Range 2.4576}`.
struct SonarReadings {
    std::optional<Seconds> time{};
    std::vector<NamedRange> ranges{};

    static constexpr std::string_view wire_types = "Sonar";
    static constexpr auto groups() { return protocol::groups("Name", &SonarReadings::ranges); }
    bool operator==(const SonarReadings&) const = default;
};

/// Sensors that measure along a single ray (IR, and UDK's Range), grouped like sonars.
/// On the wire: `SEN {Time 1.5} {Type IR} {Name A Range 0.5122} {Name B Range 0.8}`.
struct RangeReadings {
    std::optional<Seconds> time{};
    std::vector<NamedRange> ranges{};
    std::string type = "IR"; ///< value of Type on the wire

    static constexpr std::string_view wire_types = "IR|Range";
    static constexpr auto groups() { return protocol::groups("Name", &RangeReadings::ranges); }
    bool operator==(const RangeReadings&) const = default;
};

} // namespace usar::protocol
