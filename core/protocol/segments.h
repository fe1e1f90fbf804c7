// One protocol line as its type word and its ordered segments, all views into the line.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.h"

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
    /// Cuts `line`. A missing closing brace makes the rest of the line the last segment (a warning); a brace inside a
    /// segment stays in its value (a warning); stray text and stray closing braces between segments are ignored.
    void read(std::string_view line, Diagnostics& diagnostics);

    std::string_view typeWord() const { return type_word_; }
    std::span<const Segment> all() const { return segments_; }
    /// The first segment with this key, compared without regard to case.
    const Segment* find(std::string_view key) const;
    /// Its value, or an empty view.
    std::string_view value(std::string_view key) const;
    /// The number its value begins with; nothing when the key is missing or holds none.
    std::optional<double> number(std::string_view key) const;

private:
    std::string_view type_word_;
    std::vector<Segment> segments_;
};

/// ASCII comparison without regard to case, as servers and clients of all ages need.
bool sameWord(std::string_view a, std::string_view b);

} // namespace usar::protocol
