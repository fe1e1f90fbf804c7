// One protocol line as its type word and its ordered segments, all views into the line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/text.h"

namespace usar::protocol {

/// One `{...}` group. `text` is all between the braces; `key` its first word, `value` the trimmed rest (empty for a
/// lone word). `offset` is where `text` starts in the line.
struct Segment {
    std::string_view key;
    std::string_view value;
    std::string_view text;
    std::size_t offset = 0;
};

/// A tokenised line. Segments are an ordered list and never a map: repeated keys are normal, and a segment belongs to
/// the last group-opening key before it (usarsim-protocol 1.4). Views into the line given to `read`; the object is
/// meant to be reused so that reading allocates nothing in steady state.
class Segments {
public:
    /// No server sends a hundredth of it; what comes behind is left out (a warning).
    static constexpr std::size_t most_segments = 65536;

    /// Cuts `line`. A missing closing brace makes the rest of the line the last segment (a warning); a brace inside a
    /// segment stays in its value (a warning, said once a line); stray text, stray closing braces and braces around
    /// nothing are ignored.
    void read(std::string_view line, Diagnostics& diagnostics);

    std::string_view line() const { return line_; }
    std::string_view typeWord() const { return type_word_; }
    std::span<const Segment> all() const { return segments_; }
    /// The first segment with this key, compared without regard to case.
    const Segment* find(std::string_view key) const;
    /// Its value, or an empty view.
    std::string_view value(std::string_view key) const;
    /// The number its value begins with; nothing when the key is missing or holds none.
    std::optional<double> number(std::string_view key) const;
    /// Where `part`, a view into the line, starts in it; 0 for a view of nothing.
    std::size_t offsetOf(std::string_view part) const {
        return part.data() ? static_cast<std::size_t>(part.data() - line_.data()) : 0;
    }

private:
    std::string_view line_;
    std::string_view type_word_;
    std::vector<Segment> segments_;
};

/// The pairs of a segment that holds several of them, `{Name F1 Range 4.5604}`. Nothing in the syntax tells it from a
/// value with spaces; the rule of usarsim-protocol 1.4 does: the key is Name, an even number of words follows the
/// first, and the second word begins with a letter. Views into the line.
class NamedPairs {
public:
    /// The name alone, and no pairs, where the rule does not hold.
    explicit NamedPairs(std::string_view value_of_name);

    std::string_view name() const { return name_; }
    /// The next key and its value; false when there is none left.
    bool next(std::string_view& key, std::string_view& value);

private:
    std::string_view name_;
    std::string_view rest_;
};

} // namespace usar::protocol
