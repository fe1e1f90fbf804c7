// SEN Geiger: the one file that a new sensor takes. Nothing else in the tree knows of it.
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

struct GeigerReading {
    std::optional<Seconds> time{};
    std::string name{};
    double dose_gy = 0.0;
    std::optional<Vec3> source_in_sensor_m{};

    static constexpr std::string_view wire_types = "Geiger";
    static constexpr auto items() {
        return std::tuple(item("Dose", &GeigerReading::dose_gy, "dose", "Gy"),
                          item("Source", &GeigerReading::source_in_sensor_m, "source", "m", Crossing::Vector));
    }
    bool operator==(const GeigerReading&) const = default;
};

} // namespace usar::protocol
