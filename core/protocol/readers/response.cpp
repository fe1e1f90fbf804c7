#include "core/base/numbers.h"
#include "core/protocol/readers/info_readers.h"
#include "core/protocol/refill.h"

namespace usar::protocol {

namespace {

/// Each Status belongs to the thing before it. A thing begins with the first key on the line or the first key after a
/// Status, except ID and Mem.
void readParts(LineReading& line, Response& out) {
    Refill<ResponsePart> parts(out.parts);
    ResponsePart* part = nullptr;
    bool closed = true;
    for (const KeyedText& pair : line.pairs(false)) {
        if (sameWord(pair.key, "Status")) {
            if (part)
                part->ok = sameWord(pair.value, "OK");
            out.ok &= sameWord(pair.value, "OK");
            closed = true;
        } else if (sameWord(pair.key, "FOV")) {
            if (part)
                part->fov_rad = line.numberIn(pair.value);
        } else if (closed && !sameWord(pair.key, "ID") && !sameWord(pair.key, "Mem")) {
            part = &parts.next();
            part->key = pair.key;
            part->value = pair.value;
            part->ok = false;
            part->fov_rad.reset();
            closed = false;
        }
    }
}

} // namespace

bool read(LineReading& line, Response& out) {
    const Segments& segments = line.segments();
    if (!segments.find("Status")) {
        line.error(segments.line(), "a result without Status");
        return false;
    }
    out.time = line.time();
    out.type = segments.value("Type");
    out.name = segments.value("Name");
    out.ok = true;
    readParts(line, out);
    const Segment* const id = segments.find("ID");
    out.tag_id = id ? readInteger(id->value) : std::nullopt;
    const Segment* const memory = segments.find("Mem");
    out.memory = memory ? std::optional<std::string>(memory->value) : std::nullopt;
    return true;
}

} // namespace usar::protocol
