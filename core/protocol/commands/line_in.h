// Reads the values of one command line: the reading side of fields(). LineOut is the writing side.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/base/clock.h"
#include "core/base/diagnostics.h"
#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/wire_words.h"
#include "core/protocol/dialect.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Is as tolerant as a server: accepts keys in any case, uses the first of several equal keys, and reads numbers by
/// their beginning. A missing value leaves an optional absent and refuses the line otherwise, unless stated below; a
/// refused line becomes a RawCommand. Created for one line; refers to the caller's `segments` and `diagnostics`.
class LineIn {
public:
    template <class T>
    using Ref = T&;
    static constexpr bool reading = true;

    LineIn(const Segments& segments, Diagnostics& diagnostics, Dialect dialect)
        : segments_(segments)
        , diagnostics_(diagnostics)
        , dialect_(dialect) {}
    Dialect dialect() const { return dialect_; }
    const Segments& segments() const { return segments_; }
    bool refused() const { return refused_; }
    /// Refuses the line; only the first reason is reported. `part`, here and below, is a view into the line.
    void refuse(std::string_view part, std::string message);
    void warn(std::string_view part, std::string message);

    void word(std::string_view) {}
    void mark(std::string_view, std::string_view) {}

    void number(std::string_view key, double& value);
    void number(std::string_view key, std::optional<double>& value);
    /// Changes the sign from the wire's frame to ours, like all functions with "flipped" in the name.
    void flipped(std::string_view key, std::optional<double>& value);
    /// Converts degrees on the wire to rad.
    void degrees(std::string_view key, std::optional<double>& angle_rad);
    void flippedDegrees(std::string_view key, std::optional<double>& angle_rad);
    /// Reads whether the speeds that follow are in percent; these are limited to -100..100, with a warning.
    void beginScale(bool& normalized);
    void endScale() {}
    void speed(std::string_view key, std::optional<double>& value);
    void flippedSpeed(std::string_view key, std::optional<double>& value);
    void whole(std::string_view key, std::optional<int>& value);
    void seconds(std::string_view key, Seconds& value);
    void seconds(std::string_view key, std::optional<Seconds>& value);
    /// Keeps the old value if the key is missing. Anything but true, false, 1 and 0 is false, with a warning.
    void flag(std::string_view key, bool& value);
    void flag(std::string_view key, std::optional<bool>& value);
    void digit(std::string_view key, std::optional<bool>& value) { flag(key, value); }

    /// Removes characters that do not fit the rule, with a warning; refuses the line if a Token is missing.
    template <TextRule rule>
    void text(std::string_view key, CheckedText<rule>& value) {
        const Segment* const segment = segments_.find(key);
        takeText(key, segment ? segment->value : std::string_view(), value);
    }
    /// The same for a text that the caller has found; `key` is for the message.
    template <TextRule rule>
    void takeText(std::string_view key, std::string_view found, CheckedText<rule>& value);

    template <class Value>
    void choice(std::string_view key, std::optional<Value>& value) {
        if (const Segment* const segment = segments_.find(key))
            value = meaningOf<Value>(*segment);
    }
    /// Keeps the old value if the key is missing.
    template <class Value>
    requires std::is_enum_v<Value>
    void choice(std::string_view key, Value& value) {
        if (const Segment* const segment = segments_.find(key))
            value = meaningOf<Value>(*segment);
    }
    /// The value that the segment's word stands for; refuses the line if the word is unknown.
    template <class Value>
    Value meaningOf(const Segment& segment);

    /// Three numbers in the wire's frame; `position` converts them to ours.
    void vector(std::string_view key, Vec3& value);
    void vector(std::string_view key, std::optional<Vec3>& value);
    void position(std::string_view key, Vec3& value);
    /// Reads Location and Rotation, each 0,0,0 if absent, into a pose in our frame.
    void pose(Pose& pose);
    /// The same; nullopt if both are absent.
    std::optional<Pose> pose();
    /// Reads Start, the name of a start pose, or else a pose.
    void start(std::variant<Pose, Token>& start);

    /// The number that the segment's value begins with; 0, with a warning, if there is none.
    double numberOf(const Segment& segment) { return numbersOf<1>(segment)[0]; }
    /// The same; refuses the line if the number is not whole or is beyond 1e9.
    int wholeOf(const Segment& segment);
    /// Reads exactly `count` numbers; missing and invalid ones are 0, with a warning.
    template <std::size_t count>
    std::array<double, count> numbersOf(const Segment& segment) {
        std::array<double, count> values{};
        takeNumbersOf(segment, values);
        return values;
    }
    /// Reads as many numbers as `values` holds in the same way; false after a warning.
    bool takeNumbersOf(const Segment& segment, std::span<double> values);

private:
    const Segments& segments_;
    Diagnostics& diagnostics_;
    Dialect dialect_;
    bool normalized_ = false;
    bool refused_ = false;
};

template <TextRule rule>
void LineIn::takeText(std::string_view key, std::string_view found, CheckedText<rule>& value) {
    const std::string left = fitted(rule, found);
    if (left.size() != found.size())
        warn(found, "spaces or braces that cannot be there; read as '" + left + "'");
    if (auto made = CheckedText<rule>::make(left))
        value = std::move(*made);
    else
        refuse(segments_.line(), std::string(segments_.typeWord()) + " needs a " + std::string(key));
}

template <class Value>
Value LineIn::meaningOf(const Segment& segment) {
    for (const WireWord<Value>& row : wire_words<Value>) {
        if (sameWord(row.word, segment.value))
            return row.value;
    }
    refuse(segment.text, std::string(segment.key) + " does not take '" + std::string(segment.value) + "'");
    return {};
}

} // namespace usar::protocol
