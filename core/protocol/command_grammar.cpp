#include "core/protocol/command_grammar.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/protocol/commands/command_kinds.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

namespace {

bool isNumeric(ValueForm form) {
    return form == ValueForm::Number || form == ValueForm::Numbers;
}

/// Adds what one command says about a segment to what others with the same word say about it.
void merge(std::vector<SegmentRule>& rules, const SegmentRule& added) {
    const auto rule = std::ranges::find(rules, added.key, &SegmentRule::key);
    if (rule == rules.end()) {
        rules.push_back(added);
        return;
    }
    if (rule->help.find(added.help) == std::string::npos)
        rule->help += "; " + added.help;
    for (const std::string_view word : added.words)
        if (std::ranges::find(rule->words, word) == rule->words.end())
            rule->words.push_back(word);
    if (rule->form != added.form)
        rule->form = isNumeric(rule->form) && isNumeric(added.form) ? ValueForm::Numbers : ValueForm::FreeText;
    rule->repeats |= added.repeats;
}

std::vector<CommandRule> rulesOf(std::span<const CommandKind> kinds) {
    std::vector<CommandRule> rules;
    for (const CommandKind& kind : kinds) {
        auto rule = std::ranges::find(rules, kind.word.word, &CommandRule::word);
        if (rule == rules.end())
            rule = rules.insert(rule, {kind.word.word, kind.word.help, kind.word.example, {}});
        for (const SegmentRule& segment : kind.segments)
            merge(rule->segments, segment);
    }
    return rules;
}

bool standsForAnyName(const SegmentRule& rule) {
    return rule.key.starts_with('<');
}

const CommandRule* ruleOf(std::string_view word) {
    const auto rules = commandRules();
    const auto found =
        std::ranges::find_if(rules, [word](const CommandRule& rule) { return sameWord(rule.word, word); });
    return found == rules.end() ? nullptr : &*found;
}

const SegmentRule* ruleOf(const CommandRule& command, std::string_view key) {
    const auto found = std::ranges::find_if(
        command.segments, [key](const SegmentRule& rule) { return standsForAnyName(rule) || sameWord(rule.key, key); });
    return found == command.segments.end() ? nullptr : &*found;
}

bool beginsWith(std::string_view word, std::string_view begun) {
    return begun.size() <= word.size() && sameWord(word.substr(0, begun.size()), begun);
}

std::string_view typeWordOf(std::string_view line) {
    return trimmed(line.substr(0, line.find('{')));
}

bool isOnLine(std::string_view line, std::string_view key) {
    for (std::size_t open = line.find('{'); open != std::string_view::npos; open = line.find('{', open + 1)) {
        std::string_view text = line.substr(open + 1, line.find_first_of("{}", open + 1) - open - 1);
        if (sameWord(takeWord(text), key))
            return true;
    }
    return false;
}

/// Keys that begin with `begun`, except those that `line` has already used up. Each suggestion begins with `before`
/// ("{" or nothing).
std::vector<Completion> keys(const CommandRule& command, std::string_view line, std::string_view before,
                             std::string_view begun, std::size_t from) {
    std::vector<Completion> found;
    for (const SegmentRule& rule : command.segments) {
        if (!standsForAnyName(rule) && beginsWith(rule.key, begun) && (rule.repeats || !isOnLine(line, rule.key)))
            found.push_back({std::string(before) + std::string(rule.key), rule.help, from});
    }
    return found;
}

std::vector<Completion> commandWords(std::string_view begun, std::size_t from) {
    std::vector<Completion> found;
    for (const CommandRule& rule : commandRules()) {
        if (beginsWith(rule.word, begun))
            found.push_back({std::string(rule.word), std::string(rule.help), from});
    }
    return found;
}

std::vector<Completion> words(const SegmentRule& rule, std::string_view begun, std::size_t from) {
    std::vector<Completion> found;
    for (const std::string_view word : rule.words) {
        if (beginsWith(word, begun))
            found.push_back({std::string(word), rule.help, from});
    }
    return found;
}

std::vector<Completion> insideSegment(const CommandRule& command, std::string_view line, std::size_t open,
                                      std::size_t cursor) {
    std::string_view rest = line.substr(open + 1, cursor - open - 1);
    const std::string_view key = takeWord(rest);
    if (rest.empty()) {
        // The segment at the cursor is left out, so that its own key does not count as used up.
        const std::string others = std::string(line.substr(0, open)) + std::string(line.substr(cursor));
        return keys(command, others, "", key, cursor - key.size());
    }
    while (!rest.empty() && isSpace(rest.front()))
        rest.remove_prefix(1);
    const SegmentRule* const rule = ruleOf(command, key);
    return rule ? words(*rule, rest, cursor - rest.size()) : std::vector<Completion>();
}

std::string meant(std::string_view word, const std::vector<std::string>& known) {
    const std::string nearest = nearestWord(word, known);
    return nearest.empty() ? std::string() : ". Did you mean " + nearest + "?";
}

std::string nearestCommand(std::string_view word) {
    std::vector<std::string> known;
    std::string upper(word);
    for (char& c : upper)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    for (const CommandRule& rule : commandRules())
        known.emplace_back(rule.word);
    return meant(upper, known);
}

std::string nearestKey(const CommandRule& command, std::string_view key) {
    std::vector<std::string> known;
    for (const SegmentRule& rule : command.segments)
        known.emplace_back(rule.key);
    return meant(key, known);
}

/// Adds an error for each brace that does not pair up: braces must alternate, as segments do not nest.
void checkBraces(std::string_view line, Diagnostics& found) {
    std::size_t open = std::string_view::npos;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '{') {
            if (open != std::string_view::npos)
                found.push_back({Severity::Error, i, "the closing brace of the segment before is missing"});
            open = i;
        } else if (line[i] == '}') {
            if (open == std::string_view::npos)
                found.push_back({Severity::Error, i, "the opening brace is missing"});
            open = std::string_view::npos;
        }
    }
    if (open != std::string_view::npos)
        found.push_back({Severity::Error, open, "the closing brace is missing"});
}

