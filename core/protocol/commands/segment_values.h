// The values of single segments of a command line, read as tolerantly as a server does.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/diagnostics.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Reports what it corrects, and remembers whether the line must be refused. Refers to the caller's segments and
/// diagnostics. `part` is a view into the line, here and below.
class SegmentValues {
public:
    SegmentValues(const Segments& segments, Diagnostics& diagnostics)
        : segments_(segments)
        , diagnostics_(diagnostics) {}

    const Segments& segments() const { return segments_; }
    bool refused() const { return refused_; }
    /// Refuses the line; only the first reason is reported.
    void refuse(std::string_view part, std::string message);
    /// Refuses the line because it has no segment with this key.
    void refuseWithout(std::string_view key);
    void warn(std::string_view part, std::string message);

    /// The number that the value begins with; 0, with a warning, if there is none.
    double numberOf(const Segment& segment) { return numbersOf<1>(segment)[0]; }
    /// The same; refuses the line if the number is not whole or is beyond 1e9.
    int wholeOf(const Segment& segment);
    /// An angle in rad that is in degrees on the wire; 0, with a warning, if it is not a number.
    double radiansOf(const Segment& segment);
    /// True, false, 1 or 0; anything else is false, with a warning.
    bool booleanOf(const Segment& segment);
    /// Exactly `count` numbers; missing and invalid ones are 0, with a warning.
    template <std::size_t count>
    std::array<double, count> numbersOf(const Segment& segment) {
        std::array<double, count> values{};
        takeNumbersOf(segment, values);
        return values;
    }
    /// Reads as many numbers as `values` holds in the same way; false after a warning.
    bool takeNumbersOf(const Segment& segment, std::span<double> values);

    /// Removes characters from `found` that do not fit the rule, with a warning; refuses the line if a Token is empty.
    template <TextRule rule>
    void takeText(std::string_view key, std::string_view found, CheckedText<rule>& value) {
        const std::string left = fitted(rule, found);
        if (left.size() != found.size())
            warn(found, "contains spaces or braces that are not allowed here; read as '" + left + "'");
        if (auto made = CheckedText<rule>::make(left))
            value = std::move(*made);
        else
            refuseWithout(key);
    }

    /// What the segment's word stands for; refuses the line if the word is unknown.
    template <class Value, std::size_t count>
    Value meaningOf(const Segment& segment, const std::array<WireWord<Value>, count>& table) {
        const auto row = std::ranges::find_if(table, [&](const auto& r) { return sameWord(r.word, segment.value); });
        if (row != table.end())
            return row->value;
        refuse(segment.text, std::string(segment.key) + " does not take '" + std::string(segment.value) + "'");
        return {};
    }

private:
    const Segments& segments_;
    Diagnostics& diagnostics_;
    bool refused_ = false;
};

} // namespace usar::protocol
