#include "core/protocol/commands/query.h"

#include <vector>

#include "core/protocol/sensors/table.h"

namespace usar::protocol {

namespace {

template <class... Sensors>
std::vector<std::string_view> typesWith(TypeList<Sensors...>) {
    std::vector<std::string_view> types = {"Robot", "MisPkg", "Actuator"};
    (forEachType(Sensors::wire_types, [&types](std::string_view word) { types.push_back(word); }), ...);
    types.insert(types.end(), {"Camera", "Battery", "Gripper", "ToolChanger", "Effecter"});
    return types;
}

} // namespace

std::span<const std::string_view> askedTypes() {
    static const std::vector<std::string_view> types = typesWith(SensorTypes{});
    return types;
}

} // namespace usar::protocol
