// UTF-8 from untrusted bytes, one code point at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace usar::posh {

/// A code point and its length in bytes. A byte that does not begin a well-formed sequence gives U+FFFD with length 1
/// and `valid` false.
struct CodePoint {
    char32_t value = 0xFFFD;
    std::size_t length = 1;
    bool valid = false;
};

/// Decodes the code point at a byte offset, which must be less than the size of the text.
CodePoint codePointAt(std::string_view text, std::size_t at);

/// Appends a code point as UTF-8. Surrogates and values beyond U+10FFFF are written as U+FFFD.
void appendUtf8(std::string& out, char32_t value);

/// Returns true for white space that only looks like a blank: U+00A0, U+2007, U+202F, U+3000, U+FEFF.
bool isOddSpace(char32_t value);

} // namespace usar::posh
