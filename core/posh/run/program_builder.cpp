// Expands a plan into a program. Forms that are yet to be expanded are on an explicit stack instead of in recursion, so
// that a plan can have any depth.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "core/posh/model/keyword.h"
#include "core/posh/model/number_table.h"
#include "core/posh/run/program.h"
#include "core/posh/run/value_text.h"

namespace usar::posh {

namespace {

/// The values of a form's parameters at one place. The values are owned by the plan.
struct Scope {
    Index outer = nowhere;
    Index depth = 1;
    std::vector<std::pair<std::string_view, const Value*>> values{};
};

enum class Slot { Drive, Element, Step };

/// A reference whose form is yet to be expanded, and the place where the index of that form must be stored.
struct Waiting {
    const Form* form = nullptr;
    Index position = 0; ///< number among the forms of its kind
    const Call* call = nullptr;
    Index place = 0;         ///< its parent place
    Index reference = 0;     ///< see Place::reference
    Index caller = nowhere;  ///< form that contains the call; `nowhere` directly below a drive
    Slot slot = Slot::Drive; ///< array whose entry refers to the form
    Index slot_index = 0;    ///< index of that entry
    Index drive = 0;         ///< drive that the form is below
};

/// Returns the size of a list, which is the index of the next item.
template <class Item>
Index sizeOf(const std::vector<Item>& list) {
    return static_cast<Index>(list.size());
}

/// Returns the time, or the time between two starts at a rate; 0 for ticks and for a rate of zero.
double millisecondsOf(const Interval& interval) {
    constexpr std::array unit_ms{3'600'000.0, 60'000.0, 1000.0, 1.0, 1000.0, 60'000.0, 0.0}; // Indexed by Unit
    const double amount = numberOf(interval.amount.value);
    const double one_ms = unit_ms[static_cast<std::size_t>(interval.unit)];
    if (isTimeUnit(interval.unit))
        return amount * one_ms;
    return amount > 0.0 ? one_ms / amount : 0.0;
}

/// Returns a time limit in milliseconds. `(none 0)` means no limit, while `(seconds 0)` is a limit that is always
/// exceeded.
std::optional<double> limitOf(const std::optional<Interval>& interval) {
    if (!interval || (interval->unit == Unit::None && numberOf(interval->amount.value) == 0.0))
        return std::nullopt;
    return millisecondsOf(*interval);
}

class Builder {
public:
    explicit Builder(const Plan& plan) : plan_(plan) { findForms(); }

    Result<std::shared_ptr<const Program>> build() {
        if (const Collection* const collection = collectionOf(plan_)) {
            reserve();
            addCollection(*collection);
        } else {
            fail("the plan has no drive collection", {}, "Write a form such as (DC name (drives …))");
        }
        while (!waiting_.empty() && !error_) {
            const Waiting next = waiting_.back();
            waiting_.pop_back();
            expand(next);
        }
        if (error_)
            return tl::unexpected(*std::move(error_));
        finish();
        return program_;
    }

private:
    auto nameOfForm() const {
        return [this](Index form) -> const std::string& { return nameOf(*forms_[form].first).text; };
    }

    void fail(std::string what, Spot at, std::string mend) {
        if (error_)
            return;
        const std::string where = at.line ? "line " + std::to_string(at.line) + ", column " + std::to_string(at.column)
                                          : std::string("the plan");
        error_ = Error{std::move(what), where, std::move(mend)};
    }

    void findForms() {
        std::array<Index, std::variant_size_v<Form>> count{};
        for (const Form& form : plan_.forms) {
            if (std::holds_alternative<Collection>(form))
                continue;
            forms_.emplace_back(&form, count[form.index()]++);
            form_names_.findOrNote(nameOf(form).text, sizeOf(forms_) - 1, nameOfForm());
        }
    }

    /// Reserves the memory that the program needs if each form is called once, which is usually close.
    void reserve() {
        std::size_t members = 0;
        std::size_t senses = 0;
        for (const Form& form : plan_.forms)
            if (const Levels* const levels = levelsIn(form))
                for (const Level& level : *levels)
                    for (const Member& member : level) {
                        ++members;
                        senses += member.trigger.size();
                    }
        program_->places.reserve(2 * members + senses + plan_.forms.size());
        program_->tests.reserve(senses);
        program_->elements.reserve(members);
        program_->acts.reserve(members);
    }

