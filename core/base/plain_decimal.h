// A fast, exact reader for numbers in the form that servers actually send ("4.5604").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace usar {

/// Reads [-]digits[.digits] at `at`, gives the same double as std::from_chars, and advances `at` past the number.
/// Returns false and leaves `at` unchanged for everything that needs readNumberPrefix: exponents, words, a plus sign,
/// more than 15 digits. The result is exact because integers of 15 digits and powers of ten up to 10^15 are
/// representable as doubles, so that the single division rounds correctly (Clinger, "How to read floating point numbers
/// accurately", 1990). Precondition: `at` <= `end`; `value` is unchanged if this returns false.
inline bool readPlainDecimal(const char*& at, const char* end, double& value) {
    static constexpr std::array<double, 16> powers_of_ten = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                             1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* p = at;
    const bool negative = p != end && *p == '-';
    p += negative;
    std::uint64_t whole = 0;
    const char* const first = p;
    for (; p != end && *p >= '0' && *p <= '9'; ++p)
        whole = 10 * whole + static_cast<std::uint64_t>(*p - '0');
    auto digits = p - first;
    std::size_t decimals = 0;
    if (p != end && *p == '.') {
        const char* const point = p++;
        for (; p != end && *p >= '0' && *p <= '9'; ++p)
            whole = 10 * whole + static_cast<std::uint64_t>(*p - '0');
        decimals = static_cast<std::size_t>(p - point - 1);
        digits += p - point - 1;
    }
    if (digits == 0 || digits > 15 || (p != end && (*p == 'e' || *p == 'E' || *p == '#')))
        return false;
    const double magnitude = static_cast<double>(whole) / powers_of_ten[decimals];
    value = negative ? -magnitude : magnitude;
    at = p;
    return true;
}

} // namespace usar
