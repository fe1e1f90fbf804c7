// One code point at a time from untrusted bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace usar::posh {

/// `valid` is false for a byte that begins no well-formed sequence; it stands for U+FFFD and is one byte long.
struct CodePoint {
    char32_t value = 0xFFFD;
    std::size_t length = 1;
    bool valid = false;
};

/// `at` must lie inside the text.
CodePoint codePointAt(std::string_view text, std::size_t at);

/// Surrogates and what lies beyond U+10FFFF are written as U+FFFD.
void appendUtf8(std::string& out, char32_t value);

/// White space that only looks like a blank: U+00A0, U+2007, U+202F, U+3000, U+FEFF.
bool isOddSpace(char32_t value);

} // namespace usar::posh
