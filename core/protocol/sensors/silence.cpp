#include "core/protocol/sensors/silence.h"

#include "core/base/text.h"
#include "core/protocol/sensors/table.h"

namespace usar::protocol {

namespace {

template <class Sensor>
bool isSilent(std::string_view wire_type) {
    bool silent = false;
    if constexpr (requires { Sensor::speaks_always; })
        forEachType(Sensor::wire_types,
                    [&](std::string_view word) { silent |= !Sensor::speaks_always && sameWord(word, wire_type); });
    return silent;
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
