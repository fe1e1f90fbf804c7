#include "core/protocol/commands/checked_text.h"

#include <algorithm>
#include <iterator>

#include "core/base/text.h"

namespace usar::protocol {

namespace {

bool fits(TextRule rule, char c) {
    return c != '{' && c != '}' && c != '\x7f' && static_cast<unsigned char>(c) >= ' ' &&
           (c != ' ' || rule == TextRule::Text);
}

} // namespace

bool fits(TextRule rule, std::string_view text) {
    return (rule != TextRule::Token || !text.empty()) && trimmed(text).size() == text.size() &&
           std::ranges::all_of(text, [rule](char c) { return fits(rule, c); });
}

std::string fitted(TextRule rule, std::string_view text) {
    std::string left;
    std::ranges::copy_if(text, std::back_inserter(left), [rule](char c) { return fits(rule, c); });
    return std::string(trimmed(left));
}

Error misfit(TextRule rule, std::string_view text) {
    if (text.empty())
        return {"a name must not be empty", "command", "Give it a name of one word"};
    if (rule == TextRule::Text)
        return {"a text cannot hold braces, line ends or spaces around it", "'" + std::string(text) + "'",
                "Leave them out"};
    return {"a name cannot hold spaces, braces or line ends", "'" + std::string(text) + "'",
            "Choose a name of one word"};
}

} // namespace usar::protocol
