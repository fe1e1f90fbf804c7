// Writes the segments of one info line, spelled and rounded as Unreal prints them.
#pragma once

#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/numbers.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// A zero whose sign is negative, as half a turn between the frames makes it: printed as 0.00 or as -0.00.
enum class NegativeZero { Hidden, Shown };

/// Appends to a text that the caller owns and that must outlive this object. Converts no frames or units.
class LineWriter {
public:
    explicit LineWriter(std::string& out, NegativeZero zero = NegativeZero::Hidden)
        : out_(out)
        , shows_sign_(zero == NegativeZero::Shown) {}

    /// A number without key and braces. TwoRounded rounds to two decimals, and what rounds to zero keeps its sign, as
    /// Unreal prints it. FourCut cuts off after four.
    void number(double value, Decimals decimals) {
        if (decimals == Decimals::TwoRounded)
            appendFixed(out_, value == 0.0 && !shows_sign_ ? 0.0 : value, 2);
        else
            appendTruncated(out_, value <= 0.0 && value > -1e-4 ? 0.0 : value, 4); // never -0.0000
    }
    void text(std::string_view value) { out_.append(value); }
    /// Begins a segment: " {key ". `close` ends it.
    void open(std::string_view key) {
        out_ += " {";
        out_.append(key);
        out_ += ' ';
    }
    void close() { out_ += '}'; }
    /// Values separated by commas, without key and braces.
    void numbers(const Vec3& values, Decimals decimals) {
        number(values.x(), decimals);
        out_ += ',';
        number(values.y(), decimals);
        out_ += ',';
        number(values.z(), decimals);
    }

    /// An empty vector writes nothing.
    void numbers(const std::vector<double>& values, Decimals decimals) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i > 0)
                out_ += ',';
            number(values[i], decimals);
        }
    }

    /// A whole segment: " {key value}". Nothing, here and below, for an absent value.
    void segment(std::string_view key, std::string_view value) {
        open(key);
        text(value);
        close();
    }
    /// A segment with one number: `{Range 2.5000}`.
    void segment(std::string_view key, double value, Decimals decimals) {
        open(key);
        number(value, decimals);
        close();
    }
    /// A segment with three numbers: `{Location 1.00,2.00,-0.50}`.
    void segment(std::string_view key, const Vec3& values, Decimals decimals) {
        open(key);
        numbers(values, decimals);
        close();
    }
    template <class Value>
    void segment(std::string_view key, const std::optional<Value>& value, Decimals decimals) {
        if (value)
            segment(key, *value, decimals);
    }
    /// Nothing for an empty text, either.
    void segmentIfAny(std::string_view key, std::string_view value) {
        if (!value.empty())
            segment(key, value);
    }
    /// A number without decimals.
    void whole(long long value) {
        std::array<char, 24> digits;
        out_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    }
    /// A segment with a number without decimals.
    void whole(std::string_view key, long long value) {
        open(key);
        whole(value);
        close();
    }
    template <class Number>
    void whole(std::string_view key, const std::optional<Number>& value) {
        if (value)
            whole(key, static_cast<long long>(*value));
    }
    /// True or False, as Unreal prints a bool.
    void boolean(std::string_view key, const std::optional<bool>& value) {
        if (value)
            segment(key, *value ? "True" : "False");
    }
    /// STA, RES and the range scanner print the time as a bare float (TwoRounded), all other sensors as a formatted one
    /// (FourCut).
    void time(const std::optional<Seconds>& time, Decimals decimals) {
        if (time)
            segment("Time", time->count(), decimals);
    }
    /// The head of a sensor's line: SEN, Time, Type.
    void sensor(const std::optional<Seconds>& at, std::string_view type) {
        text("SEN");
        time(at, Decimals::FourCut);
        segment("Type", type);
    }

private:
    std::string& out_;
    bool shows_sign_;
};

} // namespace usar::protocol
