// Numbers to text and back, whatever the locale. The only readers and writers of numbers in `core`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace usar {

/// A number and how many bytes of the text it took; used is 0 where no number begins the text.
struct NumberPrefix {
    double value = 0.0;
    std::size_t used = 0;
};

/// Longest number at the start of `text`, as C's atof takes it: sign, leading dot, exponent; nothing else. Spellings
/// of "not a number" and infinity of any C run-time (nan, inf, -1.#IND, 1.#QNAN, 1.#INF) give NaN: a value that no
/// sensor can mean is not a number to us.
NumberPrefix readNumberPrefix(std::string_view text);

/// The number that is the whole of `text` (spaces around it allowed), or nothing.
std::optional<double> readNumber(std::string_view text);
std::optional<long long> readInteger(std::string_view text);

/// Appends `value` with exactly `decimals` decimals, rounded half to even as printf does.
void appendFixed(std::string& out, double value, int decimals);
/// The same, cut toward zero: Unreal's four-decimal formatter prints pi as 3.1415.
void appendTruncated(std::string& out, double value, int decimals);
/// Shortest text that reads back to the same double.
void appendShortest(std::string& out, double value);
std::string fixed(double value, int decimals);

} // namespace usar
