#include "random_plan.h"

#include <array>
#include <string>
#include <vector>

#include "core/posh/model/literal.h"

namespace doubles {

using namespace usar;
using namespace usar::posh;

namespace {

struct Spelling {
    Value value;
    const char* text;
};

class Maker {
public:
    Maker(Random& random, const RandomPlanOptions& options) : random_(&random), options_(options) {}

    Plan run() {
        const std::size_t forms = upTo(options_.most_forms);
        for (std::size_t i = 0; i < forms; ++i)
            announce(i);
        const std::size_t collection_at = upTo(forms);
        Plan plan;
        if (options_.with_decoration)
            decorate(plan);
        for (std::size_t i = 0; i <= forms; ++i) {
            if (i == collection_at && options_.with_collection)
                plan.forms.emplace_back(collection());
            if (i < forms)
                plan.forms.emplace_back(form(i));
        }
        return plan;
    }

private:
    enum class Kind { Competence, Pattern, Adopt };
    struct Announced {
        Kind kind = Kind::Competence;
        std::string name;
        std::vector<std::string> formals;
    };

    std::size_t upTo(std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(*random_); }
    bool chance(double share) { return std::bernoulli_distribution(share)(*random_); }
    bool decorates(double share) { return options_.with_decoration && chance(share); }
    template <std::size_t n>
    const char* oneOf(const std::array<const char*, n>& words) {
        return words[upTo(n - 1)];
    }

    void announce(std::size_t i) {
        Announced form;
        form.kind = static_cast<Kind>(upTo(options_.with_adopts ? 2 : 1));
        form.name = std::string(1, "cpd"[static_cast<std::size_t>(form.kind)]) + std::to_string(i);
        if (options_.with_parameters && chance(0.4))
            for (std::size_t n = upTo(2) + 1; n > 0; --n)
                form.formals.push_back("x" + std::to_string(form.formals.size()));
        forms_.push_back(std::move(form));
    }

    static Literal literal(Value value) {
        std::string spelling = spelled(value);
        return {std::move(value), std::move(spelling), {}};
    }
    Literal spelledOddly() {
        static const std::array<Spelling, 14> odd{{{std::int64_t{7}, "+7"},
                                                   {std::int64_t{0}, "-0"},
                                                   {5.0, "5."},
                                                   {0.25, ".25"},
                                                   {1200.0, "12E+2"},
                                                   {1.5, "1.500"},
                                                   {true, "TRUE"},
                                                   {Value(), "Nil"},
                                                   {std::string("a\tb\"c\\"), R"("a\tb\"c\\")"},
                                                   {std::string("A\xC3\xA9"), R"("\u0041\351")"},
                                                   {std::string("two\nlines"), "\"two\nlines\""},
                                                   {std::string("; no comment ("), "\"; no comment (\""},
                                                   {Symbol{"colors.RED"}, "'colors.RED"},
                                                   {Symbol{"half-open"}, "'half-open"}}};
        const Spelling& spelling = odd[upTo(odd.size() - 1)];
        return {spelling.value, spelling.text, {}};
    }
    Literal value() {
        if (decorates(0.3))
            return spelledOddly();
        switch (upTo(5)) {
        case 0:
            return literal(Value());
        case 1:
            return literal(chance(0.5));
        case 2:
            return literal(static_cast<std::int64_t>(upTo(3)));
        case 3:
            return literal(static_cast<double>(upTo(6)) / 2.0);
        case 4:
            return literal(std::string(oneOf<3>({"", "near", "far"})));
        default:
            return literal(Symbol{oneOf<2>({"near", "far"})});
        }
    }
    Literal wholeNumber(std::size_t most) { return literal(static_cast<std::int64_t>(upTo(most))); }

    std::optional<Literal> comment() {
        return decorates(0.2) ? std::optional(literal(std::string("why (not)"))) : std::nullopt;
    }
    Remarks remarks() {
        Remarks made;
        if (decorates(0.2))
            made.above.emplace_back();
        if (decorates(0.2))
            made.above.emplace_back("; \xC3\xA4 line with ) and \" of its own");
        if (decorates(0.2))
            made.beside = "# beside (it";
        return made;
    }
    std::string memberName(std::size_t n) {
        if (decorates(0.1))
            return oneOf<6>({"nil", "trigger", "goal", "3rd", "with.dots", "seconds"});
        return "n" + std::to_string(n);
    }

