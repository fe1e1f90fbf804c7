// The alternatives of a std::variant: a concept, and a visitor out of one lambda for each.
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

/// A visitor for std::visit that calls the lambda for the variant's alternative.
template <class... Calls>
struct Overloaded : Calls... {
    using Calls::operator()...;
};

} // namespace usar
