// A POSH plan as its author wrote it: forms, levels and calls in file order, literals with their spelling, and for each
// part its place in the text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/posh/model/call.h"

namespace usar::posh {

/// The comments of the text (`; …` or `# …`, including the mark) that belong to a part and move with it.
struct Remarks {
    std::vector<std::string> above{}; ///< lines before the part; an empty string is a blank line
    std::string beside{};             ///< the rest of a line of the part; empty if none
    bool operator==(const Remarks&) const = default;
};

/// One thing to do while its trigger holds: a drive of the collection, or an element of a competence.
struct Member {
    Name name{};
    Senses trigger{};
    Call action{};                       ///< call of an act, a competence, a pattern or an adopt
    std::optional<Interval> frequency{}; ///< only drives have one: least time between two starts; absent means no limit
    std::optional<Literal> retries{};    ///< only elements have them: an integer, interpreted by retryLimit
    std::optional<Literal> comment{};    ///< a string
    Remarks remarks{};
    Spot at{}; ///< from the opening to the closing parenthesis, as in the structs below
    bool operator==(const Member&) const = default;
};

/// Members that share a pair of parentheses. Drives of one level have equal priority and take turns; elements are tried
/// in their order even within a level.
using Level = std::vector<Member>;
/// Levels in order of priority, the highest first.
using Levels = std::vector<Level>;

/// A parameter with its default: `$speed=1.5`.
struct Formal {
    Variable variable{};
    Literal value{};
    bool operator==(const Formal&) const = default;
};

/// A prioritized choice: does the first element that is ready. It succeeds if its goal holds, fails if no element is
/// ready, and otherwise ends with the result of its element.
struct Competence {
    Name name{};
    std::vector<Formal> formals{};
    std::optional<Interval> time_limit{};
    Senses goal{};
    Levels levels{};
    std::optional<Literal> comment{};
    Remarks remarks{};
    Spot at{};
    bool operator==(const Competence&) const = default;
};

/// A step of a pattern: a call, or a sense that must hold (written in parentheses).
using Step = std::variant<Call, SenseTest>;

/// An action pattern: does its steps one after the other and fails with the first that fails.
struct Pattern {
    Name name{};
    std::vector<Formal> formals{};
    std::optional<Interval> time_limit{};
    /// In the order in which they are done; never empty in a plan without errors.
    std::vector<Step> steps{};
    std::optional<Literal> comment{};
    Remarks remarks{};
    Spot at{};
    bool operator==(const Pattern&) const = default;
};

/// Repeats its call, even after failures and interruptions, until the goal holds.
struct Adopt {
    Name name{};
    std::vector<Formal> formals{};
    Senses goal{};
    Call adopted{};
    Remarks remarks{};
    Spot at{};
    bool operator==(const Adopt&) const = default;
};

/// The kinds of drive collections: RDC and SRDC ask for real time (see wantsRealTime), the others for simulation time.
enum class CollectionKind { Dc, Rdc, Sdc, Srdc };

/// The drive collection, which is the root of a plan.
struct Collection {
    CollectionKind kind = CollectionKind::Dc;
    std::string keyword = "DC"; ///< the kind as written; the case of letters is free
    Name name{};
    Senses goal{};
    Levels levels{};
    std::optional<Literal> comment{};
    Remarks remarks{};
    Spot at{};
    bool operator==(const Collection&) const = default;
};

/// The documentation of a plan: three strings.
struct Documentation {
    Literal title{};
    Literal author{};
    Literal text{};
    Remarks remarks{};
    Spot at{};
    bool operator==(const Documentation&) const = default;
};

/// One form of a plan; documentation is not among them, because it is stored separately.
using Form = std::variant<Competence, Pattern, Adopt, Collection>;

/// A whole plan. It has at most one collection; without one it is a fragment, which can be edited but not run.
struct Plan {
    std::optional<Documentation> documentation{};
    std::vector<Form> forms{}; ///< in file order; paths number the forms of each kind separately
    Remarks remarks{};
    std::vector<std::string> closing_remarks{}; ///< comments after the last form, one line each
    bool operator==(const Plan&) const = default;
};

/// Returns nullptr if the plan is a fragment.
const Collection* collectionOf(const Plan& plan);

/// Returns true for RDC and SRDC, which run in real time, and false for the others, which run in stepped (simulation)
/// time.
bool wantsRealTime(CollectionKind kind);

/// Returns how often the element may start in one engagement; nullopt means no limit (retries absent, zero or
/// negative).
std::optional<std::int64_t> retryLimit(const Member& element);

/// Returns the name as written, with its place in the text.
const Name& nameOf(const Form& form);
Remarks& remarksOf(Form& form);
const Remarks& remarksOf(const Form& form);
/// Returns the place of a form, from its opening to its closing parenthesis.
const Spot& spotOf(const Form& form);
/// Returns the parameters of a form; a collection has none.
const std::vector<Formal>& formalsOf(const Form& form);
/// Returns the drives of a collection or the elements of a competence; nullptr for other forms.
Levels* levelsIn(Form& form);
const Levels* levelsIn(const Form& form);

} // namespace usar::posh
