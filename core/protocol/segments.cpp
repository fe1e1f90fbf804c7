#include "core/protocol/segments.h"

#include <algorithm>

namespace usar::protocol {

namespace {

Segment segmentOf(std::string_view text, std::size_t offset) {
    std::string_view rest = text;
    const std::string_view key = takeWord(rest);
    return {key, trimmed(rest), text, offset};
}

} // namespace

void Segments::read(std::string_view line, Diagnostics& diagnostics) {
    line_ = line;
    segments_.clear();
    bool nested = false;
    std::size_t open = line.find('{');
    type_word_ = trimmed(line.substr(0, open));
    while (open != std::string_view::npos) {
        const std::size_t start = open + 1;
        const std::size_t close = line.find('}', start);
        const std::string_view text = line.substr(start, close - start);
        if (close == std::string_view::npos)
            diagnostics.push_back({Severity::Warning, open, "the closing brace is missing"});
        if (const std::size_t inner = text.find('{'); inner != std::string_view::npos && !nested) {
            nested = true; // reported once per line
            diagnostics.push_back({Severity::Warning, start + inner, "an opening brace inside a segment"});
        }
        if (segments_.size() == most_segments) {
            diagnostics.push_back({Severity::Warning, open, "too many segments; the rest is left out"});
            return;
        }
        if (const Segment segment = segmentOf(text, start); !segment.key.empty())
            segments_.push_back(segment);
        open = close == std::string_view::npos ? close : line.find('{', close + 1);
    }
}

const Segment* Segments::find(std::string_view key) const {
    const auto found = std::ranges::find_if(segments_, [key](const Segment& s) { return sameWord(s.key, key); });
    return found == segments_.end() ? nullptr : &*found;
}

std::string_view Segments::value(std::string_view key) const {
    const Segment* segment = find(key);
    return segment ? segment->value : std::string_view();
}

NamedPairs::NamedPairs(std::string_view value_of_name) : name_(value_of_name) {
    std::string_view rest = value_of_name;
    const std::string_view first = takeWord(rest);
    std::size_t words = 0;
    bool key_begins_with_letter = false;
    for (std::string_view left = rest, word = takeWord(left); !word.empty(); word = takeWord(left)) {
        key_begins_with_letter |= words == 0 && isLetter(word.front());
        ++words;
    }
    if (words == 0 || words % 2 != 0 || !key_begins_with_letter)
        return;
    name_ = first;
    rest_ = rest;
}

bool NamedPairs::next(std::string_view& key, std::string_view& value) {
    key = takeWord(rest_);
    value = takeWord(rest_);
    return !key.empty();
}

} // namespace usar::protocol
