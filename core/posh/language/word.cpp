#include "core/posh/language/token.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::posh {

namespace {

constexpr bool isNameStart(char c) {
    return isLetter(c) || c == '_';
}
constexpr bool isNameCharacter(char c) {
    return isNameStart(c) || isDigit(c) || c == '-';
}
constexpr bool isSign(char c) {
    return c == '+' || c == '-';
}

std::size_t digitsAt(std::string_view word, std::size_t at) {
    std::size_t end = at;
    while (end < word.size() && isDigit(word[end]))
        ++end;
    return end - at;
}

/// Returns Integer or Float, or nullopt if the whole word is neither.
std::optional<TokenKind> numberKind(std::string_view word) {
    std::size_t at = !word.empty() && isSign(word[0]) ? 1 : 0;
    const std::size_t whole = digitsAt(word, at);
    at += whole;
    std::size_t decimals = 0;
    const bool has_point = at < word.size() && word[at] == '.';
    if (has_point) {
        decimals = digitsAt(word, at + 1);
        at += 1 + decimals;
    }
    if (whole + decimals == 0)
        return std::nullopt;
    if (at == word.size())
        return has_point ? TokenKind::Float : TokenKind::Integer;
    if (lowerCase(word[at]) != 'e')
        return std::nullopt;
    ++at;
    if (at < word.size() && isSign(word[at]))
        ++at;
    const std::size_t exponent = digitsAt(word, at);
    return exponent > 0 && at + exponent == word.size() ? std::optional(TokenKind::Float) : std::nullopt;
}

/// Checks a word that must consist of names joined by dots. Returns the offset of the first wrong character, or nullopt
/// if there is none. A dot is wrong if no name follows it.
std::optional<std::size_t> wrongInParts(std::string_view word, bool hyphens) {
    bool starts_part = true;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const char c = word[i];
        if (c == '.' && !starts_part) {
            starts_part = true;
            continue;
        }
        if (starts_part ? !isNameStart(c) : !isNameCharacter(c) || (c == '-' && !hyphens))
            return i;
        starts_part = false;
    }
    return starts_part ? std::optional(word.empty() ? 0 : word.size() - 1) : std::nullopt;
}

bool isNameWithDigit(std::string_view word) {
    return !word.empty() && isDigit(word[0]) && std::ranges::all_of(word, isNameCharacter) &&
           std::ranges::any_of(word, isNameStart);
}

std::optional<std::size_t> illegalCharacter(std::string_view word) {
    for (std::size_t i = 0; i < word.size(); ++i)
        if (!isNameCharacter(word[i]) && word[i] != '.' && word[i] != '+')
            return i;
    return std::nullopt;
}

bool looksLikeNumber(std::string_view word) {
    const std::size_t sign = isSign(word[0]) ? 1 : 0;
    const std::size_t point = sign < word.size() && word[sign] == '.' ? sign + 1 : sign;
    return point < word.size() && isDigit(word[point]);
}

} // namespace

WordKind classifyWord(std::string_view word) {
    if (const auto number = numberKind(word))
        return {.kind = *number};
    if (!wrongInParts(word, true))
        return {};
    if (isNameWithDigit(word))
        return {.starts_with_digit = true};
    if (const auto bad = illegalCharacter(word))
        return {TokenKind::Bad, false, Code::IllegalCharacter, *bad};
    return {TokenKind::Bad, false, looksLikeNumber(word) ? Code::MalformedNumber : Code::MalformedName, 0};
}

WordKind classifySymbol(std::string_view word) {
    if (isNameWithDigit(word))
        return {.kind = TokenKind::Symbol, .starts_with_digit = true};
    const bool is_constant = word.find('.') != std::string_view::npos;
    if (const auto wrong = wrongInParts(word, !is_constant))
        return {TokenKind::Bad, false, Code::MalformedSymbol, *wrong};
    return {.kind = TokenKind::Symbol};
}

} // namespace usar::posh
