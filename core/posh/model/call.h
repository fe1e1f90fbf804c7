// The words of a POSH plan: values, names, calls, senses and times, each with its place in the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace usar::posh {

/// The place of a part in the text that it was read from. Line and column count from 1; a column is one code point,
/// also for a tab. Offset and length are in bytes. Line 0 means that the part was made by code and is not in a text.
/// All spots compare equal, so that plans which differ only in layout are equal.
struct Spot {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    /// The offset after the last byte.
    constexpr std::size_t end() const { return std::size_t{offset} + length; }
    constexpr bool operator==(const Spot&) const { return true; }
};

/// A symbol such as `'red`, or a bare word as the operand of a sense. An enumeration constant has dots. `text` excludes
/// the quote.
struct Symbol {
    std::string text{};
    bool operator==(const Symbol&) const = default;
};

/// The value of a literal or the answer of a sense. std::monostate is nil.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Symbol>;

/// A value with its spelling (`1.0`, `'red`, `"a\tb"` with the quotes). If the spelling is empty, the writer makes one.
struct Literal {
    Value value{};
    std::string spelling{};
    Spot at{};
    bool operator==(const Literal&) const = default;
};

struct Name {
    std::string text{};
    Spot at{};
    bool operator==(const Name&) const = default;
};

/// A variable such as `$speed`. The name excludes the dollar sign; the spot includes it.
struct Variable {
    std::string name{};
    Spot at{};
    bool operator==(const Variable&) const = default;
};

/// An argument of a call. Positional ones come first and have an empty name; for `$name=…` the name excludes the dollar
/// sign.
struct Argument {
    std::string name{};
    std::variant<Literal, Variable> value{};
    Spot at{}; ///< place of the whole argument
    bool operator==(const Argument&) const = default;
};

/// A call of a sense, an act, a competence, a pattern or an adopt.
struct Call {
    Name name{};
    std::vector<Argument> arguments{};
    bool operator==(const Call&) const = default;
};

/// A comparison. `=` and `==` both mean Equal.
enum class Predicate { Equal, NotEqual, Less, Greater, LessOrEqual, GreaterOrEqual };

/// A sense that must hold, such as `(distance 0.3 <)`. Without an operand the answer itself must be true; with an
/// operand and no predicate the two must be equal.
struct SenseTest {
    Call call{};
    std::optional<Literal> operand{};
    std::optional<Predicate> predicate{};
    bool operator==(const SenseTest&) const = default;
};

/// A conjunction of senses. If it is empty (absent, `nil` or `()`), a trigger always holds and a goal never does.
using Senses = std::vector<SenseTest>;

enum class Unit { Hours, Minutes, Seconds, None, Hz, PerMinute, Ticks };

/// A time limit (in hours, minutes, seconds or none) or the frequency of a drive (in any unit). With the unit none, the
/// amount is in milliseconds.
struct Interval {
    Unit unit = Unit::None;
    Literal amount{}; ///< integer or float, not negative
    Spot at{};        ///< place of the unit
    bool operator==(const Interval&) const = default;
};

/// Returns a number as a double, and 0 for a value that is not a number.
double numberOf(const Value& value);

/// These return the spelling in the plan language: "hours", "pm", "<=".
std::string_view toText(Unit unit);
std::string_view toText(Predicate predicate);

} // namespace usar::posh
