#include "core/protocol/readers/table.h"

namespace usar::protocol {

std::optional<InfoMessage> readResponse(LineReading& line) {
    const Segments& segments = line.segments();
    if (!segments.find("Status")) {
        line.error(segments.line(), "a result without Status");
        return std::nullopt;
    }
    Response result;
    result.time = line.time();
    result.type = segments.value("Type");
    result.name = segments.value("Name");
    result.ok = true;
    for (const Segment& segment : segments.all()) {
        if (sameWord(segment.key, "Status"))
            result.ok &= sameWord(segment.value, "OK");
    }
    return result;
}

} // namespace usar::protocol
