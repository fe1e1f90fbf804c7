// Lists the segments that a command may have: the visitor of T::segments from which grammar, completion and help
// follow.
#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/dialect.h"

namespace usar::protocol {

/// Visits a command without looking at its values and collects one rule for each key.
class LineRules {
public:
    /// Both are false, so a command's `segments` converts no values and fills none.
    static constexpr bool reading = false;
    static constexpr bool writing = false;

    /// All segments, in the order of the wire, and those of them that are marks.
    std::vector<SegmentRule> segments;
    std::vector<SegmentRule> marks;

    /// The rules do not depend on the dialect; UDK's keys are listed, too.
    Dialect dialect() const { return Dialect::Ut2004; }

    /// A mark's words tell this command from others with the same first word, so it also goes into `marks`.
    void mark(const Key& key, std::string_view word, std::string_view other_word = {}) {
        add(key, ValueForm::Word, texts(word, other_word));
        marks.push_back(segments.back());
    }
    template <class Value, std::size_t count>
    void mark(const Key& key, const Value&, const std::array<WireWord<Value>, count>& table) {
        addWords(key, table);
        marks.push_back(segments.back());
    }
    /// Segments that mean nothing here are listed nevertheless, so that the grammar does not call them unknown.
    void ignored(const Key& key) { add(key, ValueForm::Number); }
    void number(const Key& key, const auto&, NumberForm = {}) { add(key, ValueForm::Number); }
    /// `Normalized` is listed once, at the end of the values that it scales.
    void beginScale(bool) {}
    void endScale() { flag(normalized_key, false); }
    void flag(const Key& key, const auto&) { add(key, ValueForm::Word, texts("true", "false")); }
    void neededFlag(const Key& key, bool value) { flag(key, value); }
    /// A flag that is 1 or 0 on the wire.
    void digit(const Key& key, const auto&) { add(key, ValueForm::Number, texts("0", "1")); }
    /// Any text; the words of the key are suggestions only.
    void text(const Key& key, const auto&) { add(key, ValueForm::FreeText, key.words); }
    /// One word of the enumeration's table.
    template <class Value>
    void choice(const Key& key, const Value&) {
        addWords(key, wire_words<Value>);
    }
    template <class Value>
    void choice(const Key& key, const std::optional<Value>&) {
        addWords(key, wire_words<Value>);
    }
    /// Numbers separated by commas; the key's help names their unit.
    void vector(const Key& key, const auto&) { add(key, ValueForm::Numbers); }
    void position(const Key& key, const auto&) { add(key, ValueForm::Numbers); }
    void pose(const auto&) {
        add(location_key, ValueForm::Numbers);
        add(rotation_key, ValueForm::Numbers);
    }
    /// A pose, and beside it the key for the name of a start pose.
    void start(const Key& key, const auto& start, const auto*...) {
        pose(start);
        add(key, ValueForm::FreeText);
    }
    void sixNumbers(const Key& key, const auto&) { add(key, ValueForm::Numbers); }
    /// Two keys of which a line has one: a point, or the name of a path node.
    void goal(const Key& point_key, const Key& node_key, const auto&) {
        add(point_key, ValueForm::Numbers);
        add(node_key, ValueForm::FreeText);
    }
    /// The list of points has semicolons, so the grammar takes it for a text.
    void points(const Key& key, const auto&) { add(key, ValueForm::FreeText); }
    void box(const Key& min_key, const Key& max_key, const auto&) {
        add(min_key, ValueForm::Numbers);
        add(max_key, ValueForm::Numbers);
    }
    void pace(const Key& speed_key, const Key& time_key, const auto&) {
        add(speed_key, ValueForm::Number);
        add(time_key, ValueForm::Number);
    }
    void valueAndSteer(const Key& key, const auto&, const auto&) { add(key, ValueForm::Numbers); }
    void tagAndText(const Key& key, const auto&, const auto&) { add(key, ValueForm::FreeText); }
    /// Lists the segments of one element and marks them as repeatable; a line may have any number of elements.
    template <class Element>
    void groups(const Key&, const std::vector<Element>&) {
        const std::size_t before = segments.size();
        const Element any;
        Element::segments(*this, any);
        for (SegmentRule& rule : std::span(segments).subspan(before))
            rule.repeats = true;
    }
    /// Lists the usual joints alone; other joint names are not errors.
    void joints(std::span<const Key> usual, const auto&) {
        for (const Key& key : usual)
            add(key, ValueForm::Number);
    }

private:
    /// Adds one rule; empty words are dropped, because they stand for an absent second word of a mark.
    void add(const Key& key, ValueForm form, std::span<const std::string_view> words = {}) {
        SegmentRule& rule = segments.emplace_back(SegmentRule{.key = key, .help = std::string(key.help), .form = form});
        std::ranges::remove_copy(words, std::back_inserter(rule.words), std::string_view());
    }
    /// Words that are all numbers ("0", "1") only suggest what number to write.
    template <class Value, std::size_t count>
    void addWords(const Key& key, const std::array<WireWord<Value>, count>& table) {
        std::array<std::string_view, count> words;
        std::ranges::transform(table, words.begin(), &WireWord<Value>::word);
        add(key,
            std::ranges::all_of(words, [](auto word) { return isDigit(word[0]); }) ? ValueForm::Number
                                                                                   : ValueForm::Word,
            words);
    }
};

} // namespace usar::protocol
