// Whether a type is one of a variant's.
#pragma once

#include <type_traits>
#include <variant>

namespace usar {

template <class T, class... Types>
constexpr bool isOneOf(const std::variant<Types...>*) {
    return (std::is_same_v<T, Types> || ...);
}

/// `T` may be a reference.
template <class T, class Variant>
concept AlternativeOf = isOneOf<std::remove_cvref_t<T>>(static_cast<const Variant*>(nullptr));

} // namespace usar
