#include "core/base/numbers.h"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/plain_decimal.h"
#include "core/base/text.h"

namespace usar {

namespace {

/// Length of a Windows "not a number" at the start of `text`, 0 if there is none. The Windows run-time library writes
/// 1.#IND, -1.#QNAN and 1.#INF; digits may follow.
std::size_t windowsNotANumber(std::string_view text) {
    const std::size_t start = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
    if (text.substr(start, 3) != "1.#")
        return 0;
    std::size_t end = start + 3;
    while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])))
        ++end;
    return end;
}

/// Appends `places`, a whole number counted in units of the last decimal place, with the decimal point inserted. The
/// sign of a zero is kept, as printf keeps it. `decimals` > 0.
void appendWhole(std::string& out, double places, std::size_t decimals) {
    std::array<char, 40> buffer;
    char* const end = buffer.data() + buffer.size();
    char* at = end;
    auto left = static_cast<std::uint64_t>(std::abs(places));
    for (std::size_t digits = 0; left > 0 || digits <= decimals; ++digits, left /= 10) {
        if (digits == decimals)
            *--at = '.';
        *--at = static_cast<char>('0' + left % 10);
    }
    if (std::signbit(places))
        *--at = '-';
    out.append(at, end);
}

} // namespace

NumberPrefix readNumberPrefix(std::string_view text) {
    const char* at = text.data();
    if (double plain = 0.0; readPlainDecimal(at, text.data() + text.size(), plain))
        return {plain, static_cast<std::size_t>(at - text.data())};
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    if (const std::size_t used = windowsNotANumber(text))
        return {not_a_number, used};
    const bool plus = text.starts_with('+'); // from_chars does not accept a plus sign
    const std::string_view digits = plus ? text.substr(1) : text;
    if (plus && digits.starts_with('-'))
        return {};
    double value = 0.0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const auto used = static_cast<std::size_t>(end - digits.data());
    if (problem == std::errc::invalid_argument)
        return {};
    if (problem == std::errc::result_out_of_range || !std::isfinite(value))
        value = not_a_number;
    return {value, used + (plus ? 1 : 0)};
}

std::optional<double> readNumber(std::string_view text) {
    text = trimmed(text);
    const NumberPrefix number = readNumberPrefix(text);
    if (number.used == 0 || number.used != text.size())
        return std::nullopt;
    return number.value;
}

std::optional<long long> readInteger(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    long long value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

void appendFixed(std::string& out, double value, int decimals) {
    std::array<char, 400> buffer; // 1.8e308 has 309 digits before the point
    const auto [end, problem] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    if (problem == std::errc{})
        out.append(buffer.data(), end);
}

void appendTruncated(std::string& out, double value, int decimals) {
    double scale = 1.0;
    for (int i = 0; i < decimals; ++i)
        scale *= 10.0;
    // A value that was read with this many decimals must be written with the same digits, although its product with the
    // scale may fall short of the whole number by a few units in the last place.
    constexpr double few_last_places = 4 * std::numeric_limits<double>::epsilon();
    const double cut = std::trunc(value * scale * (1.0 + few_last_places));
    constexpr double largest_whole = 9007199254740992.0; // 2^53: from here on doubles have no fraction to cut
    if (!(std::abs(cut) < largest_whole))
        appendFixed(out, value, decimals);
    else if (decimals > 0)
        appendWhole(out, cut, static_cast<std::size_t>(decimals));
    else
        appendFixed(out, cut, 0);
}

void appendShortest(std::string& out, double value) {
    std::array<char, 32> buffer;
    const auto [end, problem] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    if (problem == std::errc{})
        out.append(buffer.data(), end);
}

std::string fixed(double value, int decimals) {
    std::string text;
    appendFixed(text, value, decimals);
    return text;
}

std::string shortest(double value) {
    std::string text;
    appendShortest(text, value);
    return text;
}

} // namespace usar