    void addCollection(const Collection& collection) {
        program_->title = collection.name.text;
        program_->real_time = wantsRealTime(collection.kind);
        const Index place = addPlace({.kind = PlaceKind::Collection}, collection.name);
        program_->goal = addTests(collection.goal, place);
        for (const Level& level : collection.levels) {
            const Index number = sizeOf(program_->levels);
            const Index first = sizeOf(program_->drives);
            for (const Member& drive : level)
                addDrive(drive, number);
            program_->levels.push_back({first, sizeOf(program_->drives)});
        }
        std::ranges::reverse(waiting_); // The first drive's form is expanded first
    }

    void addDrive(const Member& drive, Index level) {
        const Index index = sizeOf(program_->drives);
        const Index place =
            addPlace({.kind = PlaceKind::Drive, .parent = 0, .item = index, .position = index}, drive.name);
        ProgramDrive made{.place = place, .level = level, .trigger = addTests(drive.trigger, place)};
        if (drive.frequency && drive.frequency->unit == Unit::Ticks)
            made.interval_cycles = numberOf(drive.frequency->amount.value);
        else if (drive.frequency)
            made.interval_ms = millisecondsOf(*drive.frequency);
        drive_ = index;
        made.target = refer(drive.action, {.place = place, .slot = Slot::Drive, .slot_index = index});
        program_->drives.push_back(std::move(made));
    }

    Index addPlace(const Place& place, const Name& name) {
        std::vector<std::string>& names = program_->names;
        const auto fresh = sizeOf(names);
        const Index number =
            names_.findOrNote(name.text, fresh, [&](Index i) -> const std::string& { return names[i]; });
        if (number == fresh)
            names.push_back(name.text);
        if (program_->places.size() >= most_places)
            fail("the plan has more than " + std::to_string(most_places) + " places when " + name.text + " is expanded",
                 name.at, "Let forms refer to each other less often");
        program_->places.push_back(place);
        program_->places.back().name = number;
        program_->places.back().at = name.at;
        return sizeOf(program_->places) - 1;
    }

    Range addTests(const Senses& senses, Index parent) {
        const Index first = sizeOf(program_->tests);
        for (Index i = 0; i < senses.size(); ++i) {
            const Index test = sizeOf(program_->tests);
            const Place place{.kind = PlaceKind::Sense, .parent = parent, .item = test, .position = i};
            addTest(senses[i], addPlace(place, senses[i].call.name));
        }
        return {first, sizeOf(program_->tests)};
    }

    Index addTest(const SenseTest& test, Index place) {
        ProgramTest made{.place = place, .call = addCall(program_->sense_calls, sense_calls_, test.call)};
        if (test.operand) {
            made.compares = true;
            made.predicate = test.predicate.value_or(Predicate::Equal);
            made.operand = test.operand->value;
        }
        program_->tests.push_back(std::move(made));
        return sizeOf(program_->tests) - 1;
    }

    /// Returns a call as traces print it, or nullopt if a variable has no value. The text is valid until the next call
    /// of this function. Also fills call_values_.
    std::optional<std::string_view> textOf(const Call& call) {
        call_values_.clear();
        if (call.arguments.empty())
            return call.name.text;
        call_text_ = call.name.text;
        for (const Argument& argument : call.arguments) {
            const Value* const value = valueOf(argument, scope_);
            if (!value)
                return std::nullopt;
            call_text_ += call_values_.empty() ? "(" : ", ";
            if (!argument.name.empty())
                call_text_.append("$").append(argument.name).append("=");
            appendValue(call_text_, *value);
            call_values_.push_back(value);
        }
        call_text_ += ')';
        return call_text_;
    }

    /// Returns the index of a call in `calls` and adds it if necessary. Two calls are equal exactly if their texts are.
    /// Most calls of a large plan exist already.
    Index addCall(std::vector<ProgramCall>& calls, NumberTable& known, const Call& call) {
        const auto text = textOf(call);
        if (!text)
            return 0;
        const auto fresh = sizeOf(calls);
        const Index number =
            known.findOrNote(*text, fresh, [&](Index i) -> const std::string& { return calls[i].text; });
        if (number != fresh)
            return number;
        ProgramCall made{.name = call.name.text, .text = std::string(*text), .at = call.name.at};
        for (std::size_t i = 0; i < call_values_.size(); ++i)
            made.arguments.push_back({call.arguments[i].name, *call_values_[i]});
        calls.push_back(std::move(made));
        return fresh;
    }

