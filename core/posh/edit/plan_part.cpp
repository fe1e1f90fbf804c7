#include "core/posh/edit/plan_part.h"

#include <array>
#include <unordered_set>

#include "core/posh/language/form_index.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

bool holds(const Spot& spot, std::size_t offset) {
    return spot.line > 0 && spot.offset <= offset && offset <= spot.end();
}

class Lister {
public:
    std::vector<NamedPart> run(const Plan& plan) {
        for (form_ = 0; form_ < plan.forms.size(); ++form_)
            std::visit([this](const auto& any) { list(any); }, plan.forms[form_]);
        return std::move(found_);
    }

private:
    template <class Any>
    void list(const Any& form) {
        found_.push_back({formPart(form_), &form.name, &form.at});
        if constexpr (requires { form.goal; })
            senses(form.goal, {PartKind::Sense, form_});
        if constexpr (requires { form.levels; })
            members(form.levels);
        if constexpr (requires { form.adopted; })
            found_.push_back({{PartKind::Action, form_}, &form.adopted.name});
        if constexpr (requires { form.steps; })
            for (std::size_t i = 0; i < form.steps.size(); ++i) {
                const auto* const test = std::get_if<SenseTest>(&form.steps[i]);
                const Call& call = test ? test->call : std::get<Call>(form.steps[i]);
                found_.push_back({{test ? PartKind::Sense : PartKind::Action, form_, 0, 0, i}, &call.name});
            }
    }

    void members(const Levels& levels) {
        for (std::size_t level = 0; level < levels.size(); ++level)
            for (std::size_t i = 0; i < levels[level].size(); ++i) {
                const Member& member = levels[level][i];
                found_.push_back({memberPart(form_, level, i), &member.name, &member.at});
                senses(member.trigger, {PartKind::Sense, form_, level, i, 0, true});
                found_.push_back({actionPart(form_, level, i), &member.action.name});
            }
    }

    void senses(const Senses& tests, PlanPart part) {
        for (part.index = 0; part.index < tests.size(); ++part.index)
            found_.push_back({part, &tests[part.index].call.name});
    }

    std::vector<NamedPart> found_;
    std::size_t form_ = 0;
};

const SenseTest* at(const Senses& senses, std::size_t index) {
    return index < senses.size() ? &senses[index] : nullptr;
}

std::string freeName(const std::string& wanted, const std::unordered_set<std::string_view>& taken) {
    std::string name = wanted;
    for (int number = 2; taken.contains(name); ++number)
        name = wanted + '-' + std::to_string(number);
    return name;
}

} // namespace

PlanPart ownerOf(const PlanPart& part) {
    return part.in_member ? memberPart(part.form, part.level, part.member) : formPart(part.form);
}

std::vector<NamedPart> partsOf(const Plan& plan) {
    return Lister().run(plan);
}

std::optional<PlanPart> partAt(const Plan& plan, std::size_t offset) {
    std::optional<PlanPart> around;
    for (const NamedPart& candidate : partsOf(plan)) {
        if (holds(candidate.name->at, offset))
            return candidate.part;
        if (candidate.whole && holds(*candidate.whole, offset))
            around = candidate.part; // A member comes after its form, so the innermost part is last
    }
    return around;
}

const Member* memberOf(const Plan& plan, const PlanPart& part) {
    const bool is_member = part.kind == PartKind::Member || part.in_member;
    const Levels* const levels = is_member && part.form < plan.forms.size() ? levelsIn(plan.forms[part.form]) : nullptr;
    const bool exists = levels && part.level < levels->size() && part.member < (*levels)[part.level].size();
    return exists ? &(*levels)[part.level][part.member] : nullptr;
}

const SenseTest* senseOf(const Plan& plan, const PlanPart& part) {
    if (part.kind != PartKind::Sense || part.form >= plan.forms.size())
        return nullptr;
    if (part.in_member) {
        const Member* const member = memberOf(plan, part);
        return member ? at(member->trigger, part.index) : nullptr;
    }
    return std::visit(
        [&](const auto& form) -> const SenseTest* {
            if constexpr (requires { form.goal; })
                return at(form.goal, part.index);
            else
                return part.index < form.steps.size() ? std::get_if<SenseTest>(&form.steps[part.index]) : nullptr;
        },
        plan.forms[part.form]);
}