    std::vector<Argument> arguments(const Announced* callee, const Announced* caller) {
        std::vector<Argument> made;
        if (!options_.with_parameters || !chance(callee ? 0.6 : 0.2))
            return made;
        const std::size_t most = callee ? callee->formals.size() : 2;
        bool named = false;
        for (std::size_t i = 0; i < most; ++i) {
            Argument& argument = made.emplace_back();
            named = named || chance(0.4);
            if (named)
                argument.name = "x" + std::to_string(i);
            if (caller && !caller->formals.empty() && chance(0.4))
                argument.value = Variable{caller->formals[upTo(caller->formals.size() - 1)], {}};
            else
                argument.value = value();
        }
        return made;
    }
    /// An action, or a form behind the `after`-th.
    Call call(std::size_t after, const Announced* caller) {
        if (after < forms_.size() && chance(0.5)) {
            const Announced& callee = forms_[after + upTo(forms_.size() - after - 1)];
            return {{callee.name, {}}, arguments(&callee, caller)};
        }
        std::string name = decorates(0.1) ? oneOf<3>({"ns.act", "hz", "true-act"})
                                          : "a" + std::to_string(upTo(options_.action_names - 1));
        return {{std::move(name), {}}, arguments(nullptr, caller)};
    }
    SenseTest test(const Announced* caller) {
        SenseTest made;
        made.call = {{"s" + std::to_string(upTo(options_.sense_names - 1)), {}}, arguments(nullptr, caller)};
        if (!chance(0.5))
            return made;
        made.operand = decorates(0.2) ? Literal{Symbol{"red"}, "red", {}} : value();
        if (chance(0.8))
            made.predicate = static_cast<Predicate>(upTo(5));
        return made;
    }
    Senses senses(const Announced* caller) {
        Senses made;
        for (std::size_t n = upTo(options_.most_senses); n > 0; --n)
            made.push_back(test(caller));
        return made;
    }
    std::optional<Interval> interval(bool rates, double share) {
        if (!options_.with_limits || !chance(share))
            return std::nullopt;
        Interval made;
        made.unit = rates ? static_cast<Unit>(upTo(6)) : chance(0.8) ? Unit::Seconds : Unit::None;
        made.amount = literal(static_cast<double>(upTo(4)) * 0.2 + 0.2);
        return made;
    }

    std::vector<Formal> formals(const Announced& form) {
        std::vector<Formal> made;
        for (const std::string& name : form.formals)
            made.push_back({{name, {}}, value()});
        return made;
    }
    template <class Make>
    Levels levels(Make make) {
        Levels made(upTo(options_.most_levels - 1) + 1);
        std::size_t n = 0;
        for (Level& level : made)
            for (std::size_t members = upTo(options_.most_members - 1) + 1; members > 0; --members)
                level.push_back(make(n++));
        return made;
    }
    Member element(std::size_t n, std::size_t after, const Announced& self) {
        Member made{{memberName(n)}, senses(&self), call(after, &self), {}, {}, comment(), remarks()};
        if (options_.with_limits && chance(0.3))
            made.retries = wholeNumber(3);
        return made;
    }
    Member drive(std::size_t n) {
        return {{memberName(n)}, senses(nullptr), call(0, nullptr), interval(true, 0.3), {}, comment(), remarks()};
    }
    Pattern pattern(const Announced& self, std::size_t after) {
        Pattern made{{self.name, {}}, formals(self), interval(false, 0.3), {}, comment(), remarks(), {}};
        for (std::size_t n = upTo(options_.most_steps - 1) + 1; n > 0; --n) {
            if (chance(0.2))
                made.steps.emplace_back(test(&self));
            else
                made.steps.emplace_back(call(after, &self));
        }
        return made;
    }
    Form form(std::size_t i) {
        const Announced& self = forms_[i];
        if (self.kind == Kind::Pattern)
            return pattern(self, i + 1);
        if (self.kind == Kind::Adopt)
            return Adopt{{self.name, {}}, formals(self), senses(&self), call(i + 1, &self), remarks(), {}};
        return Competence{{self.name, {}},
                          formals(self),
                          interval(false, 0.3),
                          senses(&self),
                          levels([&](std::size_t n) { return element(n, i + 1, self); }),
                          comment(),
                          remarks(),
                          {}};
    }
    Collection collection() {
        Collection made;
        made.kind = static_cast<CollectionKind>(upTo(3));
        made.keyword = std::array{"DC", "rdc", "Sdc", "SRDC"}[static_cast<std::size_t>(made.kind)];
        made.name = {"life", {}};
        if (chance(0.5))
            made.goal = senses(nullptr);
        made.levels = levels([&](std::size_t n) { return drive(n); });
        made.comment = comment();
        made.remarks = remarks();
        return made;
    }
    void decorate(Plan& plan) {
        plan.remarks = remarks();
        if (chance(0.5))
            plan.documentation = Documentation{
                literal(std::string("title")), spelledText(), literal(std::string("text")), remarks(), {}};
        if (chance(0.3))
            plan.closing_remarks = {"; the end"};
    }
    Literal spelledText() { return {std::string("it's"), R"("it\'s")", {}}; }

    Random* random_;
    RandomPlanOptions options_;
    std::vector<Announced> forms_;
};

} // namespace

Plan randomPlan(Random& random, const RandomPlanOptions& options) {
    return Maker(random, options).run();
}

} // namespace doubles
