#include "core/agent/posh/posh_binding.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/agent/posh_registry.h"
#include "core/base/spelling.h"
#include "core/base/text.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/model/plan_walk.h"

namespace usar::agent {

using posh::Call;
using posh::Code;

namespace {

constexpr std::size_t most_similar = 3;

/// True for the senses and acts that are built into the engine.
bool isBuiltIn(std::string_view name, PrimitiveKind kind) {
    constexpr std::string_view executor = "cz.cuni.amis.pogamut.sposh.executor.";
    constexpr std::array<std::string_view, 4> senses{"succeed", "true", "fail", "false"};
    if (name.starts_with(executor)) {
        name.remove_prefix(executor.size());
        return kind == PrimitiveKind::Sense ? name == "Succeed" || name == "Fail" : name == "DoNothing";
    }
    return kind == PrimitiveKind::Sense ? std::ranges::find(senses, name) != senses.end() : name == "doNothing";
}

const PrimitiveDescription* find(const std::vector<PrimitiveDescription>& primitives, std::string_view name) {
    const auto found = std::ranges::find(primitives, name, &PrimitiveDescription::name);
    return found == primitives.end() ? nullptr : &*found;
}

class Checker {
public:
    Checker(const posh::Plan& plan, const std::vector<PrimitiveDescription>& primitives)
        : plan_(plan)
        , primitives_(primitives) {}

    posh::Findings check() {
        if (!posh::collectionOf(plan_))
            complain(Code::NoCollection, {},
                     "the plan has no drives and cannot run; add a form such as (DC name (drives …))");
        for (const posh::Form& form : plan_.forms)
            if (!std::holds_alternative<posh::Collection>(form))
                checkName(form);
        for (const posh::Form& form : plan_.forms)
            posh::forEachCall(form, [this](const Call& call, bool is_sense) {
                checkCall(call, is_sense ? PrimitiveKind::Sense : PrimitiveKind::Act);
            });
        std::ranges::stable_sort(findings_, {}, [](const posh::Finding& finding) { return finding.at.offset; });
        return std::move(findings_);
    }

private:
    void checkName(const posh::Form& form) {
        const posh::Name& name = posh::nameOf(form);
        forms_.insert(name.text);
        if (const PrimitiveDescription* const primitive = find(primitives_, name.text))
            complain(Code::PrimitiveNamedAsForm, name.at,
                     name.text + " is " + (primitive->kind == PrimitiveKind::Sense ? "a sense" : "an act") +
                         " of the robot; give this form another name");
    }

    void checkCall(const Call& call, PrimitiveKind kind) {
        const std::string& name = call.name.text;
        const bool wants_sense = kind == PrimitiveKind::Sense;
        if (forms_.contains(name)) {
            if (wants_sense)
                complain(Code::WrongUse, call.name.at,
                         name + " is a form of the plan, and here a sense is asked; name one");
            return;
        }
        const PrimitiveDescription* const primitive = find(primitives_, name);
        if (!primitive && isBuiltIn(name, kind))
            return;
        if (!primitive)
            return complain(Code::UnknownPrimitive, call.name.at,
                            "the robot has no " + std::string(wants_sense ? "sense " : "act ") + posh::inQuotes(name) +
                                "; " + similarTo(name, kind));
        if (primitive->kind != kind)
            return complain(
                Code::WrongUse, call.name.at,
                name +
                    (wants_sense ? " is an act, and here a sense is asked" : " is a sense, and here an act is asked") +
                    "; " + similarTo(name, kind));
        checkArguments(call, *primitive);
    }

    void checkArguments(const Call& call, const PrimitiveDescription& primitive) {
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            const posh::Argument& argument = call.arguments[i];
            const PoshParameter* const parameter = parameterFor(primitive, i, argument.name);
            if (!parameter) {
                complain(Code::WrongUse, call.name.at,
                         primitive.name + " takes " + std::to_string(primitive.parameters.size()) +
                             " arguments and no " +
                             (argument.name.empty() ? std::to_string(i + 1) + ". one" : "$" + argument.name) +
                             "; take it out");
                continue;
            }
            const auto* const literal = std::get_if<posh::Literal>(&argument.value);
            if (!literal)
                continue; // its value is known only when the plan is expanded
            if (const auto value = convertArgument(*parameter, literal->value); !value)
                complain(Code::WrongUse, call.name.at, primitive.name + " " + value.error() + "; write another value");
        }
    }

