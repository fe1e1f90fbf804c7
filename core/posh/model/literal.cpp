#include "core/posh/model/literal.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/posh/model/utf8.h"

namespace usar::posh {

namespace {

bool isSurrogate(char32_t value, char32_t first) {
    return value >= first && value < first + 0x400;
}

/// Resolves the escapes of one string from left to right.
class Unescaper {
public:
    explicit Unescaper(std::string_view text) : text_(text) {}

    std::string run() {
        out_.reserve(text_.size());
        while (at_ < text_.size()) {
            if (text_[at_] == '\\') {
                escape();
                continue;
            }
            const CodePoint character = codePointAt(text_, at_);
            appendUtf8(out_, character.value);
            at_ += character.length;
        }
        return std::move(out_);
    }

private:
    void escape() {
        constexpr std::string_view letters = "btnfr'\"\\";
        constexpr std::string_view meanings = "\b\t\n\f\r'\"\\";
        const std::size_t letter = letters.find(text_[at_ + 1]);
        if (letter != std::string_view::npos) {
            out_ += meanings[letter];
            at_ += 2;
        } else if (text_[at_ + 1] == 'u') {
            const char32_t first = hexEscape();
            const bool pair = isSurrogate(first, 0xD800) && text_.substr(at_).starts_with("\\u");
            const std::size_t second_at = at_;
            const char32_t second = pair ? hexEscape() : 0;
            if (pair && !isSurrogate(second, 0xDC00))
                at_ = second_at; // A high surrogate without its low surrogate; read the second escape again on its own
            const bool whole = pair && isSurrogate(second, 0xDC00);
            appendUtf8(out_, whole ? 0x10000 + ((first - 0xD800) << 10U) + (second - 0xDC00) : first);
        } else {
            octalEscape();
        }
    }
    char32_t hexEscape() {
        ++at_;
        while (text_[at_] == 'u')
            ++at_;
        unsigned value = 0;
        std::from_chars(text_.data() + at_, text_.data() + at_ + 4, value, 16);
        at_ += 4;
        return value;
    }
    void octalEscape() {
        ++at_;
        const std::size_t most = text_[at_] <= '3' ? 3 : 2;
        char32_t value = 0;
        for (std::size_t digits = 0; digits < most && at_ < text_.size(); ++digits, ++at_) {
            if (text_[at_] < '0' || text_[at_] > '7')
                break;
            value = value * 8 + static_cast<char32_t>(text_[at_] - '0');
        }
        appendUtf8(out_, value);
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::string out_;
};

std::string spelledFloat(double value) {
    std::string text;
    appendShortest(text, value);
    const bool is_whole = text.find_first_of(".en") == std::string::npos; // inf and nan contain an n
    return is_whole ? text + ".0" : text;
}

} // namespace

std::string unescaped(std::string_view between_quotes) {
    const auto isPlain = [](char c) { return c != '\\' && static_cast<unsigned char>(c) < 0x80; };
    const bool is_plain = std::ranges::all_of(between_quotes, isPlain);
    return is_plain ? std::string(between_quotes) : Unescaper(between_quotes).run();
}

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        constexpr std::string_view meanings = "\b\t\n\f\r\"\\";
        constexpr std::string_view letters = "btnfr\"\\";
        const std::size_t letter = meanings.find(c);
        if (letter != std::string_view::npos) {
            result += '\\';
            result += letters[letter];
        } else {
            result += c;
        }
    }
    return result + '"';
}

std::optional<double> floatOf(std::string_view word) {
    const NumberPrefix number = readNumberPrefix(word);
    return number.used == word.size() && std::isfinite(number.value) ? std::optional(number.value) : std::nullopt;
}

std::string spelled(const Value& value) {
    if (const auto* const truth = std::get_if<bool>(&value))
        return *truth ? "true" : "false";
    if (const auto* const whole = std::get_if<std::int64_t>(&value))
        return std::to_string(*whole);
    if (const auto* const number = std::get_if<double>(&value))
        return spelledFloat(*number);
    if (const auto* const text = std::get_if<std::string>(&value))
        return quoted(*text);
    if (const auto* const symbol = std::get_if<Symbol>(&value)) {
        const bool is_bare = symbol->text.find('.') != std::string::npos && symbol->text.find('-') != std::string::npos;
        return is_bare ? symbol->text : '\'' + symbol->text;
    }
    return "nil";
}

} // namespace usar::posh
