#include "core/posh/run/value_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace usar::posh {

namespace {

/// Appends a number with at most three decimals, such as 0.5 or 2.25. For these, no search for the shortest digits is
/// needed. Returns false and appends nothing for all other numbers.
bool appendThousandths(std::string& out, double number) {
    constexpr double most = 1e12;
    const double scaled = number * 1000.0;
    if (!(std::abs(scaled) < most) || number == 0.0)
        return false;
    const auto thousandths = static_cast<std::int64_t>(scaled);
    if (static_cast<double>(thousandths) / 1000.0 != number)
        return false;
    const std::int64_t size = std::abs(thousandths);
    if (number < 0.0)
        out += '-';
    std::array<char, 24> digits{};
    const auto [end, unused] = std::to_chars(digits.data(), digits.data() + digits.size(), size / 1000);
    out.append(digits.data(), end);
    const auto part = static_cast<int>(size % 1000);
    out += '.';
    out += static_cast<char>('0' + part / 100);
    if (part % 100 != 0)
        out += static_cast<char>('0' + part / 10 % 10);
    if (part % 10 != 0)
        out += static_cast<char>('0' + part % 10);
    return true;
}

/// Appends the shortest digits that give the number; with an exponent only if it is very small or very large.
void appendReal(std::string& out, double number) {
    if (appendThousandths(out, number))
        return;
    const double size = std::abs(number);
    const bool plain = size == 0.0 || (size >= 1e-4 && size < 1e16);
    std::array<char, 32> digits{};
    const auto [end, unused] = std::to_chars(digits.data(), digits.data() + digits.size(), number,
                                             plain ? std::chars_format::fixed : std::chars_format::scientific);
    const std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    out += text;
    if (plain && text.find('.') == std::string_view::npos)
        out += ".0";
}

/// Appends the text in quotes, escaped as in JSON; characters beyond ASCII are not escaped.
void appendQuoted(std::string& out, std::string_view text) {
    constexpr std::string_view plain = "\"\\\b\f\n\r\t";
    constexpr std::string_view letters = "\"\\bfnrt";
    constexpr std::string_view digits = "0123456789abcdef";
    out += '"';
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (const std::size_t at = plain.find(c); at != std::string_view::npos)
            (out += '\\') += letters[at];
        else if (byte < 0x20)
            ((out += "\\u00") += digits[byte >> 4]) += digits[byte & 15];
        else
            out += c;
    }
    out += '"';
}

struct Append {
    std::string& out;
    void operator()(std::monostate) const { out += "nil"; }
    void operator()(bool flag) const { out += flag ? "true" : "false"; }
    void operator()(std::int64_t whole) const { out += std::to_string(whole); }
    void operator()(double number) const { appendReal(out, number); }
    void operator()(const std::string& text) const { appendQuoted(out, text); }
    void operator()(const Symbol& symbol) const { out.append(1, '\'') += symbol.text; }
};

constexpr std::string_view key_end = ": ";
constexpr std::string_view arrow = " -> ";

/// Returns the offset just after the value at the start of `text`, or npos. A quoted value may contain the arrow
/// itself.
std::size_t endOfValue(std::string_view text) {
    if (!text.starts_with('"'))
        return text.find(arrow);
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            return i + 1;
    }
    return std::string_view::npos;
}

} // namespace

void appendValue(std::string& out, const Value& value) {
    std::visit(Append{out}, value);
}

std::string toText(const Value& value) {
    std::string text;
    appendValue(text, value);
    return text;
}

std::string boardChangeText(std::string_view key, std::string_view old_value, std::string_view new_value) {
    std::string text(key);
    text.append(key_end).append(old_value).append(arrow).append(new_value);
    return text;
}

std::optional<BoardChange> readBoardChange(std::string_view text) {
    const std::size_t key_size = text.find(key_end);
    if (key_size == std::string_view::npos || key_size == 0)
        return std::nullopt;
    const std::string_view values = text.substr(key_size + key_end.size());
    const std::size_t old_size = endOfValue(values);
    if (old_size == std::string_view::npos || !values.substr(old_size).starts_with(arrow))
        return std::nullopt;
    return BoardChange{text.substr(0, key_size), values.substr(0, old_size), values.substr(old_size + arrow.size())};
}

} // namespace usar::posh
