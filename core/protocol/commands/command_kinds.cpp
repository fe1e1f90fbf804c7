#include "core/protocol/commands/command_kinds.h"

#include "core/protocol/commands/line_rules.h"
#include "core/protocol/sensors/table.h"

namespace usar::protocol {

namespace {

template <class T>
Command readAs(LineIn& line) {
    T value = blank<T>();
    T::segments(line, value);
    return value;
}

template <class T>
CommandKind describe() {
    LineRules rules;
    const T any = blank<T>();
    T::segments(rules, any);
    CommandKind kind{T::word, std::move(rules.segments), std::move(rules.marks), {}, {}, readAs<T>};
    if constexpr (requires { T::signs; })
        kind.signs = T::signs;
    if constexpr (requires { T::weak_signs; })
        kind.weak_signs = T::weak_signs;
    return kind;
}

template <class... Commands>
std::vector<CommandKind> kindsOf(const std::variant<RawCommand, Commands...>*) {
    std::vector<CommandKind> kinds;
    (kinds.push_back(describe<Commands>()), ...);
    return kinds;
}

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

std::span<const CommandKind> commandKinds() {
    static const std::vector<CommandKind> kinds = kindsOf(static_cast<const CommandVariant*>(nullptr));
    return kinds;
}

} // namespace usar::protocol
