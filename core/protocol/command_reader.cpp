#include "core/protocol/command_reader.h"

#include <algorithm>

#include "core/protocol/commands/command_kinds.h"

namespace usar::protocol {

namespace {

bool hasCommandWord(const Segments& line, const CommandWord& word) {
    return sameWord(word.word, line.typeWord()) ||
           (!word.other_word.empty() && sameWord(word.other_word, line.typeWord()));
}

} // namespace

Command readCommand(std::string_view line, Diagnostics& diagnostics, Dialect dialect) {
    Segments segments;
    segments.read(line, diagnostics);
    LineIn in(segments, diagnostics, dialect);
    const auto is_on = [&](std::string_view sign) {
        return sign.empty() ? segments.all().empty() : segments.find(sign) != nullptr;
    };
    const auto has_mark = [&](const SegmentRule& mark) {
        return std::ranges::any_of(
            mark.words, [value = segments.value(mark.key)](std::string_view word) { return sameWord(word, value); });
    };
    bool word_is_known = false;
    const CommandKind* best = nullptr;
    for (const CommandKind& kind : commandKinds()) {
        if (!hasCommandWord(segments, kind.word))
            continue;
        word_is_known = true;
        if (!std::ranges::all_of(kind.marks, has_mark))
            continue;
        const bool needs_no_sign = kind.signs.empty() && kind.weak_signs.empty();
        if (needs_no_sign || std::ranges::any_of(kind.signs, is_on)) {
            best = &kind;
            break;
        }
        if (!best && std::ranges::any_of(kind.weak_signs, is_on))
            best = &kind;
    }
    if (best) {
        Command command = best->read(in);
        if (!in.refused())
            return command;
    } else if (word_is_known) {
        diagnostics.push_back(
            {Severity::Warning, 0, std::string(segments.typeWord()) + " has no form with these segments"});
    }
    return RawCommand{std::string(line)};
}

} // namespace usar::protocol
