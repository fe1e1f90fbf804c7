#include "core/posh/model/dialect_names.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/text.h"

namespace usar::posh {

namespace {

/// Replaces everything except letters, digits and underscores by hyphens.
std::string asSymbol(std::string_view text) {
    std::string word(text);
    std::replace_if(
        word.begin(), word.end(), [](char c) { return !isLetter(c) && !isDigit(c) && c != '_'; }, '-');
    return word.empty() || !(isLetter(word.front()) || word.front() == '_') ? '_' + word : word;
}

} // namespace

std::string yaposhName(std::string_view name) {
    std::string words(name);
    return !words.empty() && isDigit(words.front()) ? '_' + words : words;
}

std::string classicName(std::string_view name) {
    std::string words = yaposhName(name);
    std::replace(words.begin(), words.end(), '.', '_');
    return words;
}

Value yaposhValue(const Value& value) {
    const auto* const symbol = std::get_if<Symbol>(&value);
    if (!symbol || symbol->text.find('.') == std::string::npos)
        return value;
    std::string text = symbol->text;
    std::replace(text.begin(), text.end(), '-', '_');
    return Symbol{std::move(text)};
}

Value classicValue(const Value& value) {
    if (const auto* const truth = std::get_if<bool>(&value))
        return std::int64_t{*truth ? 1 : 0};
    if (const auto* const text = std::get_if<std::string>(&value))
        return Symbol{asSymbol(*text)};
    if (const auto* const symbol = std::get_if<Symbol>(&value))
        return Symbol{yaposhName(symbol->text.substr(symbol->text.rfind('.') + 1))};
    return value;
}

std::string classicText(std::string_view text) {
    std::string plain(text);
    for (char& c : plain) {
        if (c == '"')
            c = '\'';
        else if (c == ';' || c == '#')
            c = ',';
        else if (c == '\\')
            c = '/';
        else if (static_cast<unsigned char>(c) < ' ')
            c = ' ';
    }
    return plain;
}

} // namespace usar::posh
