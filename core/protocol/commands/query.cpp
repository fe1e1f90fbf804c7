#include "core/protocol/commands/query.h"

#include <vector>

#include "core/protocol/sensors/table.h"

namespace usar::protocol {

namespace {

/// Adds each word of "RFID|RFIDTag".
void addWords(std::vector<std::string_view>& words, std::string_view wire_types) {
    for (std::size_t end = 0; end != std::string_view::npos; wire_types.remove_prefix(end + 1)) {
        end = wire_types.find('|');
        words.push_back(wire_types.substr(0, end));
    }
}

template <class... Sensors>
std::vector<std::string_view> typesWith(TypeList<Sensors...>) {
    std::vector<std::string_view> types = {"Robot", "MisPkg", "Actuator"};
    (addWords(types, Sensors::wire_types), ...);
    types.insert(types.end(), {"Camera", "Battery", "Gripper", "ToolChanger", "Effecter"});
    return types;
}

} // namespace

std::span<const std::string_view> askedTypes() {
    static const std::vector<std::string_view> types = typesWith(SensorTypes{});
    return types;
}

} // namespace usar::protocol
