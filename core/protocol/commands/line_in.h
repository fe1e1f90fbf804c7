// Takes the values of one command line; the reading half of fields(). LineOut is the writing half.
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

/// As tolerant as a server: keys in any case, the first of several, numbers by their beginning. What is missing leaves
/// an optional value absent and refuses the line otherwise; a refused line stays raw. Lives as long as one line is
/// read.
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
    void refuse(std::string_view part, std::string message);
    void warn(std::string_view part, std::string message);

    void word(std::string_view) {}
    void mark(std::string_view, std::string_view) {}

    void number(std::string_view key, double& value);
    void number(std::string_view key, std::optional<double>& value);
    void flipped(std::string_view key, std::optional<double>& value);
    void degrees(std::string_view key, std::optional<double>& angle_rad);
    void flippedDegrees(std::string_view key, std::optional<double>& angle_rad);
    void beginScale(bool& normalized);
    void endScale() {}
    void speed(std::string_view key, std::optional<double>& value);
    void flippedSpeed(std::string_view key, std::optional<double>& value);
    void whole(std::string_view key, std::optional<int>& value);
    void seconds(std::string_view key, Seconds& value);
    void seconds(std::string_view key, std::optional<Seconds>& value);
    /// Absent is as it was.
    void flag(std::string_view key, bool& value);
    void flag(std::string_view key, std::optional<bool>& value);
    void digit(std::string_view key, std::optional<bool>& value) { flag(key, value); }

    template <TextRule rule>
    void text(std::string_view key, CheckedText<rule>& value) {
        const Segment* const segment = segments_.find(key);
        takeText(key, segment ? segment->value : std::string_view(), value);
    }
    /// The same for text that was found otherwise.
    template <TextRule rule>
    void takeText(std::string_view key, std::string_view found, CheckedText<rule>& value);

    template <class Value>
    void choice(std::string_view key, std::optional<Value>& value) {
        if (const Segment* const segment = segments_.find(key))
            value = meaningOf<Value>(*segment);
    }
    /// Absent is as it was.
    template <class Value>
    requires std::is_enum_v<Value>
    void choice(std::string_view key, Value& value) {
        if (const Segment* const segment = segments_.find(key))
            value = meaningOf<Value>(*segment);
    }
    template <class Value>
    Value meaningOf(const Segment& segment);

    void vector(std::string_view key, Vec3& value);
    void vector(std::string_view key, std::optional<Vec3>& value);
    void position(std::string_view key, Vec3& value);
    /// Location and Rotation, each 0,0,0 where absent.
    void pose(Pose& pose);
    std::optional<Pose> pose();
    void start(std::variant<Pose, Token>& start);

    /// The number that its value begins with, else 0 and a warning.
    double numberOf(const Segment& segment) { return numbersOf<1>(segment)[0]; }
    int wholeOf(const Segment& segment);
    /// Exactly so many numbers; what is missing or no number is 0, with a warning.
    template <std::size_t count>
    std::array<double, count> numbersOf(const Segment& segment) {
        std::array<double, count> values{};
        takeNumbersOf(segment, values);
        return values;
    }
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
