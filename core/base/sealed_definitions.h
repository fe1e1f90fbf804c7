// The bodies of Sealed, for the one source file that instantiates it for a variant: `template class
// Sealed<MyVariant>;`.
#pragma once

#include "core/base/sealed.h"

namespace usar {

template <class Variant>
Sealed<Variant>::Sealed() = default;
template <class Variant>
Sealed<Variant>::Sealed(const Sealed& other) = default;
template <class Variant>
Sealed<Variant>::Sealed(Sealed&& other) noexcept = default;
template <class Variant>
Sealed<Variant>& Sealed<Variant>::operator=(const Sealed& other) = default;
template <class Variant>
Sealed<Variant>& Sealed<Variant>::operator=(Sealed&& other) noexcept = default;
template <class Variant>
Sealed<Variant>::~Sealed() = default;

template <class Variant>
bool Sealed<Variant>::operator==(const Sealed& other) const {
    return static_cast<const Variant&>(*this) == static_cast<const Variant&>(other);
}

} // namespace usar
