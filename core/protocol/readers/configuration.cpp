#include <cmath>

#include "core/base/numbers.h"
#include "core/protocol/readers/info_readers.h"

namespace usar::protocol {

namespace {

std::optional<double> finite(std::optional<double> number) {
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace

bool read(LineReading& line, ConfigurationInfo& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Type") && !segments.find("Name"))
        return false;
    out.type = segments.value("Type");
    out.items.clear();
    for (const Segment& segment : segments.all()) {
        if (sameWord(segment.key, "Type"))
            continue;
        if (sameWord(segment.key, "Name")) {
            out.items.push_back({std::string(segment.value), {}});
            continue;
        }
        if (out.items.empty())
            out.items.emplace_back();
        out.items.back().settings.push_back(
            {std::string(segment.key), std::string(segment.value), finite(readNumber(segment.value))});
    }
    return true;
}

} // namespace usar::protocol
