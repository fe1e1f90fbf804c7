#include "core/protocol/sensors/gps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/geometry.h"
#include "core/base/text.h"
#include "core/protocol/field_list.h"
#include "core/protocol/line_writer.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

namespace {

/// Reads an angle in rad from a text such as `47,40.3323,N`: degrees, minutes and one of the two `letters`, of which
/// the first stands for positive angles. Absent, with a warning, if it is malformed.
std::optional<double> readAngle(LineReading& line, std::string_view key, std::string_view letters) {
    const Segment* const segment = line.segments().find(key);
    if (!segment)
        return std::nullopt;
    std::string_view rest = segment->value;
    std::array<double, 2> degrees_and_minutes{};
    const bool numbers = takeNumbers(rest, degrees_and_minutes);
    const std::string_view letter = trimmed(rest.substr(std::min(rest.find_first_not_of(", "), rest.size())));
    const bool positive = sameWord(letter, letters.substr(0, 1));
    if (!numbers || !(positive || sameWord(letter, letters.substr(1)))) {
        line.warn(segment->text,
                  "'" + std::string(segment->text.substr(0, 40)) + "' is not degrees, minutes and a letter");
        return std::nullopt;
    }
    const double angle_rad = radians(degrees_and_minutes[0] + degrees_and_minutes[1] / 60.0);
    return positive ? angle_rad : -angle_rad;
}

void writeAngle(LineWriter& line, std::string_view key, double angle_rad, std::string_view letters) {
    const double angle_deg = degrees(std::abs(angle_rad));
    // The wire truncates minutes after the fourth decimal; the small addition makes an angle that was read from the
    // wire come out with the same digits.
    const double minutes = angle_deg * 60.0 + 5e-7;
    const double whole = std::floor(minutes / 60.0);
    line.open(key);
    line.text(std::to_string(static_cast<long long>(whole)));
    line.text(",");
    line.number(minutes - 60.0 * whole, Decimals::FourCut);
    line.text(",");
    line.text(angle_rad < 0 ? letters.substr(1) : letters.substr(0, 1));
    line.close();
}

} // namespace

bool read(LineReading& line, GpsReading& out) {
    const Segment* const fix = line.segments().find("Fix");
    if (!fix && !line.segments().find("Latitude"))
        return false;
    out.time = line.time();
    out.name = line.segments().value("Name");
    out.latitude_rad = readAngle(line, "Latitude", "NS");
    out.longitude_rad = readAngle(line, "Longitude", "EW");
    out.fix = fix ? line.boolean("Fix").value_or(false) : out.latitude_rad.has_value();
    const Segment* const satellites = line.segments().find("Satellites");
    out.satellites.reset();
    return !satellites || take(line, satellites->value, out.satellites, Crossing::None);
}

void write(LineWriter& line, const GpsReading& reading) {
    line.sensor(reading.time, GpsReading::wire_types);
    line.segment("Name", reading.name);
    if (reading.latitude_rad)
        writeAngle(line, "Latitude", *reading.latitude_rad, "NS");
    if (reading.longitude_rad)
        writeAngle(line, "Longitude", *reading.longitude_rad, "EW");
    line.whole("Fix", reading.fix ? 1 : 0);
    line.whole("Satellites", reading.satellites);
}

void list(FieldList& fields, const GpsReading& reading) {
    fields.number("latitude", reading.latitude_rad, "rad");
    fields.number("longitude", reading.longitude_rad, "rad");
    fields.flag("fix", reading.fix);
    fields.number("satellites", reading.satellites);
}

} // namespace usar::protocol
