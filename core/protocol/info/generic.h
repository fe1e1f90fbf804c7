// A line whose type the tables do not know (yet): kept whole, shown, watched and recorded like any other.
#pragma once

#include <string>
#include <vector>

namespace usar::protocol {

struct KeyValue {
    std::string key{};
    std::string value{};
    bool operator==(const KeyValue&) const = default;
};

struct GenericMessage {
    std::string type_word{};
    std::string type{}; ///< value of the Type segment, empty where there is none
    std::string name{}; ///< first name of the line; of a grouped one (`{Name IR1 Range 0.5}`) the name alone
    std::vector<KeyValue> segments{};
    bool operator==(const GenericMessage&) const = default;
};

} // namespace usar::protocol