    const Value* valueOf(const Argument& argument, Index scope) {
        if (const auto* const literal = std::get_if<Literal>(&argument.value))
            return &literal->value;
        const auto& variable = std::get<Variable>(argument.value);
        for (Index at = scope; at != nowhere; at = scopes_[at].outer)
            for (const auto& [name, value] : scopes_[at].values)
                if (name == variable.name)
                    return value;
        fail("$" + variable.name + " has no value here", variable.at,
             "Declare it: vars($" + variable.name + "=…) after the form's name");
        return nullptr;
    }

    Target refer(const Call& call, Waiting waiting) {
        waiting.call = &call;
        waiting.caller = scope_;
        waiting.drive = drive_;
        if (const Index form = form_names_.find(call.name.text, nameOfForm()); form != NumberTable::none) {
            std::tie(waiting.form, waiting.position) = forms_[form];
            waiting_.push_back(waiting);
            return {};
        }
        const Index act = sizeOf(program_->acts);
        const Index place = addPlace(
            {.kind = PlaceKind::Act, .parent = waiting.place, .item = act, .position = waiting.reference}, call.name);
        program_->acts.push_back({place, addCall(program_->act_calls, act_calls_, call), scope_});
        return {true, act};
    }

    /// Binds the parameters of a form to the arguments of its call by position and name, and the rest to their
    /// defaults. Named arguments that the form does not declare are passed down to the forms below.
    Scope scopeOf(const Waiting& waiting) {
        Scope scope{.outer = waiting.caller};
        scope.depth = waiting.caller == nowhere ? 1 : scopes_[waiting.caller].depth + 1;
        const std::vector<Formal>& formals = formalsOf(*waiting.form);
        for (const Formal& formal : formals)
            scope.values.emplace_back(formal.variable.name, &formal.value.value);
        for (std::size_t i = 0; i < waiting.call->arguments.size(); ++i) {
            const Argument& argument = waiting.call->arguments[i];
            const Value* const value = valueOf(argument, waiting.caller);
            if (argument.name.empty()) {
                if (i < formals.size())
                    scope.values[i].second = value;
                continue;
            }
            const auto declared =
                std::ranges::find(scope.values, argument.name, [](const auto& pair) { return pair.first; });
            if (declared != scope.values.end())
                declared->second = value;
            else
                scope.values.emplace_back(argument.name, value);
        }
        return scope;
    }

    void expand(const Waiting& waiting) {
        const Index form = sizeOf(program_->forms);
        scopes_.push_back(scopeOf(waiting));
        if (scopes_.back().depth > forms_.size())
            return fail(waiting.call->name.text + " leads back to itself", waiting.call->name.at,
                        "Break the cycle of references");
        const Target target{false, form};
        if (waiting.slot == Slot::Drive)
            program_->drives[waiting.slot_index].target = target;
        else if (waiting.slot == Slot::Element)
            program_->elements[waiting.slot_index].target = target;
        else
            program_->steps[waiting.slot_index].target = target;
        ProgramDrive& drive = program_->drives[waiting.drive];
        if (waiting.slot == Slot::Drive)
            drive.forms = {form, form};
        drive.forms.end = form + 1;
        drive.depth = std::max(drive.depth, scopes_.back().depth);
        drive_ = waiting.drive;
        scope_ = form;
        constexpr std::array kinds{PlaceKind::Competence, PlaceKind::Pattern, PlaceKind::Adopt};
        const PlaceKind kind = kinds[waiting.form->index()];
        const Place place{.kind = kind,
                          .parent = waiting.place,
                          .item = form,
                          .position = waiting.position,
                          .reference = waiting.reference};
        program_->forms.push_back({.kind = kind,
                                   .place = addPlace(place, nameOf(*waiting.form)),
                                   .parent = waiting.caller,
                                   .below_end = form + 1});
        const std::size_t waiting_before = waiting_.size();
        if (const auto* const competence = std::get_if<Competence>(waiting.form))
            addItems(form, *competence);
        else if (const auto* const pattern = std::get_if<Pattern>(waiting.form))
            addItems(form, *pattern);
        else
            addItems(form, std::get<Adopt>(*waiting.form));
        std::reverse(waiting_.begin() + static_cast<std::ptrdiff_t>(waiting_before), waiting_.end());
    }

