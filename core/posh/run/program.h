// A compiled plan: all places that a run can reach, with references expanded, in flat arrays.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/posh/model/plan.h"
#include "core/posh/run/place.h"

namespace usar::posh {

/// One argument of a call.
struct CallArgument {
    std::string name; ///< without the dollar sign; empty for a positional argument
    Value value;
    bool operator==(const CallArgument&) const = default;
};

/// A call of a sense or act. Its arguments are constant, because expanding the plan replaces all variables. Equal calls
/// share one entry.
struct ProgramCall {
    std::string name;
    std::vector<CallArgument> arguments{};
    std::string text; ///< the call as traces print it: fly("lake", $speed=9)
    Spot at;          ///< place in the text of the first such call
};

/// A sense that must hold.
struct ProgramTest {
    Index place = 0;
    Index call = 0;        ///< index in sense_calls
    bool compares = false; ///< if false, the truth of the answer counts and the two fields below are unused
    Predicate predicate = Predicate::Equal;
    Value operand{};
};

/// An act at one place of the plan.
struct ProgramAct {
    Index place = 0;
    Index call = 0;       ///< index in act_calls
    Index form = nowhere; ///< the innermost form that contains it; `nowhere` directly below a drive
    bool operator==(const ProgramAct&) const = default;
};

/// The act or form that a drive, element, step or adopt executes.
struct Target {
    bool is_act = false;
    Index index = nowhere; ///< index in acts or forms
    bool operator==(const Target&) const = default;
};

/// A drive of the collection, with the conditions under which it may start.
struct ProgramDrive {
    Index place = 0;
    Index level = 0; ///< index in levels
    Range trigger;   ///< range of tests
    Range forms{};   ///< all forms below it
    Target target{};
    double interval_ms = 0.0;     ///< least time between two starts; 0 means no limit
    double interval_cycles = 0.0; ///< least number of cycles between two starts; 0 means no limit
    Index depth = 0;              ///< greatest number of forms that can be open below it
};

/// A competence, pattern or adopt at one place; a form that is called twice appears twice.
struct ProgramForm {
    PlaceKind kind = PlaceKind::Competence;
    Index place = 0;
    Index parent = nowhere; ///< the form whose element or step leads here; `nowhere` directly below a drive
    Index below_end = 0;    ///< this form and all forms below it have the indices from its own to below_end - 1
    Range goal{};           ///< range of tests; empty for a pattern, or if the plan has no goal there
    std::optional<double> limit_ms{}; ///< time limit; nullopt means none
    Range items{};                    ///< elements of a competence, steps of a pattern, or the single step of an adopt
};

/// An element of a competence.
struct ProgramElement {
    Index place = 0;
    Range trigger; ///< range of tests
    Target target;
    std::int64_t retries = 0; ///< how often it may start in one engagement; 0 means no limit
};

/// A step of a pattern: a test if `test` is not `nowhere`, otherwise a target.
struct ProgramStep {
    Index test = nowhere;
    Target target;
    bool operator==(const ProgramStep&) const = default;
};

/// A whole compiled plan; immutable once compile has returned it.
struct Program {
    std::string title;      ///< name of the collection
    bool real_time = false; ///< whether the collection asks for real time (see wantsRealTime)
    /// Names that places refer to.
    std::vector<std::string> names;
    std::vector<Place> places; ///< the collection is first
    std::vector<ProgramCall> sense_calls;
    std::vector<ProgramCall> act_calls;
    std::vector<ProgramTest> tests;
    std::vector<ProgramAct> acts;
    std::vector<Range> levels; ///< ranges of drives with the same priority
    std::vector<ProgramDrive> drives;
    std::vector<ProgramForm> forms; ///< in preorder, drive by drive
    std::vector<ProgramElement> elements;
    std::vector<ProgramStep> steps;
    Range goal; ///< goal of the collection, a range of tests
};

/// Returns the path of a place: "/P:0/DC:0/DE:1/A:0/C:2/CE:0/A:0".
std::string pathOf(const Program& program, Index place);
/// Returns the same path as names for display: "robot ▸ work ▸ pick-up ▸ grab ▸ close-gripper".
std::string namePathOf(const Program& program, Index place);
/// Returns the name of a place as the plan spells it.
const std::string& nameOf(const Program& program, Index place);
/// Returns the call of a sense or act as traces print it; empty for other places.
const std::string& callTextAt(const Program& program, Index place);

/// Returns the place with that path if it has these names, otherwise the first place with these names, otherwise
/// `nowhere`.
Index findPlace(const Program& program, std::string_view path, std::string_view names);

/// Returns whether the programs differ at most in operands, predicates, retries, limits, frequencies, names and layout,
/// so that a run of one can continue with the other.
bool sameShape(const Program& one, const Program& other);

/// A plan with more places is an error. If each form calls another one twice, the number doubles with every level.
constexpr std::size_t most_places = 1'000'000;

/// Expands a plan. Fails, naming the place, for a fragment, a reference cycle, a variable without a value, a pattern
/// without steps, and too many places. A plan that has a collection and no errors (see readPlan) can only fail
/// because of too many places.
Result<std::shared_ptr<const Program>> compile(const Plan& plan);

} // namespace usar::posh
