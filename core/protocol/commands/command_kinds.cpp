#include "core/protocol/commands/command_kinds.h"

#include "core/protocol/commands/line_rules.h"

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

} // namespace

std::span<const CommandKind> commandKinds() {
    static const std::vector<CommandKind> kinds = kindsOf(static_cast<const CommandVariant*>(nullptr));
    return kinds;
}

} // namespace usar::protocol
