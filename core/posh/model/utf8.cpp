#include "core/posh/model/utf8.h"

namespace usar::posh {

namespace {

/// Returns the length of a sequence from its first byte, or 0 if no sequence can begin with that byte.
std::size_t announcedLength(unsigned char first) {
    if (first < 0x80)
        return 1;
    if (first < 0xC2)
        return 0;
    if (first < 0xE0)
        return 2;
    if (first < 0xF0)
        return 3;
    return first < 0xF5 ? 4 : 0;
}

/// Returns false for overlong forms, surrogates and values beyond the last code point.
bool isCharacter(char32_t value, std::size_t length) {
    if (length == 3)
        return value >= 0x800 && !(value >= 0xD800 && value <= 0xDFFF);
    return length != 4 || (value >= 0x10000 && value <= 0x10FFFF);
}

} // namespace

CodePoint codePointAt(std::string_view text, std::size_t at) {
    const auto first = static_cast<unsigned char>(text[at]);
    const std::size_t length = announcedLength(first);
    if (length == 1)
        return {first, 1, true};
    if (length == 0 || text.size() - at < length)
        return {};
    char32_t value = first & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const auto next = static_cast<unsigned char>(text[at + i]);
        if ((next & 0xC0U) != 0x80U)
            return {};
        value = (value << 6U) | (next & 0x3FU);
    }
    return isCharacter(value, length) ? CodePoint{value, length, true} : CodePoint{};
}

void appendUtf8(std::string& out, char32_t value) {
    if ((value >= 0xD800 && value <= 0xDFFF) || value > 0x10FFFF)
        value = 0xFFFD;
    const auto byte = [&out](char32_t bits) { out += static_cast<char>(static_cast<unsigned char>(bits)); };
    if (value < 0x80)
        return byte(value);
    const unsigned following = value < 0x800 ? 1 : value < 0x10000 ? 2 : 3;
    byte(0xFF00U >> (following + 1) | value >> 6U * following); // As many ones at the front as there are bytes
    for (unsigned i = following; i-- > 0;)
        byte(0x80U | (value >> 6U * i & 0x3FU));
}

bool isOddSpace(char32_t value) {
    return value == 0xA0 || value == 0x2007 || value == 0x202F || value == 0x3000 || value == 0xFEFF;
}

} // namespace usar::posh
