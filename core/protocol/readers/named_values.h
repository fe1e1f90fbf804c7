// Values of sensors that come in groups: `{Name F1 Range 4.5} {Name F2 Range 2.4}` (UT2004) and `{Name F1} {Range 4.5}`
// (UDK), read alike.
#pragma once

#include <string_view>

#include "core/protocol/segments.h"

namespace usar::protocol {

/// Calls `take(name, value)` for every value under `key`, with the name before it (empty where there is none). The
/// views look into the line.
template <class Take>
void forEachNamedValue(const Segments& segments, std::string_view key, Take&& take) {
    std::string_view name;
    for (const Segment& segment : segments.all()) {
        if (sameWord(segment.key, key)) {
            take(name, segment.value);
            continue;
        }
        if (!sameWord(segment.key, "Name"))
            continue;
        NamedPairs pairs(segment.value);
        name = pairs.name();
        std::string_view pair_key;
        std::string_view value;
        while (pairs.next(pair_key, value)) {
            if (sameWord(pair_key, key))
                take(name, value);
        }
    }
}

} // namespace usar::protocol
