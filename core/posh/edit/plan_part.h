// Addresses of the parts of a plan by their place in its structure, as used by edits, the text cursor and the drawing.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/posh/model/plan.h"

namespace usar::posh {

enum class PartKind {
    Whole,  ///< a competence, pattern, adopt or collection
    Member, ///< a drive or an element
    Action, ///< the call of a member, of an adopt, or of a step of a pattern
    Sense,  ///< a sense of a goal or a trigger, or as a step of a pattern
};

/// The address of a part. The indices belong to the plan in which the part was found and have no meaning in another
/// plan.
struct PlanPart {
    PartKind kind = PartKind::Whole;
    std::size_t form = 0;   ///< index in Plan::forms
    std::size_t level = 0;  ///< level of a member; 0 for parts that are not in a member
    std::size_t member = 0; ///< index in its level; 0 for parts that are not in a member
    std::size_t index = 0;  ///< index of a sense in its goal or trigger, or of a step in its pattern
    bool in_member = false; ///< whether an Action or Sense belongs to a member and not directly to the form
    bool operator==(const PlanPart&) const = default;
};

inline PlanPart formPart(std::size_t form) {
    return {PartKind::Whole, form};
}
inline PlanPart memberPart(std::size_t form, std::size_t level, std::size_t member) {
    return {PartKind::Member, form, level, member};
}
/// The call of a member.
inline PlanPart actionPart(std::size_t form, std::size_t level, std::size_t member) {
    return {PartKind::Action, form, level, member, 0, true};
}
/// Returns the member that contains the call or sense, otherwise the form.
PlanPart ownerOf(const PlanPart& part);

/// A part with its name. The pointers point into the plan.
struct NamedPart {
    PlanPart part;
    const Name* name = nullptr;  ///< never nullptr
    const Spot* whole = nullptr; ///< the extent of a form or member; nullptr for other parts
};

/// Returns all parts; a form or member precedes the parts inside it.
std::vector<NamedPart> partsOf(const Plan& plan);

/// Returns the part whose name is at this byte of the text, otherwise the innermost form or member around it; nullopt
/// outside of all forms.
std::optional<PlanPart> partAt(const Plan& plan, std::size_t offset);

/// Returns the member that a Member, or an Action or a Sense in a member, is or belongs to; nullptr for other parts.
const Member* memberOf(const Plan& plan, const PlanPart& part);
/// The name of a part; nullptr if the plan has no such part.
const Name* nameOf(const Plan& plan, const PlanPart& part);
/// The call of an Action or a Sense; nullptr for other parts.
const Call* callOf(const Plan& plan, const PlanPart& part);
/// The test of a Sense; nullptr for other parts.
const SenseTest* senseOf(const Plan& plan, const PlanPart& part);
/// Returns whether the part is a step of a pattern.
bool isStep(const Plan& plan, const PlanPart& part);

/// Returns all parts with the same meaning, in the order of the text. For a form or a call of it, they are the form and
/// all its calls; for a sense or act of the robot, all its uses. A member and the collection have only themselves.
std::vector<PlanPart> usagesOf(const Plan& plan, const PlanPart& part);

/// Returns `wanted`, with a number appended if a form of the plan or a sense or act that it calls already has that
/// name.
std::string freeFormName(const Plan& plan, const std::string& wanted);
/// Returns `wanted`, with a number appended if a drive or element of the form already has that name.
std::string freeMemberName(const Form& form, const std::string& wanted);

/// Returns the word for the kind of a form, with a blank after it: "competence ", "collection ".
std::string kindWord(const Form& form);
/// Describes a part for messages: `the drive "safety"`, `the sense "Bumped"`.
std::string describe(const Plan& plan, const PlanPart& part);

} // namespace usar::posh
