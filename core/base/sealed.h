// A variant that is compiled in one place, and a concept for the alternatives of any variant.
#pragma once

#include <type_traits>
#include <utility>
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

/// Use it like the std::variant that it derives from. The code that copies, compares and destroys fifty alternatives
/// takes many seconds to compile, so it is compiled only where sealed_definitions.h is included, and not wherever a
/// value is stored.
template <class Variant>
class Sealed : public Variant {
public:
    Sealed();
    Sealed(const Sealed& other);
    Sealed(Sealed&& other) noexcept;
    Sealed& operator=(const Sealed& other);
    Sealed& operator=(Sealed&& other) noexcept;
    ~Sealed();

    /// Holds a copy of one of the alternatives.
    template <AlternativeOf<Variant> One>
    Sealed(One&& one) : Variant(std::in_place_type<std::decay_t<One>>, std::forward<One>(one)) {}

    bool operator==(const Sealed& other) const;
    /// Deleted because Qt's meta types look for it and would find the variant's, which needs one for each alternative.
    friend bool operator<(const Sealed&, const Sealed&) = delete;
};

} // namespace usar
