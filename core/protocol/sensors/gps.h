// The SEN message of a GPS receiver.
#pragma once

#include <optional>
#include <string>

#include "core/base/clock.h"

namespace usar::protocol {

class FieldList;
class LineReading;
class LineWriter;

/// Latitude (north positive) and longitude (east positive), both absent without a fix, which takes four satellites. On
/// the wire they are whole degrees, minutes and a letter.
/// On the wire: `SEN {Type GPS} {Name G} {Latitude 47,30.0000,N} {Longitude 122,18.0000,W} {Fix 1} {Satellites 8}`.
struct GpsReading {
    std::optional<Seconds> time{};
    std::string name{};
    std::optional<double> latitude_rad{};
    std::optional<double> longitude_rad{};
    bool fix = false;
    std::optional<long long> satellites{};

    static constexpr std::string_view wire_types = "GPS";
    bool operator==(const GpsReading&) const = default;
};

/// Fills all of `out`. False if the line has neither a Fix nor a Latitude, or an invalid number of satellites.
bool read(LineReading& line, GpsReading& out);
/// Writes the line without CR LF.
void write(LineWriter& line, const GpsReading& reading);
/// Adds the values of the reading; the caller has set source and item.
void list(FieldList& fields, const GpsReading& reading);

} // namespace usar::protocol
