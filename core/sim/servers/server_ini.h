// The configuration files of Unreal as text: sections of lines, and the values in parentheses that are lists of fields.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace usar::sim {

/// The lines under one [name], without their ends; the lines before the first section have an empty name.
struct IniSection {
    std::string name;
    std::vector<std::string> lines;
};

/// Splits a file into its sections in their order. Line ends of any kind count.
std::vector<IniSection> sectionsOf(std::string_view text);
/// Joins sections to a file with this line end.
std::string textOf(const std::vector<IniSection>& sections, std::string_view line_end);

/// Finds a section by its name in any case; nullptr if there is none.
IniSection* findSection(std::vector<IniSection>& sections, std::string_view name);

/// "Sensors" and "(ItemClass=…)" for the line of such an entry, in which a leading + and an index in brackets do not
/// count; both are empty for a comment or a blank line.
std::pair<std::string_view, std::string_view> entryOf(std::string_view line);

using IniFields = std::vector<std::pair<std::string, std::string>>;

/// Splits "(X=1,Direction=(Y=2,Z=3),ItemName=\"F1\")" into its fields; quotes around a value are removed.
IniFields fieldsOf(std::string_view value);
/// The value of a field by its name in any case; empty if there is none.
std::string_view fieldIn(const IniFields& fields, std::string_view name);

/// "USARBot.SonarSensor" for "class'USARBot.SonarSensor'".
std::string_view classIn(std::string_view value);

} // namespace usar::sim
