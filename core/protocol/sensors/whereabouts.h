// SEN that tell one figure of where the robot is: AltitudeSensor, MagneticCompass (both UDK).
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// Up positive, in the wire's frame as in ours.
struct AltitudeReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<double> above_start_m{};
    std::optional<double> above_sea_m{};

    static constexpr std::string_view wire_types = "AltitudeSensor";
    static constexpr auto items() {
        return std::tuple(item("relativeAltitude", &AltitudeReading::above_start_m, "above_start", "m"),
                          item("absoluteAltitude", &AltitudeReading::above_sea_m, "above_sea", "m"));
    }
    bool operator==(const AltitudeReading&) const = default;
};

/// As sent, without a unit: the server cuts the angle to an int and converts it twice (usarsim-protocol 4.5).
struct CompassReading {
    std::optional<Seconds> time{};
    std::string name{};
    double raw_angle = 0.0;

    static constexpr std::string_view wire_types = "MagneticCompass";
    static constexpr auto items() { return std::tuple(item("MagneticAngle", &CompassReading::raw_angle, "raw_angle")); }
    bool operator==(const CompassReading&) const = default;
};

} // namespace usar::protocol
