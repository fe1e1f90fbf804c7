#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
#include "core/base/plain_decimal.h"
#include "core/base/text.h"
#include "core/protocol/readers/table.h"

namespace usar::protocol {

namespace {

/// An element that is no plain decimal, up to its comma. Infinity and junk are NaN; `doubtful` counts what is not
/// clean.
double readOddElement(const char*& at, const char* end, std::size_t& doubtful) {
    const char* const stop = std::find(at, end, ',');
    const std::string_view element = trimmed({at, static_cast<std::size_t>(stop - at)});
    at = stop;
    const NumberPrefix prefix = readNumberPrefix(element);
    if (prefix.used != element.size() || !std::isfinite(prefix.value) || element.empty())
        ++doubtful;
    return prefix.used == 0 ? std::numeric_limits<double>::quiet_NaN() : prefix.value;
}

/// A list with commas; one more comma may follow the last element, as UDK's imagers send it.
std::vector<double> readRanges(std::string_view list, std::size_t& doubtful) {
    std::vector<double> ranges_m;
    list = trimmed(list);
    if (list.ends_with(','))
        list.remove_suffix(1);
    if (list.empty())
        return ranges_m;
    ranges_m.reserve(static_cast<std::size_t>(std::count(list.begin(), list.end(), ',')) + 1);
    const char* at = list.data();
    const char* const end = at + list.size();
    while (true) {
        const char* const start = at;
        double range_m = 0.0;
        if (!readPlainDecimal(at, end, range_m) || (at != end && *at != ',')) {
            at = start;
            range_m = readOddElement(at, end, doubtful);
        }
        ranges_m.push_back(range_m);
        if (at == end)
            return ranges_m;
        ++at;
    }
}

/// One number alone; 3D scanners and imagers send two and are another shape.
bool holdsOneNumber(std::string_view value) {
    return readNumber(value).has_value();
}

} // namespace

std::optional<InfoMessage> readRangeScan(LineReading& line) {
    const Segments& segments = line.segments();
    const Segment* const range = segments.find("Range");
    if (!range && !segments.find("FOV") && !segments.find("Resolution"))
        return std::nullopt;
    const std::optional<double> fov_rad = line.number("FOV");
    const std::optional<double> resolution_rad = line.number("Resolution");
    if (!range || !fov_rad || !resolution_rad) {
        line.error(segments.line(), "a scan needs FOV, Resolution and Range");
        return std::nullopt;
    }
    RangeScan scan;
    scan.time = line.time();
    scan.name = segments.value("Name");
    if (!sameWord(segments.value("Type"), scan.type))
        scan.type = segments.value("Type");
    scan.resolution_rad = *resolution_rad;
    scan.fov_rad = *fov_rad;
    std::size_t doubtful = 0;
    scan.ranges_m = readRanges(range->value, doubtful);
    if (doubtful > 0)
        line.warn(range->text, std::to_string(doubtful) + " of " + std::to_string(scan.ranges_m.size()) +
                                   " ranges are not plain numbers");
    return scan;
}

std::optional<InfoMessage> readRangeScanByShape(LineReading& line) {
    const Segments& segments = line.segments();
    const bool scanner =
        segments.find("Range") && holdsOneNumber(segments.value("FOV")) && holdsOneNumber(segments.value("Resolution"));
    return scanner ? readRangeScan(line) : std::nullopt;
}

} // namespace usar::protocol
