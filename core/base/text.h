// Small helpers for ASCII text, independent of the locale. They work on views and allocate nothing, except those
// that return a string.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace usar {

/// True for the characters that separate words on a line: blank, tab and line ends.
constexpr bool isSpace(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}
/// ASCII digits and letters only; the locale does not matter.
constexpr bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

constexpr bool isLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
/// Letter, digit or underscore: a character of a word of the protocol.
constexpr bool isWordByte(char c) {
    return isLetter(c) || isDigit(c) || c == '_';
}
/// Changes A-Z only.
constexpr char lowerCase(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Compares ASCII texts ignoring case, because servers and clients of different versions vary in case. Inline because
/// most of the words compared differ in length or first letter.
constexpr bool sameWord(std::string_view a, std::string_view b) {
    if (a.size() != b.size())
        return false;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && lowerCase(a[i]) != lowerCase(b[i]))
            return false;
    return true;
}

/// `text` without the spaces around it.
constexpr std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

/// Removes the first word from `text`, which keeps the rest, and returns it; empty if there is no word left.
constexpr std::string_view takeWord(std::string_view& text) {
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    std::size_t length = 0;
    while (length < text.size() && !isSpace(text[length]))
        ++length;
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(length);
    return word;
}

/// A copy with the letters A-Z in lower case; other bytes stay as they are.
inline std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = lowerCase(c);
    return result;
}

/// A list for a sentence: the words of these things with commas between them.
template <class Things, class Word = std::identity>
std::string listOf(const Things& things, Word word = {}) {
    std::string list;
    for (const auto& thing : things)
        list.append(list.empty() ? "" : ", ").append(std::invoke(word, thing));
    return list;
}

} // namespace usar
