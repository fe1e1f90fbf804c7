// Converts numbers to text and back, independent of the locale; `core` uses these functions instead of the C library's.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace usar {

/// A number and how many bytes of the text it took. `used` is 0 if the text does not begin with a number.
struct NumberPrefix {
    double value = 0.0;
    std::size_t used = 0;
};

/// Reads the longest number at the start of `text` as C's atof does (sign, leading dot, exponent), but skips no leading
/// spaces. Any C run-time library's spelling of "not a number" or infinity (nan, inf, -1.#IND, 1.#QNAN, 1.#INF) gives
/// NaN, and so does a value outside the range of a double, because no sensor can mean it.
NumberPrefix readNumberPrefix(std::string_view text);

/// Reads `text` as one number, with optional spaces around it; nullopt if it is anything else. May return NaN, as
/// readNumberPrefix does.
std::optional<double> readNumber(std::string_view text);
/// The same for a decimal integer; nullopt also if it does not fit.
std::optional<long long> readInteger(std::string_view text);

/// Appends `value` with exactly `decimals` decimals, rounded half to even as printf does.
void appendFixed(std::string& out, double value, int decimals);
/// The same, but truncated toward zero: Unreal's four-decimal formatter prints pi as 3.1415.
void appendTruncated(std::string& out, double value, int decimals);
/// Appends the shortest text that reads back as the same double.
void appendShortest(std::string& out, double value);
/// Returns what appendFixed appends.
std::string fixed(double value, int decimals);
/// Returns what appendShortest appends.
std::string shortest(double value);

} // namespace usar
