// A concept for the alternatives of a std::variant.
#pragma once

#include <type_traits>
#include <variant>

namespace usar {

/// True if `T` is exactly one of `Types`. The pointer only carries the variant's type; it may be null.
template <class T, class... Types>
constexpr bool isOneOf(const std::variant<Types...>*) {
    return (std::is_same_v<T, Types> || ...);
}

/// Satisfied if `T`, without const and reference, is an alternative of `Variant`.
template <class T, class Variant>
concept AlternativeOf = isOneOf<std::remove_cvref_t<T>>(static_cast<const Variant*>(nullptr));

} // namespace usar
