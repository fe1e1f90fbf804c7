// The grammar of commands, for help, completion and a check before a line is sent.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"

namespace usar::protocol {

/// The form that a segment's value must have. Word means one of the rule's words, in upper or lower case.
enum class ValueForm { FreeText, Number, Numbers, Word };

/// One segment that a command may have. `words` are the values to choose from; unless the form is Word, others are
/// allowed, too. `help` is a phrase for the operator. A key in angle brackets ("<joint>") stands for any name.
struct SegmentRule {
    std::string_view key;
    std::string help;
    std::vector<std::string_view> words{};
    ValueForm form = ValueForm::FreeText;
    bool repeats = false; ///< may stand more than once on a line
};

/// All commands with one first word: a phrase of help, a complete line as an example, and the segments that they may
/// have. All views are to static text.
struct CommandRule {
    std::string_view word;
    std::string_view help;
    std::string_view example;
    std::vector<SegmentRule> segments;
};

/// Every command of protocol.md 5 and the additional ones of our own server, in the order of CommandVariant and derived
/// from it. Made at the first call; any thread may call it.
std::span<const CommandRule> commandRules();

/// A suggestion; `text` is to replace the bytes [from, cursor) of the line.
struct Completion {
    std::string text;
    std::string help;
    std::size_t from = 0;
    bool operator==(const Completion&) const = default;
};

/// Lists what may stand at `cursor` (a byte offset into the line, limited to its end), judging mainly by the text
/// before it: command words, then segments ("{Left"), keys after an opening brace, and the words of a key. The
/// suggestions are in the table's order; the part already typed may be in any case. Empty if the command is unknown.
std::vector<Completion> completionsAt(std::string_view line, std::size_t cursor);

/// Lists what a server would not understand, in the order of the line: an unknown word or key gives a warning with the
/// nearest spelling, a missing brace or an invalid number an error. Any line can be sent nevertheless; the caller
/// decides. Empty for an empty line.
Diagnostics checkCommand(std::string_view line);

} // namespace usar::protocol
