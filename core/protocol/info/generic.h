// A line whose type the tables do not know. It is kept whole, and displayed, watched and recorded like any other.
#pragma once

#include <string>
#include <vector>

namespace usar::protocol {

/// A segment: its key and the trimmed text after it, both as sent.
struct KeyValue {
    std::string key{};
    std::string value{};
    bool operator==(const KeyValue&) const = default;
};

/// All segments of the line in order, including Type and Name. Values are in the wire's frame and units.
struct GenericMessage {
    std::string type_word{};
    std::string type{}; ///< value of the Type segment, empty if there is none
    std::string name{}; ///< first name on the line; only "IR1" if grouped, `{Name IR1 Range 0.5}`
    std::vector<KeyValue> segments{};
    bool operator==(const GenericMessage&) const = default;
};

} // namespace usar::protocol
