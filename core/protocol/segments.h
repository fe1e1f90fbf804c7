// A protocol line split into its type word and its ordered segments, which are all views into the line.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"
#include "core/base/text.h"

namespace usar::protocol {

/// One `{...}` group. `text` is everything between the braces, `key` its first word, and `value` the trimmed rest,
/// empty if there is only one word. `offset` is the byte in the line at which `text` starts.
struct Segment {
    std::string_view key;
    std::string_view value;
    std::string_view text;
    std::size_t offset = 0;
};

/// A tokenized line. Segments are an ordered list and never a map: repeated keys are normal, and a segment belongs to
/// the last group-opening key before it (protocol.md 1.4). All texts are views into the line given to `read`,
/// which must outlive their use. Reuse the object, so that reading allocates nothing in steady state.
class Segments {
public:
    /// Further segments are ignored with a warning. No server sends a hundredth as many.
    static constexpr std::size_t most_segments = 65536;

    /// Tokenizes `line`. If a closing brace is missing, the rest of the line is the last segment (with a warning); an
    /// opening brace inside a segment stays in its value (with one warning per line); stray text, stray closing braces
    /// and empty braces are ignored. Appends to `diagnostics`.
    void read(std::string_view line, Diagnostics& diagnostics);

    std::string_view line() const { return line_; }
    /// The text before the first brace, trimmed: "SEN". Empty if the line begins with a brace.
    std::string_view typeWord() const { return type_word_; }
    std::span<const Segment> all() const { return segments_; }
    /// The first segment with this key, ignoring case; nullptr if there is none.
    const Segment* find(std::string_view key) const;
    /// The value of that segment; empty if there is none.
    std::string_view value(std::string_view key) const;
    /// The offset at which `part`, a view into the line, starts; 0 for a null view.
    std::size_t offsetOf(std::string_view part) const {
        return part.data() ? static_cast<std::size_t>(part.data() - line_.data()) : 0;
    }

private:
    std::string_view line_;
    std::string_view type_word_;
    std::vector<Segment> segments_;
};

/// Splits the value of a Name segment that holds several pairs, `{Name F1 Range 4.5604}`. The syntax does not
/// distinguish it from a value with spaces, but the rule of protocol.md 1.4 does: the key is Name, a positive even
/// number of words follows the first, and the second word begins with a letter. All texts are views into the line.
class NamedPairs {
public:
    /// If the rule does not apply, the whole value is the name and there are no pairs.
    explicit NamedPairs(std::string_view value_of_name);

    std::string_view name() const { return name_; }
    /// Gives the next key and its value; false if none is left.
    bool next(std::string_view& key, std::string_view& value);

private:
    std::string_view name_;
    std::string_view rest_;
};

} // namespace usar::protocol
