// A part of a plan by its place in the plan's structure: what edits change, and what a cursor or a drawing points at.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/posh/plan.h"

namespace usar::posh {

enum class PartKind {
    Whole,  ///< a competence, pattern, adopt or collection
    Member, ///< a drive or an element
    Action, ///< what a member does, a step of a pattern that is no sense, or what is adopted
    Sense,  ///< of a goal or a trigger, or a step
};

/// Indices are those of the plan it was found in and mean nothing in another one.
struct PlanPart {
    PartKind kind = PartKind::Whole;
    std::size_t form = 0;  ///< in Plan::forms
    std::size_t level = 0; ///< of a member and of what stands in one
    std::size_t member = 0;
    std::size_t index = 0;  ///< of a sense in its goal or trigger; of a step in its pattern
    bool in_member = false; ///< a call or sense of a drive or element, else of its form
    bool operator==(const PlanPart&) const = default;
};

inline PlanPart formPart(std::size_t form) {
    return {PartKind::Whole, form};
}
inline PlanPart memberPart(std::size_t form, std::size_t level, std::size_t member) {
    return {PartKind::Member, form, level, member};
}
/// What a member does.
inline PlanPart actionPart(std::size_t form, std::size_t level, std::size_t member) {
    return {PartKind::Action, form, level, member, 0, true};
}
/// The form or, for what stands in a member, the member.
PlanPart ownerOf(const PlanPart& part);

struct NamedPart {
    PlanPart part;
    const Name* name = nullptr;  ///< of the plan
    const Spot* whole = nullptr; ///< of a form or member; nullptr for others
};

/// All parts, each before what stands in it.
std::vector<NamedPart> partsOf(const Plan& plan);

/// What has its name at this byte of the text, else the innermost form or member around it.
std::optional<PlanPart> partAt(const Plan& plan, std::size_t offset);

/// nullptr where the plan has no such part.
const Name* nameOf(const Plan& plan, const PlanPart& part);
/// Of a call or a sense.
const Call* callOf(const Plan& plan, const PlanPart& part);
const SenseTest* senseOf(const Plan& plan, const PlanPart& part);
/// The part is a step of a pattern.
bool isStep(const Plan& plan, const PlanPart& part);

/// All parts with the same meaning: of a form (or a call of one) the form and every call of it, of a primitive each of
/// its uses in the same kind; of a member and of the collection only themselves. In the order of the text.
std::vector<PlanPart> usagesOf(const Plan& plan, const PlanPart& part);

/// A name beginning with `wanted` that no form of the plan, and no act that it calls, has yet.
std::string freeFormName(const Plan& plan, const std::string& wanted);
/// … that no drive or element of the form has yet.
std::string freeMemberName(const Form& form, const std::string& wanted);

/// "the drive safety", "the sense Bumped": for messages.
std::string describe(const Plan& plan, const PlanPart& part);

} // namespace usar::posh
