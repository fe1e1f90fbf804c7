#include "core/protocol/readers/described.h"
#include "core/protocol/readers/info_readers.h"

namespace usar::protocol {

bool read(LineReading& line, PackageState& out) {
    return readDescribed(line, out);
}

bool read(LineReading& line, EffecterState& out) {
    const Segments& segments = line.segments();
    out.time = line.time();
    out.type = segments.value("Type");
    out.name = segments.value("Name");
    out.tool_type = segments.value("ToolType");
    out.tool = segments.value("Tool");
    out.closed = out.on = std::nullopt;
    const auto takeWord = [&out](std::string_view word) {
        if (sameWord(word, "Open") || sameWord(word, "Closed"))
            out.closed = sameWord(word, "Closed");
        else if (sameWord(word, "On") || sameWord(word, "Off"))
            out.on = sameWord(word, "On");
    };
    for (const Segment& segment : segments.all())
        takeWord(sameWord(segment.key, "Status") ? segment.value : segment.key);
    return out.closed || out.on || !out.tool.empty();
}

} // namespace usar::protocol