struct SegmentCheck {
    const CommandRule& command;
    std::string_view line;
    Diagnostics& found;

    void check(const Segment& segment) const {
        const SegmentRule* const rule = ruleOf(command, segment.key);
        if (!rule && !readNumber(segment.key)) // Player's camera zoom is a number without a key
            warn(segment.key, "the server does not know " + std::string(segment.key) + " in " +
                                  std::string(command.word) + nearestKey(command, segment.key));
        else if (rule && rule->form == ValueForm::Number)
            checkNumber(*rule, segment.value.empty() ? segment.key : segment.value, segment.value);
        else if (rule && rule->form == ValueForm::Numbers)
            checkNumbers(*rule, segment);
        else if (rule && rule->form == ValueForm::Word && !segment.value.empty())
            checkWord(*rule, segment.value);
    }

    void add(Severity severity, std::string_view part, std::string message) const {
        found.push_back({severity, static_cast<std::size_t>(part.data() - line.data()), std::move(message)});
    }
    void warn(std::string_view part, std::string message) const { add(Severity::Warning, part, std::move(message)); }

    void checkNumber(const SegmentRule& rule, std::string_view place, std::string_view text) const {
        const NumberPrefix prefix = readNumberPrefix(text);
        if (prefix.used == 0)
            add(Severity::Error, place, std::string(rule.key) + " needs a number");
        else if (prefix.used < text.size())
            warn(place.substr(prefix.used), "a server reads " + std::string(text.substr(0, prefix.used)) +
                                                " and leaves out '" + std::string(text.substr(prefix.used)) + "'");
    }

    void checkNumbers(const SegmentRule& rule, const Segment& segment) const {
        std::string_view rest = segment.value;
        if (rest.empty())
            add(Severity::Error, segment.key, std::string(rule.key) + " needs numbers");
        while (!rest.empty()) {
            const std::string_view part = trimmed(rest.substr(0, rest.find(',')));
            std::string_view left = part;
            for (std::string_view one = takeWord(left); !one.empty(); one = takeWord(left))
                checkNumber(rule, one, one);
            if (part.empty())
                add(Severity::Error, segment.value, std::string(rule.key) + " has a comma without a number beside it");
            const std::size_t comma = rest.find(',');
            rest.remove_prefix(comma == std::string_view::npos ? rest.size() : comma + 1);
        }
    }

    void checkWord(const SegmentRule& rule, std::string_view value) const {
        const bool known = std::ranges::any_of(rule.words, [value](std::string_view w) { return sameWord(w, value); });
        if (!known && !(rule.words.front() == "true" && (value == "1" || value == "0")))
            warn(value, std::string(rule.key) + " does not take " + std::string(value) +
                            meant(value, {rule.words.begin(), rule.words.end()}));
    }
};

} // namespace

std::span<const CommandRule> commandRules() {
    static const std::vector<CommandRule> rules = rulesOf(commandKinds());
    return rules;
}

std::vector<Completion> completionsAt(std::string_view line, std::size_t cursor) {
    cursor = std::min(cursor, line.size());
    const std::string_view before = line.substr(0, cursor);
    const std::size_t open = before.rfind('{');
    const std::size_t close = before.rfind('}');
    const bool inside = open != std::string_view::npos && (close == std::string_view::npos || close < open);
    const std::string_view word = typeWordOf(before);
    const bool word_ended = open != std::string_view::npos || (!before.empty() && isSpace(before.back()));
    if (word.empty() || (!word_ended && !inside))
        return commandWords(word, cursor - word.size());
    const CommandRule* const command = ruleOf(word);
    if (!command)
        return {};
    return inside ? insideSegment(*command, line, open, cursor) : keys(*command, line, "{", "", cursor);
}

Diagnostics checkCommand(std::string_view line) {
    Diagnostics found;
    const std::string_view word = typeWordOf(line);
    if (trimmed(line).empty())
        return found;
    checkBraces(line, found);
    const CommandRule* const command = ruleOf(word);
    if (!command) {
        const std::size_t offset = word.empty() ? 0 : static_cast<std::size_t>(word.data() - line.data());
        const std::string named = word.empty() ? "a line without a command word" : std::string(word);
        found.insert(found.begin(),
                     {Severity::Warning, offset, named + ": no server knows this command" + nearestCommand(word)});
        return found;
    }
    Segments segments;
    Diagnostics told_by_braces;
    segments.read(line, told_by_braces);
    const SegmentCheck check{*command, line, found};
    for (const Segment& segment : segments.all())
        check.check(segment);
    std::ranges::stable_sort(found, {}, &Diagnostic::offset);
    return found;
}

} // namespace usar::protocol