    void addItems(Index form, const Competence& competence) {
        const Index place = program_->forms[form].place;
        program_->forms[form].limit_ms = limitOf(competence.time_limit);
        program_->forms[form].goal = addTests(competence.goal, place);
        const Index first = sizeOf(program_->elements);
        for (const Level& level : competence.levels)
            for (const Member& element : level) {
                const Index index = sizeOf(program_->elements);
                const Index own =
                    addPlace({.kind = PlaceKind::Element, .parent = place, .item = index, .position = index - first},
                             element.name);
                const Range trigger = addTests(element.trigger, own);
                const Target target = refer(element.action, {.place = own, .slot = Slot::Element, .slot_index = index});
                program_->elements.push_back({own, trigger, target, retryLimit(element).value_or(0)});
            }
        program_->forms[form].items = {first, sizeOf(program_->elements)};
    }

    void addItems(Index form, const Pattern& pattern) {
        program_->forms[form].limit_ms = limitOf(pattern.time_limit);
        if (pattern.steps.empty())
            fail("the pattern " + pattern.name.text + " has no steps", pattern.name.at, "Write at least one");
        const Index first = sizeOf(program_->steps);
        for (Index i = 0; i < pattern.steps.size(); ++i)
            addStep(form, pattern.steps[i], i);
        program_->forms[form].items = {first, sizeOf(program_->steps)};
    }

    void addItems(Index form, const Adopt& adopt) {
        program_->forms[form].goal = addTests(adopt.goal, program_->forms[form].place);
        const Index first = sizeOf(program_->steps);
        addReference(form, adopt.adopted, 0);
        program_->forms[form].items = {first, first + 1};
    }

    void addStep(Index form, const Step& step, Index position) {
        const auto* const test = std::get_if<SenseTest>(&step);
        if (!test)
            return addReference(form, std::get<Call>(step), position);
        const Place place{.kind = PlaceKind::SenseStep,
                          .parent = program_->forms[form].place,
                          .item = sizeOf(program_->tests),
                          .position = position};
        program_->steps.push_back({addTest(*test, addPlace(place, test->call.name)), {}});
    }

    /// `call` must be part of the plan, because it is used again when its form is expanded.
    void addReference(Index form, const Call& call, Index position) {
        const Index index = sizeOf(program_->steps);
        const Index parent = program_->forms[form].place;
        const Target target =
            refer(call, {.place = parent, .reference = position, .slot = Slot::Step, .slot_index = index});
        program_->steps.push_back({nowhere, target});
    }

    /// Sets below_end of all forms. They are in preorder, so the forms below one follow it directly.
    void finish() {
        for (std::size_t i = program_->forms.size(); i-- > 0;) {
            const ProgramForm& form = program_->forms[i];
            if (form.parent != nowhere)
                program_->forms[form.parent].below_end =
                    std::max(program_->forms[form.parent].below_end, form.below_end);
        }
    }

    const Plan& plan_;
    std::shared_ptr<Program> program_ = std::make_shared<Program>();
    std::vector<std::pair<const Form*, Index>> forms_; ///< each form with its number among the forms of its kind
    NumberTable form_names_;                           ///< indices in forms_; the first of equal names
    NumberTable names_;
    NumberTable sense_calls_;
    NumberTable act_calls_;
    std::vector<Scope> scopes_; ///< indexed by form of the program
    std::vector<Waiting> waiting_;
    std::string call_text_;
    std::vector<const Value*> call_values_;
    Index scope_ = nowhere; ///< form that is being expanded; `nowhere` for the collection
    Index drive_ = 0;
    std::optional<Error> error_; ///< the first one, which stops the builder
};

} // namespace

Result<std::shared_ptr<const Program>> compile(const Plan& plan) {
    return Builder(plan).build();
}

} // namespace usar::posh
