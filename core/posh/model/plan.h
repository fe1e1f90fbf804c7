// A POSH plan as its author wrote it: forms, levels and calls in file order, literals with their spelling, and for each
// part its place in the text.
#pragma once

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
    constexpr bool operator==(const Spot&) const { return true; }
};

/// A symbol such as `'red`, or a bare word as the operand of a sense. An enumeration constant has dots. `text` excludes
/// the quote.
struct Symbol {
    std::string text;
    bool operator==(const Symbol&) const = default;
};

/// The value of a literal or the answer of a sense. std::monostate is nil.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Symbol>;

/// A value with its spelling (`1.0`, `'red`, `"a\tb"` with the quotes). If the spelling is empty, the writer makes one.
struct Literal {
    Value value;
    std::string spelling;
    Spot at;
    bool operator==(const Literal&) const = default;
};

struct Name {
    std::string text;
    Spot at;
    bool operator==(const Name&) const = default;
};

/// A variable such as `$speed`. The name excludes the dollar sign; the spot includes it.
struct Variable {
    std::string name;
    Spot at;
    bool operator==(const Variable&) const = default;
};

/// An argument of a call. Positional ones come first and have an empty name; for `$name=…` the name excludes the dollar
/// sign.
struct Argument {
    std::string name;
    std::variant<Literal, Variable> value;
    Spot at; ///< place of the whole argument
    bool operator==(const Argument&) const = default;
};

/// A call of a sense, an act, a competence, a pattern or an adopt.
struct Call {
    Name name;
    std::vector<Argument> arguments;
    bool operator==(const Call&) const = default;
};

/// A comparison. `=` and `==` both mean Equal.
enum class Predicate { Equal, NotEqual, Less, Greater, LessOrEqual, GreaterOrEqual };

/// A sense that must hold, such as `(distance 0.3 <)`. Without an operand the answer itself must be true; with an
/// operand and no predicate the two must be equal.
struct SenseTest {
    Call call;
    std::optional<Literal> operand;
    std::optional<Predicate> predicate;
    bool operator==(const SenseTest&) const = default;
};

/// A conjunction of senses. If it is empty (absent, `nil` or `()`), a trigger always holds and a goal never does.
using Senses = std::vector<SenseTest>;

enum class Unit { Hours, Minutes, Seconds, None, Hz, PerMinute, Ticks };

/// A time limit (in hours, minutes, seconds or none) or the frequency of a drive (in any unit). With the unit none, the
/// amount is in milliseconds.
struct Interval {
    Unit unit = Unit::None;
    Literal amount; ///< integer or float, not negative
    Spot at;        ///< place of the unit
    bool operator==(const Interval&) const = default;
};

/// The comments of the text (`; …` or `# …`, including the mark) that belong to a part and move with it.
struct Remarks {
    std::vector<std::string> above; ///< lines before the part; an empty string is a blank line
    std::string beside;             ///< the rest of a line of the part; empty if none
    bool operator==(const Remarks&) const = default;
};

/// A drive of the collection: what to do while its trigger holds.
struct Drive {
    Name name;
    Senses trigger;
    Call action;                       ///< call of an act, a competence, a pattern or an adopt
    std::optional<Interval> frequency; ///< least time between two starts; absent means no limit
    std::optional<Literal> comment;    ///< a string
    Remarks remarks;
    Spot at; ///< from the opening to the closing parenthesis, as in the structs below
    bool operator==(const Drive&) const = default;
};

/// Drives of equal priority, which take turns. Levels are in order of priority, the highest first.
using DriveLevel = std::vector<Drive>;

/// An element of a competence: one thing to do if its trigger holds.
struct Element {
    Name name;
    Senses trigger;
    Call action;
    std::optional<Literal> retries; ///< an integer, interpreted by retryLimit
    std::optional<Literal> comment;
    Remarks remarks;
    Spot at;
    bool operator==(const Element&) const = default;
};

using ElementLevel = std::vector<Element>;

/// A parameter with its default: `$speed=1.5`.
struct Formal {
    Variable variable;
    Literal value;
    bool operator==(const Formal&) const = default;
};

/// A prioritized choice: does the first element that is ready. It succeeds if its goal holds, fails if no element is
/// ready, and otherwise ends with the result of its element.
struct Competence {
    Name name;
    std::vector<Formal> formals;
    std::optional<Interval> time_limit;
    Senses goal;
    std::vector<ElementLevel> levels;
    std::optional<Literal> comment;
    Remarks remarks;
    Spot at;
    bool operator==(const Competence&) const = default;
};

/// A step of a pattern: a call, or a sense that must hold (written in parentheses).
using Step = std::variant<Call, SenseTest>;

/// An action pattern: does its steps one after the other and fails with the first that fails.
struct Pattern {
    Name name;
    std::vector<Formal> formals;
    std::optional<Interval> time_limit;
    std::vector<Step> steps;
    std::optional<Literal> comment;
    Remarks remarks;
    Spot at;
    bool operator==(const Pattern&) const = default;
};

/// Repeats its call, even after failures and interruptions, until the goal holds.
struct Adopt {
    Name name;
    std::vector<Formal> formals;
    Senses goal;
    Call adopted;
    Remarks remarks;
    Spot at;
    bool operator==(const Adopt&) const = default;
};

/// The kinds of drive collections: RDC and SRDC ask for real time (see wantsRealTime), the others for simulation time.
enum class CollectionKind { Dc, Rdc, Sdc, Srdc };

/// The drive collection, which is the root of a plan.
struct Collection {
    CollectionKind kind = CollectionKind::Dc;
    std::string keyword = "DC"; ///< the kind as written; the case of letters is free
    Name name;
    Senses goal;
    std::vector<DriveLevel> levels;
    std::optional<Literal> comment;
    Remarks remarks;
    Spot at;
    bool operator==(const Collection&) const = default;
};

/// The documentation of a plan: three strings.
struct Documentation {
    Literal title;
    Literal author;
    Literal text;
    Remarks remarks;
    Spot at;
    bool operator==(const Documentation&) const = default;
};

using Form = std::variant<Competence, Pattern, Adopt, Collection>;

/// A whole plan. It has at most one collection; without one it is a fragment, which can be edited but not run.
struct Plan {
    std::optional<Documentation> documentation;
    std::vector<Form> forms; ///< in file order; paths number the forms of each kind separately
    Remarks remarks;
    std::vector<std::string> closing_remarks; ///< comments after the last form, one line each
    bool operator==(const Plan&) const = default;
};

/// Returns nullptr if the plan is a fragment.
const Collection* collectionOf(const Plan& plan);

/// Returns true for RDC and SRDC, which run in real time, and false for the others, which run in stepped (simulation)
/// time.
bool wantsRealTime(CollectionKind kind);

/// Returns how often the element may start in one engagement; nullopt means no limit (retries absent, zero or
/// negative).
std::optional<std::int64_t> retryLimit(const Element& element);

/// Returns a number as a double, and 0 for a value that is not a number.
double numberOf(const Value& value);

const Name& nameOf(const Form& form);
Remarks& remarksOf(Form& form);
const Remarks& remarksOf(const Form& form);
const Spot& spotOf(const Form& form);
/// Returns the parameters of a form; a collection has none.
const std::vector<Formal>& formalsOf(const Form& form);

/// These return the spelling in the plan language: "hours", "pm", "<=".
std::string_view toText(Unit unit);
std::string_view toText(Predicate predicate);

} // namespace usar::posh
