// A plan made ready to run: every place that a run can reach, expanded through references, in flat arrays.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// Where something stands in one of a program's arrays.
using Index = std::uint32_t;
constexpr Index nowhere = std::numeric_limits<Index>::max();

struct Range {
    Index first = 0;
    Index end = 0;
    bool empty() const { return first == end; }
    bool contains(Index index) const { return index >= first && index < end; }
    bool operator==(const Range&) const = default;
};

enum class PlaceKind : std::uint8_t { Collection, Drive, Competence, Pattern, Adopt, Element, Act, SenseStep, Sense };

/// What a trace, a breakpoint and a view name by its number: the same form reached by two ways is two places.
struct Place {
    PlaceKind kind = PlaceKind::Collection;
    Index parent = nowhere;
    Index name = 0;      ///< in `names`
    Index item = 0;      ///< in the array of its kind: drives, forms, elements, acts, steps or tests
    Index position = 0;  ///< the last number of its path
    Index reference = 0; ///< of a competence, pattern or adopt: the number after "A:" on the way to it
    Spot at;             ///< of its name
};

struct CallArgument {
    std::string name; ///< without the dollar; empty for a positional argument
    Value value;
    bool operator==(const CallArgument&) const = default;
};

/// A sense or act with its arguments, all constant once the plan is expanded. Equal calls are one.
struct ProgramCall {
    std::string name;
    std::vector<CallArgument> arguments;
    std::string text; ///< as traces print it: fly("lake", $speed=9)
    Spot at;          ///< of the first that names it
};

struct ProgramTest {
    Index place = 0;
    Index call = 0; ///< in sense_calls
    bool compares = false;
    Predicate predicate = Predicate::Equal;
    Value operand;
};

struct ProgramAct {
    Index place = 0;
    Index call = 0;       ///< in act_calls
    Index form = nowhere; ///< that it stands in; nowhere below a drive
    bool operator==(const ProgramAct&) const = default;
};

/// What a drive, element, step or adopt refers to.
struct Target {
    bool is_act = false;
    Index index = nowhere; ///< in acts or forms
    bool operator==(const Target&) const = default;
};

struct ProgramDrive {
    Index place = 0;
    Index level = 0;
    Range trigger; ///< in tests
    Range forms;   ///< all below it
    Target target;
    double interval_ms = 0.0; ///< least time between starts; 0 for none
    double interval_cycles = 0.0;
    Index depth = 0; ///< of the deepest stack below it
};

/// Members of a level are equals. The range is of drives.
struct ProgramLevel {
    Range drives;
    bool operator==(const ProgramLevel&) const = default;
};

struct ProgramForm {
    PlaceKind kind = PlaceKind::Competence;
    Index place = 0;
    Index parent = nowhere; ///< the form whose element, step or reference leads here
    Index below_end = 0;    ///< forms from this one to before that are this one and all below it
    Range goal;             ///< in tests; empty in a pattern
    std::optional<double> limit_ms;
    Range items; ///< elements of a competence, steps of a pattern, one step of an adopt
};

struct ProgramElement {
    Index place = 0;
    Range trigger;
    Target target;
    std::int64_t retries = 0; ///< 0 for no limit
};

/// A sense that must hold, or a target.
struct ProgramStep {
    Index test = nowhere;
    Target target;
    bool operator==(const ProgramStep&) const = default;
};

struct Program {
    std::string title; ///< of the collection
    bool real_time = false;
    std::vector<std::string> names;
    std::vector<Place> places; ///< the collection first
    std::vector<ProgramCall> sense_calls;
    std::vector<ProgramCall> act_calls;
    std::vector<ProgramTest> tests;
    std::vector<ProgramAct> acts;
    std::vector<ProgramLevel> levels;
    std::vector<ProgramDrive> drives;
    std::vector<ProgramForm> forms; ///< parents before children, below each drive in the order of the plan
    std::vector<ProgramElement> elements;
    std::vector<ProgramStep> steps;
    Range goal; ///< of the collection, in tests
};

/// "/P:0/DC:0/DE:1/A:0/C:2/CE:0/A:0".
std::string pathOf(const Program& program, Index place);
/// The same for people, by names: "robot ▸ work ▸ pick-up ▸ grab ▸ close-gripper".
std::string namePathOf(const Program& program, Index place);
const std::string& nameOf(const Program& program, Index place);
/// Every call of a sense or act as a trace shows it at its place; empty for other places.
const std::string& callTextAt(const Program& program, Index place);

/// The place of that path if it has those names, else the first with those names, else nowhere.
Index findPlace(const Program& program, std::string_view path, std::string_view names);

/// They differ in operands, predicates, retries, limits, frequencies, names and layout at most: what runs of one can go
/// on as the other.
bool sameShape(const Program& one, const Program& other);

/// More places than this are an error: forms that refer to others twice each double with every level.
constexpr std::size_t most_places = 1'000'000;

/// Expands the plan. A fragment, a circle of references, a name without value and a plan with too many places are
/// errors that name the place; a checked plan (see plan_check.h) can only fail for the last.
Result<std::shared_ptr<const Program>> compile(const Plan& plan);

} // namespace usar::posh
