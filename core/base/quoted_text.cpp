#include "core/base/quoted_text.h"

#include "core/base/text.h"

namespace usar {

namespace {

int hexDigit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    const char lower = lowerCase(c);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Decodes the escape sequence after a backslash, appends its byte and removes the sequence from `rest`. False if the
/// sequence is invalid.
bool takeEscaped(std::string_view& rest, std::string& bytes) {
    constexpr std::string_view letters = "nrt\\\"";
    constexpr std::string_view meanings = "\n\r\t\\\"";
    if (rest.empty())
        return false;
    if (const auto letter = letters.find(rest.front()); letter != std::string_view::npos) {
        bytes += meanings[letter];
        rest.remove_prefix(1);
        return true;
    }
    if (rest.size() < 3 || rest.front() != 'x' || hexDigit(rest[1]) < 0 || hexDigit(rest[2]) < 0)
        return false;
    bytes += static_cast<char>(hexDigit(rest[1]) * 16 + hexDigit(rest[2]));
    rest.remove_prefix(3);
    return true;
}

} // namespace

void appendQuoted(std::string& text, std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    text += '"';
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n')
            text += "\\n";
        else if (c == '\r')
            text += "\\r";
        else if (c == '\t')
            text += "\\t";
        else if (c == '\\' || c == '"')
            (text += '\\') += c;
        else if (byte >= 0x20 && byte < 0x7F)
            text += c;
        else
            ((text += "\\x") += digits[byte >> 4]) += digits[byte & 15];
    }
    text += '"';
}

bool takeQuoted(std::string_view& rest, std::string& bytes) {
    bytes.clear();
    while (!rest.empty() && rest.front() == ' ')
        rest.remove_prefix(1);
    if (rest.empty() || rest.front() != '"')
        return false;
    rest.remove_prefix(1);
    while (!rest.empty() && rest.front() != '"') {
        const char c = rest.front();
        rest.remove_prefix(1);
        if (c != '\\')
            bytes += c;
        else if (!takeEscaped(rest, bytes))
            return false;
    }
    if (rest.empty())
        return false;
    rest.remove_prefix(1);
    return true;
}

} // namespace usar
