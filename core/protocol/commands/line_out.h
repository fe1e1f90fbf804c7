// Appends the segments of one command line to a text: the writing side of fields(). LineIn is the reading side.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/wire_words.h"
#include "core/protocol/dialect.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// Writes no segment for an absent or empty value, and 0 for NaN and infinity, which is how a server would read them.
/// Vectors have commas and no spaces; numbers read back as the same double. The text belongs to the caller and must
/// outlive this object.
class LineOut {
public:
    template <class T>
    using Ref = const T&;
    static constexpr bool reading = false;

    LineOut(std::string& out, Dialect dialect) : out_(out), dialect_(dialect) {}
    Dialect dialect() const { return dialect_; }

    /// Begins the line.
    void word(std::string_view word) { out_.append(word); }
    /// Writes a segment that distinguishes one kind of command from another.
    void mark(std::string_view key, std::string_view value) {
        open(key);
        out_.append(value);
        close();
    }

    void number(std::string_view key, double value) {
        open(key);
        add(value);
        close();
    }
    void number(std::string_view key, const std::optional<double>& value) {
        if (value)
            number(key, *value);
    }
    /// Writes a sideways or turning value in our frame with the wire's sign, like all functions with "flipped" in the
    /// name.
    void flipped(std::string_view key, const std::optional<double>& value) {
        if (value)
            number(key, acrossWire(*value));
    }
    void degrees(std::string_view key, const std::optional<double>& angle_rad);
    void flippedDegrees(std::string_view key, const std::optional<double>& angle_rad);

    /// States whether the speeds that follow are in percent (then limited to -100..100); `endScale` writes this flag.
    void beginScale(bool normalized) { normalized_ = normalized; }
    void endScale() { flag("Normalized", normalized_); }
    void speed(std::string_view key, const std::optional<double>& value) {
        if (value)
            number(key, normalized_ ? std::clamp(finite(*value), -100.0, 100.0) : *value);
    }
    void flippedSpeed(std::string_view key, const std::optional<double>& value) {
        if (value)
            speed(key, acrossWire(*value));
    }

    void whole(std::string_view key, const std::optional<int>& value) {
        if (value)
            number(key, *value);
    }
    void seconds(std::string_view key, const std::optional<Seconds>& value) {
        if (value)
            number(key, value->count());
    }
    void flag(std::string_view key, const std::optional<bool>& value) {
        if (value)
            mark(key, *value ? "true" : "false");
    }
    /// A flag that is sent as 1 or 0 instead of true or false.
    void digit(std::string_view key, const std::optional<bool>& value) {
        if (value)
            mark(key, *value ? "1" : "0");
    }
    template <TextRule rule>
    void text(std::string_view key, const CheckedText<rule>& value) {
        if (!value.empty())
            mark(key, value.text());
    }
    template <class Value>
    void choice(std::string_view key, const std::optional<Value>& value) {
        if (value)
            mark(key, wordOf(*value));
    }
    template <class Value>
    requires std::is_enum_v<Value>
    void choice(std::string_view key, Value value) { mark(key, wordOf(value)); }

    /// Writes the vector unchanged.
    void vector(std::string_view key, const std::optional<Vec3>& value);
    /// Converts the position from our frame to the wire's.
    void position(std::string_view key, const Vec3& value) { vector(key, acrossWire(value)); }
    /// Writes a pose in our frame as Location and Rotation.
    void pose(const Pose& pose);
    /// Writes a pose, or the name of a start pose.
    void start(const std::variant<Pose, Token>& start);

    /// The parts of a segment, for values that no function above can write.
    void open(std::string_view key) {
        out_ += " {";
        out_.append(key);
        out_ += ' ';
    }
    void close() { out_ += '}'; }
    void add(std::string_view text) { out_.append(text); }
    void add(double value) { appendShortest(out_, finite(value)); }
    void add(const Vec3& value);

    /// The word for a value of an enumeration in wire_words.h.
    template <class Value>
    static std::string_view wordOf(Value value) {
        for (const WireWord<Value>& row : wire_words<Value>) {
            if (row.value == value)
                return row.word;
        }
        return {};
    }

private:
    /// Also turns -0 into 0.
    static double finite(double value) { return std::isfinite(value) ? value + 0.0 : 0.0; }

    std::string& out_;
    Dialect dialect_;
    bool normalized_ = false;
};

} // namespace usar::protocol
