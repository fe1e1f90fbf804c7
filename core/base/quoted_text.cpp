#include "core/base/quoted_text.h"

#include <charconv>

namespace usar {

namespace {

/// The bytes that are written as a backslash and a letter.
constexpr std::string_view letters = "nrt\\\"";
constexpr std::string_view meanings = "\n\r\t\\\"";

/// Decodes the escape sequence after a backslash, appends its byte and removes the sequence from `rest`. False if the
/// sequence is invalid.
bool takeEscaped(std::string_view& rest, std::string& bytes) {
    if (rest.empty())
        return false;
    if (const auto letter = letters.find(rest.front()); letter != std::string_view::npos) {
        bytes += meanings[letter];
        rest.remove_prefix(1);
        return true;
    }
    unsigned char byte = 0;
    if (rest.size() < 3 || rest.front() != 'x' || std::from_chars(&rest[1], &rest[1] + 2, byte, 16).ptr != &rest[1] + 2)
        return false;
    bytes += static_cast<char>(byte);
    rest.remove_prefix(3);
    return true;
}

} // namespace

void appendQuoted(std::string& text, std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    text += '"';
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7F && c != '\\' && c != '"')
            text += c;
        else if (const auto letter = meanings.find(c); letter != std::string_view::npos)
            (text += '\\') += letters[letter];
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