    /// "did you mean A, B or C?", or advice without names if none is similar.
    std::string similarTo(const std::string& name, PrimitiveKind kind) const {
        std::vector<std::pair<std::size_t, std::string>> near;
        for (const PrimitiveDescription& primitive : primitives_)
            if (primitive.kind == kind)
                near.emplace_back(editDistance(lowerCase(name), lowerCase(primitive.name)), primitive.name);
        std::ranges::sort(near);
        std::erase_if(near,
                      [&name](const auto& pair) { return pair.first > std::max<std::size_t>(3, name.size() / 2); });
        near.resize(std::min(near.size(), most_similar));
        if (near.empty())
            return "write one that it has";
        std::string text = "did you mean ";
        for (std::size_t i = 0; i < near.size(); ++i)
            text += (i == 0 ? "" : i + 1 == near.size() ? " or " : ", ") + near[i].second;
        return text + "?";
    }

    void complain(Code code, const posh::Spot& at, std::string message) {
        findings_.push_back({code, at, std::move(message), {}});
    }

    const posh::Plan& plan_;
    const std::vector<PrimitiveDescription>& primitives_;
    std::set<std::string, std::less<>> forms_;
    posh::Findings findings_;
};

/// Checks the arguments that come from parameters of forms, which are known once the plan is expanded.
void checkExpanded(const std::vector<posh::ProgramCall>& calls, const std::vector<PrimitiveDescription>& primitives,
                   posh::Findings& findings) {
    for (const posh::ProgramCall& call : calls) {
        const PrimitiveDescription* const primitive = find(primitives, call.name);
        if (!primitive)
            continue;
        if (const auto arguments = PoshArguments::make(*primitive, call.arguments); !arguments)
            findings.push_back({Code::WrongUse, call.at, arguments.error() + "; write another value", {}});
    }
}

} // namespace

posh::Findings checkBinding(const posh::Plan& plan, const std::vector<PrimitiveDescription>& primitives) {
    return Checker(plan, primitives).check();
}

PlanForRobot bindPlan(std::string_view text, const std::vector<PrimitiveDescription>& primitives) {
    PlanForRobot made;
    posh::PlanReading reading = posh::readPlan(text);
    made.findings = std::move(reading.findings);
    if (posh::hasErrors(made.findings))
        return made;
    for (posh::Finding& finding : checkBinding(reading.plan, primitives))
        made.findings.push_back(std::move(finding));
    if (posh::hasErrors(made.findings))
        return made;
    auto program = posh::compile(reading.plan);
    if (!program) {
        made.findings.push_back({Code::ReferenceCycle, {}, program.error().text(), {}});
        return made;
    }
    checkExpanded((*program)->sense_calls, primitives, made.findings);
    checkExpanded((*program)->act_calls, primitives, made.findings);
    if (!posh::hasErrors(made.findings))
        made.program = *std::move(program);
    return made;
}

std::string clockRemark(const posh::Plan& plan) {
    const posh::Collection* const collection = posh::collectionOf(plan);
    if (!collection || !posh::wantsRealTime(collection->kind))
        return {};
    return "RDC and SRDC ask for real time; here the plan runs by the robot's clock, and stands still while the "
           "simulator does.";
}

Error planRefusal(const std::string& plan_name, const posh::Findings& findings) {
    std::string list;
    for (const posh::Finding& finding : findings)
        if (posh::severityOf(finding.code) == Severity::Error)
            list += (list.empty() ? "" : "; ") + posh::toText(finding);
    return {"it cannot be used: " + list, "plan " + plan_name, "Fix the plan"};
}

} // namespace usar::agent
