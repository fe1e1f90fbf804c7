// SEN messages with a single figure about the robot's pose: AltitudeSensor and MagneticCompass (both UDK only).
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// Altitudes; up is positive, on the wire as in our frame.
/// On the wire: `SEN {Time 32.1} {Type AltitudeSensor} {Name a} {relativeAltitude 1.25} {absoluteAltitude 141.25}`.
struct AltitudeReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<double> above_start_m{}; ///< the server's relative altitude
    std::optional<double> above_sea_m{};   ///< the server's absolute altitude

    static constexpr std::string_view wire_types = "AltitudeSensor";
    static constexpr auto items() {
        return std::tuple(item("relativeAltitude", &AltitudeReading::above_start_m, "above_start", "m"),
                          item("absoluteAltitude", &AltitudeReading::above_sea_m, "above_sea", "m"));
    }
    bool operator==(const AltitudeReading&) const = default;
};

/// The heading as sent, without a unit: the server truncates the angle to an int and converts it twice
/// (protocol.md 4.5).
/// On the wire: `SEN {Time 1} {Type MagneticCompass} {Name c} {MagneticAngle 2}`.
struct CompassReading {
    std::optional<Seconds> time{};
    std::string name{};
    double raw_angle = 0.0;

    static constexpr std::string_view wire_types = "MagneticCompass";
    static constexpr auto items() { return std::tuple(item("MagneticAngle", &CompassReading::raw_angle, "raw_angle")); }
    bool operator==(const CompassReading&) const = default;
};

} // namespace usar::protocol
