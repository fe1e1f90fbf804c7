#include "core/posh/value_text.h"

#include <cmath>

#include "core/base/numbers.h"

namespace usar::posh {

namespace {

struct Append {
    std::string& out;
    void operator()(std::monostate) const { out += "nil"; }
    void operator()(bool flag) const { out += flag ? "true" : "false"; }
    void operator()(std::int64_t whole) const { out += std::to_string(whole); }
    void operator()(double number) const {
        const std::size_t begin = out.size();
        appendShortest(out, number);
        if (std::isfinite(number) && out.find_first_of(".e", begin) == std::string::npos)
            out += ".0";
    }
    void operator()(const std::string& text) const { appendQuoted(out, text); }
    void operator()(const Symbol& symbol) const { out.append(1, '\'') += symbol.text; }
};

void appendEscaped(std::string& out, char c) {
    constexpr std::string_view plain = "\"\\\b\f\n\r\t";
    constexpr std::string_view letters = "\"\\bfnrt";
    if (const std::size_t at = plain.find(c); at != std::string_view::npos) {
        out += '\\';
        out += letters[at];
    } else if (const auto byte = static_cast<unsigned char>(c); byte < 0x20) {
        constexpr std::string_view digits = "0123456789abcdef";
        out += "\\u00";
        out += digits[byte >> 4];
        out += digits[byte & 15];
    } else {
        out += c;
    }
}

} // namespace

void appendQuoted(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text)
        appendEscaped(out, c);
    out += '"';
}

void appendValue(std::string& out, const Value& value) {
    std::visit(Append{out}, value);
}

std::string toText(const Value& value) {
    std::string text;
    appendValue(text, value);
    return text;
}

} // namespace usar::posh
