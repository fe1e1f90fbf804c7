#include "core/sim/servers/server_ini.h"

#include <algorithm>

#include "core/base/text.h"

namespace usar::sim {

namespace {

/// Removes the text up to the next comma that stands in no quotes and in no parentheses, and returns it.
std::string_view takeField(std::string_view& rest) {
    int depth = 0;
    bool quoted = false;
    std::size_t at = 0;
    for (; at < rest.size(); ++at) {
        const char c = rest[at];
        if (c == '"')
            quoted = !quoted;
        else if (!quoted && c == '(')
            ++depth;
        else if (!quoted && c == ')')
            --depth;
        else if (!quoted && depth == 0 && c == ',')
            break;
    }
    const std::string_view field = rest.substr(0, at);
    rest.remove_prefix(std::min(at + 1, rest.size()));
    return trimmed(field);
}

std::string_view withoutQuotes(std::string_view value) {
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
        return value.substr(1, value.size() - 2);
    return value;
}

} // namespace

std::vector<IniSection> sectionsOf(std::string_view text) {
    std::vector<IniSection> sections(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        const bool pair = end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n';
        text.remove_prefix(std::min(end + (pair ? 2 : 1), text.size()));
        const std::string_view bare = trimmed(line);
        if (bare.size() > 2 && bare.front() == '[' && bare.back() == ']')
            sections.push_back({std::string(bare.substr(1, bare.size() - 2)), {}});
        else
            sections.back().lines.emplace_back(line);
    }
    return sections;
}

std::string textOf(const std::vector<IniSection>& sections, std::string_view line_end) {
    std::string text;
    for (const IniSection& section : sections) {
        if (!section.name.empty())
            text.append("[").append(section.name).append("]").append(line_end);
        for (const std::string& line : section.lines)
            text.append(line).append(line_end);
    }
    return text;
}

IniSection* findSection(std::vector<IniSection>& sections, std::string_view name) {
    const auto found =
        std::ranges::find_if(sections, [name](const IniSection& section) { return sameWord(section.name, name); });
    return found == sections.end() ? nullptr : &*found;
}

std::pair<std::string_view, std::string_view> entryOf(std::string_view line) {
    line = trimmed(line);
    const std::size_t equals = line.find('=');
    if (line.empty() || line.front() == ';' || equals == std::string_view::npos)
        return {};
    std::string_view key = trimmed(line.substr(0, equals));
    if (key.starts_with('+'))
        key.remove_prefix(1);
    return {key.substr(0, key.find('[')), trimmed(line.substr(equals + 1))};
}

IniFields fieldsOf(std::string_view value) {
    value = trimmed(value);
    if (value.size() < 2 || value.front() != '(' || value.back() != ')')
        return {};
    value = value.substr(1, value.size() - 2);
    IniFields fields;
    while (!value.empty()) {
        const std::string_view field = takeField(value);
        const std::size_t equals = field.find('=');
        if (equals != std::string_view::npos)
            fields.emplace_back(trimmed(field.substr(0, equals)), withoutQuotes(trimmed(field.substr(equals + 1))));
    }
    return fields;
}

std::string_view fieldIn(const IniFields& fields, std::string_view name) {
    for (const auto& [key, value] : fields)
        if (sameWord(key, name))
            return value;
    return {};
}

std::string_view classIn(std::string_view value) {
    const std::size_t first = value.find('\'');
    const std::size_t last = value.rfind('\'');
    return first == last ? value : value.substr(first + 1, last - first - 1);
}

} // namespace usar::sim
