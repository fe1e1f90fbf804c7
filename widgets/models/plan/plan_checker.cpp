#include "widgets/models/plan/plan_checker.h"

#include <utility>

#include "core/agent/posh/posh_binding.h"

namespace usar::widgets {

void PlanChecker::setPrimitives(const std::vector<agent::PrimitiveDescription>& primitives) {
    primitives_ = primitives;
    vocabulary_ = {};
    for (const agent::PrimitiveDescription& primitive : primitives)
        (primitive.kind == agent::PrimitiveKind::Sense ? vocabulary_.senses : vocabulary_.acts)
            .push_back(primitive.name);
    vocabulary_.senses.insert(vocabulary_.senses.end(), {"succeed", "fail"});
    vocabulary_.acts.emplace_back("doNothing");
    invalidate();
}

void PlanChecker::check(std::string_view text) {
    if (is_current_)
        return;
    posh::PlanReading reading = read(text);
    findings_ = std::move(reading.findings);
    plan_ = std::move(reading.plan);
    is_current_ = true;
}

std::vector<posh::QuickFix> PlanChecker::fixes(std::string_view text, const posh::Finding& finding) const {
    return posh::quickFixes(text, finding, vocabulary_, [this](auto other) { return read(other).findings; });
}

posh::PlanReading PlanChecker::read(std::string_view text) const {
    posh::PlanReading reading = posh::readPlan(text);
    if (!binds() || !isReadable(reading.findings))
        return reading;
    if (!posh::hasErrors(reading.findings)) {
        reading.findings = agent::bindPlan(text, primitives_).findings;
        return reading;
    }
    const posh::Findings bound = agent::checkBinding(reading.plan, primitives_);
    reading.findings.insert(reading.findings.end(), bound.begin(), bound.end());
    return reading;
}

} // namespace usar::widgets
