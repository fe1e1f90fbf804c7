#include <cmath>

#include "core/base/numbers.h"
#include "core/protocol/readers/table.h"

namespace usar::protocol {

namespace {

std::optional<double> finite(std::optional<double> number) {
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace

std::optional<InfoMessage> readConfiguration(LineReading& line) {
    const Segments& segments = line.segments();
    if (!segments.find("Type") && !segments.find("Name"))
        return std::nullopt;
    ConfigurationInfo result;
    result.type = segments.value("Type");
    for (const Segment& segment : segments.all()) {
        if (sameWord(segment.key, "Type"))
            continue;
        if (sameWord(segment.key, "Name")) {
            result.items.push_back({std::string(segment.value), {}});
            continue;
        }
        if (result.items.empty())
            result.items.emplace_back();
        result.items.back().settings.push_back(
            {std::string(segment.key), std::string(segment.value), finite(readNumber(segment.value))});
    }
    return result;
}

} // namespace usar::protocol
