// SEN messages about turning wheels: Encoder and Tachometer.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The count of one encoder since its last reset.
struct EncoderTicks {
    std::string name{};
    long long ticks = 0; ///< as sent; a P2DX counts down when it rolls forward

    static constexpr auto items() { return std::tuple(item("Tick", &EncoderTicks::ticks, "ticks")); }
    bool operator==(const EncoderTicks&) const = default;
};

/// All encoders of one tick (UT2004), or a single one (UDK).
/// On the wire: `SEN {Type Encoder} {Name ECLeft Tick -30} {Name ECRight Tick -18}`.
struct EncoderReadings {
    std::optional<Seconds> time{};
    std::vector<EncoderTicks> encoders{};

    static constexpr std::string_view wire_types = "Encoder";
    static constexpr auto groups() { return protocol::groups("Name", &EncoderReadings::encoders); }
    bool operator==(const EncoderReadings&) const = default;
};

/// Speed and angle of each wheel in the robot's own order; positive is forward. If UDK measures twice in one instant,
/// the second line has only a name and is ignored.
/// On the wire: `SEN {Time 48} {Type Tachometer} {Name T} {Vel 0.5,-0.25} {Pos 1,2}`.
struct TachometerReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<double> speeds_rad_s{}; ///< one for each wheel; so is `angles_rad`
    std::vector<double> angles_rad{};

    static constexpr std::string_view wire_types = "Tachometer";
    static constexpr auto items() {
        return std::tuple(item("Vel", &TachometerReading::speeds_rad_s, "speed", "rad/s"),
                          item("Pos", &TachometerReading::angles_rad, "angle", "rad"));
    }
    bool operator==(const TachometerReading&) const = default;
};

} // namespace usar::protocol
