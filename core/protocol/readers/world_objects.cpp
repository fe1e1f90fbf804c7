#include <utility>

#include "core/base/text.h"
#include "core/protocol/readers/info_readers.h"

namespace usar::protocol {

namespace {

/// Splits the value of a Location segment into location and memory. The server's braces are malformed: `{Location x,y,z
/// {Memory {m} {Rotation r,p,y}` (protocol.md 5.8), so that the tokenizer returns Location and Memory as one
/// segment.
std::pair<std::string_view, std::string_view> splitMemory(std::string_view location) {
    const std::size_t brace = location.find('{');
    if (brace == std::string_view::npos)
        return {location, {}};
    std::string_view memory = location.substr(brace + 1);
    takeWord(memory);
    memory = trimmed(memory);
    if (memory.starts_with('{'))
        memory.remove_prefix(1);
    return {trimmed(location.substr(0, brace)), trimmed(memory)};
}

struct ObjectText {
    std::string_view location;
    std::string_view rotation;
};

bool finish(LineReading& line, const ObjectText& text, WorldObject& object) {
    const std::optional<Pose> pose =
        line.pose(text.location, text.rotation.empty() ? std::string_view("0,0,0") : text.rotation);
    object.object_in_map = pose.value_or(Pose{});
    return pose.has_value();
}

} // namespace

bool read(LineReading& line, WorldObjects& out) {
    out.objects.clear();
    ObjectText text;
    bool good = true;
    for (const KeyedText& pair : line.pairs(false)) {
        if (sameWord(pair.key, "Name")) {
            if (!out.objects.empty())
                good &= finish(line, text, out.objects.back());
            text = {};
            out.objects.emplace_back().name = pair.value;
        } else if (out.objects.empty()) {
            continue;
        } else if (sameWord(pair.key, "Size")) {
            good &= take(line, pair.value, out.objects.back().size_m, Crossing::None);
        } else if (sameWord(pair.key, "Location")) {
            const auto [location, memory] = splitMemory(pair.value);
            text.location = location;
            out.objects.back().memory = memory;
        } else if (sameWord(pair.key, "Memory")) {
            out.objects.back().memory = pair.value;
        } else if (sameWord(pair.key, "Rotation")) {
            text.rotation = pair.value;
        }
    }
    if (!out.objects.empty())
        good &= finish(line, text, out.objects.back());
    return good;
}

} // namespace usar::protocol
