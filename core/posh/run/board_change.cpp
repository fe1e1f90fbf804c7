#include "core/posh/run/board_change.h"

namespace usar::posh {

namespace {

constexpr std::string_view key_end = ": ";
constexpr std::string_view arrow = " -> ";

/// Returns the offset just after the value at the start of `text`, or npos. A quoted value may contain the arrow
/// itself.
std::size_t endOfValue(std::string_view text) {
    if (!text.starts_with('"'))
        return text.find(arrow);
    for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == '"')
            return i + 1;
    }
    return std::string_view::npos;
}

} // namespace

std::string boardChangeText(std::string_view key, std::string_view old_value, std::string_view new_value) {
    std::string text(key);
    text.append(key_end).append(old_value).append(arrow).append(new_value);
    return text;
}

std::optional<BoardChange> readBoardChange(std::string_view text) {
    const std::size_t key_size = text.find(key_end);
    if (key_size == std::string_view::npos || key_size == 0)
        return std::nullopt;
    const std::string_view values = text.substr(key_size + key_end.size());
    const std::size_t old_size = endOfValue(values);
    if (old_size == std::string_view::npos || !values.substr(old_size).starts_with(arrow))
        return std::nullopt;
    return BoardChange{text.substr(0, key_size), values.substr(0, old_size), values.substr(old_size + arrow.size())};
}

} // namespace usar::posh