const Call* callOf(const Plan& plan, const PlanPart& part) {
    if (const SenseTest* const test = senseOf(plan, part))
        return &test->call;
    if (part.kind != PartKind::Action || part.form >= plan.forms.size())
        return nullptr;
    if (part.in_member) {
        const Member* const member = memberOf(plan, part);
        return member ? &member->action : nullptr;
    }
    if (const auto* const adopt = std::get_if<Adopt>(&plan.forms[part.form]))
        return &adopt->adopted;
    const auto* const pattern = std::get_if<Pattern>(&plan.forms[part.form]);
    return pattern && part.index < pattern->steps.size() ? std::get_if<Call>(&pattern->steps[part.index]) : nullptr;
}

const Name* nameOf(const Plan& plan, const PlanPart& part) {
    if (part.form >= plan.forms.size())
        return nullptr;
    if (part.kind == PartKind::Whole)
        return &nameOf(plan.forms[part.form]);
    if (part.kind == PartKind::Member) {
        const Member* const member = memberOf(plan, part);
        return member ? &member->name : nullptr;
    }
    const Call* const call = callOf(plan, part);
    return call ? &call->name : nullptr;
}

bool isStep(const Plan& plan, const PlanPart& part) {
    return callOf(plan, part) && !part.in_member && std::holds_alternative<Pattern>(plan.forms[part.form]);
}

std::vector<PlanPart> usagesOf(const Plan& plan, const PlanPart& part) {
    const Name* const name = nameOf(plan, part);
    if (!name)
        return {};
    const FormIndex index(plan);
    const std::optional<std::size_t> form = part.kind == PartKind::Whole    ? part.form
                                            : part.kind == PartKind::Action ? index.find(name->text)
                                                                            : std::nullopt;
    const bool is_called = form && index.find(name->text) == form;
    if (part.kind == PartKind::Member || (form && !is_called))
        return {part};
    std::vector<PlanPart> found;
    for (const NamedPart& candidate : partsOf(plan)) {
        const bool is_the_form = form && candidate.part == formPart(*form);
        const PartKind wanted = part.kind == PartKind::Sense ? PartKind::Sense : PartKind::Action;
        if (is_the_form || (candidate.part.kind == wanted && candidate.name->text == name->text))
            found.push_back(candidate.part);
    }
    return found;
}

std::string freeFormName(const Plan& plan, const std::string& wanted) {
    std::unordered_set<std::string_view> taken;
    for (const Form& form : plan.forms) {
        taken.insert(nameOf(form).text);
        forEachCall(form, [&taken](const Call& call, bool) { taken.insert(call.name.text); });
    }
    return freeName(wanted, taken);
}

std::string freeMemberName(const Form& form, const std::string& wanted) {
    std::unordered_set<std::string_view> taken;
    if (const Levels* const levels = levelsIn(form))
        for (const Level& level : *levels)
            for (const Member& member : level)
                taken.insert(member.name.text);
    return freeName(wanted, taken);
}

std::string kindWord(const Form& form) {
    constexpr std::array words{"competence ", "pattern ", "adopt ", "collection "};
    return words[form.index()];
}

std::string describe(const Plan& plan, const PlanPart& part) {
    const Name* const name = nameOf(plan, part);
    if (!name)
        return "a part that the plan does not have";
    const Form& form = plan.forms[part.form];
    const std::string what = part.kind == PartKind::Whole               ? kindWord(form)
                             : part.kind == PartKind::Sense             ? "sense "
                             : part.kind == PartKind::Action            ? "act "
                             : std::holds_alternative<Collection>(form) ? "drive "
                                                                        : "element ";
    return "the " + what + inQuotes(name->text);
}

} // namespace usar::posh
