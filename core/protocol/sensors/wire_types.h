// The words with which servers name the type of a sensor in a SEN line, as a list: "RFID|RFIDTag".
#pragma once

#include <string_view>

namespace usar::protocol {

/// The first of the words in `wire_types`, "IR|Range", which is the one we write.
constexpr std::string_view firstType(std::string_view wire_types) {
    return wire_types.substr(0, wire_types.find('|'));
}

/// Calls `use(word)` for each of the words.
template <class Use>
constexpr void forEachType(std::string_view wire_types, Use&& use) {
    while (!wire_types.empty()) {
        const std::string_view word = firstType(wire_types);
        use(word);
        wire_types.remove_prefix(word.size() + (word.size() < wire_types.size() ? 1 : 0));
    }
}

} // namespace usar::protocol
