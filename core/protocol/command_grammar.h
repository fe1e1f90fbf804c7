// The words of commands as a table: for help, completion and a check before a line is sent.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"

namespace usar::protocol {

/// What a segment's value must look like. Word means one of the rule's words, in any case.
enum class ValueForm { Text, Number, Numbers, Word };

/// One segment that a command may have. `words` are values to choose from; empty where the value is free. A key in
/// angle brackets ("<joint>") stands for any name.
struct SegmentRule {
    std::string_view key;
    std::string_view help;
    std::span<const std::string_view> words{};
    ValueForm form = ValueForm::Text;
    bool repeats = false; ///< may stand more than once on a line
};

struct CommandRule {
    std::string_view word;
    std::string_view help;
    std::string_view example;
    std::span<const SegmentRule> segments;
};

/// Every command of usarsim-protocol 5, and our server's own.
std::span<const CommandRule> commandRules();

/// Replaces the bytes [from, cursor) of the line.
struct Completion {
    std::string text;
    std::string help;
    std::size_t from = 0;
    bool operator==(const Completion&) const = default;
};

/// What may stand at `cursor` (a byte of the line, at most its end), judged by what is before it: command words, then
/// segments ("{Left"), keys behind an opening brace, words of a key. In the table's order; begun words in any case.
std::vector<Completion> completionsAt(std::string_view line, std::size_t cursor);

/// What a server would not understand: an unknown word or key is a warning with the nearest spelling, a missing brace
/// or a number that is none an error. No line is too odd to be sent, though: the caller decides. Nothing for an empty
/// line.
Diagnostics checkCommand(std::string_view line);

} // namespace usar::protocol
