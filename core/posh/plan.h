// A POSH plan as a person wrote it: forms, levels and calls in file order, literals with their spelling, each with its
// place in the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace usar::posh {

/// Where something stands in the text it was read from. Line and column count from 1 (a column is one code point, a tab
/// is one); offset and length are bytes. Line 0: made by a program. Where a thing stands is no part of what it says, so
/// all spots compare equal: plans that differ in layout only are equal.
struct Spot {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    constexpr bool operator==(const Spot&) const { return true; }
};

/// `'red`, or a bare word as the operand of a sense; an enumeration constant has dots. Without the quote.
struct Symbol {
    std::string text;
    bool operator==(const Symbol&) const = default;
};

/// std::monostate is nil.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Symbol>;

/// A value with its spelling (`1.0`, `'red`, `"a\tb"` with the quotes). The writer spells a value without one itself.
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

/// `$speed`; the name is without the dollar, the spot begins at it.
struct Variable {
    std::string name;
    Spot at;
    bool operator==(const Variable&) const = default;
};

/// Positional ones come first. `name` is that of `$name=…`, without the dollar, and empty for a positional argument.
struct Argument {
    std::string name;
    std::variant<Literal, Variable> value;
    Spot at; ///< of the whole argument
    bool operator==(const Argument&) const = default;
};

/// A name with arguments: of a sense, an action, a competence, a pattern or an adopt.
struct Call {
    Name name;
    std::vector<Argument> arguments;
    bool operator==(const Call&) const = default;
};

/// `=` and `==` are one.
enum class Predicate { Equal, NotEqual, Less, Greater, LessOrEqual, GreaterOrEqual };

/// `(distance 0.3 <)`. Without operand the truth of the answer is meant; without predicate, equality.
struct SenseTest {
    Call call;
    std::optional<Literal> operand;
    std::optional<Predicate> predicate;
    bool operator==(const SenseTest&) const = default;
};

/// A conjunction. Empty (absent, `nil` or `()`): a trigger always holds, a goal never.
using Senses = std::vector<SenseTest>;

enum class Unit { Hours, Minutes, Seconds, None, Hz, PerMinute, Ticks };

/// A time limit (hours, minutes, seconds, none) or how often a drive may start (any unit).
struct Interval {
    Unit unit = Unit::None;
    Literal amount; ///< integer or float, not negative
    Spot at;        ///< of the unit
    bool operator==(const Interval&) const = default;
};

/// The comments (`; …` or `# …`, with their mark) that travel with a thing: whole lines above it, and the rest of a
/// line it stands on.
struct Remarks {
    std::vector<std::string> above;
    std::string beside;
    bool operator==(const Remarks&) const = default;
};

struct Drive {
    Name name;
    Senses trigger;
    Call action; ///< or competence, pattern, adopt
    std::optional<Interval> frequency;
    std::optional<Literal> comment; ///< a string
    Remarks remarks;
    Spot at; ///< from its opening to its closing parenthesis; the same holds for all that follow
    bool operator==(const Drive&) const = default;
};

/// Equals among each other; levels stand in order of priority, most important first.
using DriveLevel = std::vector<Drive>;

struct Element {
    Name name;
    Senses trigger;
    Call action;
    std::optional<Literal> retries; ///< an integer; see retryLimit
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

/// A sense in parentheses is a test, a bare name a call.
using Step = std::variant<Call, SenseTest>;

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

/// Keep doing the call until the goal holds.
struct Adopt {
    Name name;
    std::vector<Formal> formals;
    Senses goal;
    Call adopted;
    Remarks remarks;
    Spot at;
    bool operator==(const Adopt&) const = default;
};

enum class CollectionKind { Dc, Rdc, Sdc, Srdc };

struct Collection {
    CollectionKind kind = CollectionKind::Dc;
    std::string keyword = "DC"; ///< the kind as written, in any case
    Name name;
    Senses goal;
    std::vector<DriveLevel> levels;
    std::optional<Literal> comment;
    Remarks remarks;
    Spot at;
    bool operator==(const Collection&) const = default;
};

struct Documentation {
    Literal title;
    Literal author;
    Literal text;
    Remarks remarks;
    Spot at;
    bool operator==(const Documentation&) const = default;
};

using Form = std::variant<Competence, Pattern, Adopt, Collection>;

/// At most one collection; without one it is a fragment, which can be edited but not run.
struct Plan {
    std::optional<Documentation> documentation;
    std::vector<Form> forms; ///< in file order: the indices of paths count among those of one kind
    Remarks remarks;
    std::vector<std::string> closing_remarks; ///< comments after the last form, a line each
    bool operator==(const Plan&) const = default;
};

/// Nothing in a fragment.
const Collection* collectionOf(const Plan& plan);

/// Real time for RDC and SRDC, stepped (simulation) time for the others.
bool wantsRealTime(CollectionKind kind);

/// How often the element may start in one engagement; nothing: without limit (absent, zero or negative).
std::optional<std::int64_t> retryLimit(const Element& element);

/// A number as a double; 0 for what is none.
double numberOf(const Value& value);

const Name& nameOf(const Form& form);
Remarks& remarksOf(Form& form);
const Remarks& remarksOf(const Form& form);
const Spot& spotOf(const Form& form);
/// None for a collection.
const std::vector<Formal>& formalsOf(const Form& form);

/// As the language writes them: "hours", "pm", "<=".
std::string_view toText(Unit unit);
std::string_view toText(Predicate predicate);

} // namespace usar::posh
