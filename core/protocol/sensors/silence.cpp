#include "core/protocol/sensors/silence.h"

#include "core/base/text.h"
#include "core/protocol/sensors/table.h"

namespace usar::protocol {

namespace {

/// "RFID|RFIDTag" has "rfid".
bool hasWord(std::string_view wire_types, std::string_view word) {
    while (!wire_types.empty()) {
        const std::size_t end = std::min(wire_types.find('|'), wire_types.size());
        if (sameWord(wire_types.substr(0, end), word))
            return true;
        wire_types.remove_prefix(std::min(end + 1, wire_types.size()));
    }
    return false;
}

template <class Sensor>
bool isSilent(std::string_view wire_type) {
    if constexpr (requires { Sensor::speaks_always; })
        return !Sensor::speaks_always && hasWord(Sensor::wire_types, wire_type);
    else
        return false;
}

template <class... Sensors>
bool isAnySilent(TypeList<Sensors...>, std::string_view wire_type) {
    return (isSilent<Sensors>(wire_type) || ...);
}

} // namespace

bool speaksAlways(std::string_view wire_type) {
    return !isAnySilent(SensorTypes{}, wire_type);
}

} // namespace usar::protocol
