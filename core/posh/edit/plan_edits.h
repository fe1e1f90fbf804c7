// Edits of a plan as a user makes them in its drawing. Each takes the plan's text and returns a new text, because the
// text is the only source of truth. Parts that are not edited keep their comments, order and layout.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/posh/edit/plan_part.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// The result of an edit. The text given to an edit must be readable, and its parts are those of the plan read from it.
/// An edit that would introduce an error (such as a reference cycle or an undeclared parameter) fails and names the
/// error.
struct PlanEdit {
    std::string text;
    PlanPart part; ///< the part to select in the new text
};

/// Renames a form together with all its calls, a drive, an element, or a sense or act of the robot everywhere in the
/// plan.
Result<PlanEdit> renamePart(std::string_view text, const PlanPart& part, std::string_view name);

/// Swaps two drives, two elements, two acts, two senses, two steps or two forms.
Result<PlanEdit> swapParts(std::string_view text, const PlanPart& a, const PlanPart& b);

/// A place for a drive or an element. Without `beside` it is a new level before level `level`; with `beside` it is in
/// that level, before the member with that index. Anything past the last index means the end.
struct MemberPlace {
    std::size_t form = 0;
    std::size_t level = 0;
    std::optional<std::size_t> beside = std::nullopt;
};
/// Moves a drive or an element, possibly into another form; a drive becomes an element there and vice versa. The
/// indices of the place are those before the move.
Result<PlanEdit> moveMember(std::string_view text, const PlanPart& part, const MemberPlace& to);
/// Moves a step before the step `index` of the pattern `form`; both are indices before the move.
Result<PlanEdit> moveStep(std::string_view text, const PlanPart& part, std::size_t form, std::size_t index);
/// Moves a part one place earlier (-1) or later (1): a member out of its level or past the next level, a step within
/// its pattern, a sense within its trigger or goal, a form within the file.
Result<PlanEdit> shiftPart(std::string_view text, const PlanPart& part, int by);
/// Moves a member into the level before (-1) or after (1) its own, so that it has the same priority.
Result<PlanEdit> joinLevel(std::string_view text, const PlanPart& part, int by);

/// Adds a drive or an element. An empty name is replaced by the name of the action; a name in use gets a number.
Result<PlanEdit> addMember(std::string_view text, const MemberPlace& to, const Call& action, const Senses& trigger,
                           std::string name = {});
/// Adds a step before the step `index` of the pattern `form`, or at the end if there is none.
Result<PlanEdit> addStep(std::string_view text, std::size_t form, std::size_t index, const Step& step);
/// Adds a sense at the end of a member's trigger or a form's goal.
Result<PlanEdit> addSense(std::string_view text, const PlanPart& owner, const SenseTest& test);
/// The kinds of forms, named by their keywords.
enum class FormKind { C, Ap, Ad, Dc };
/// Adds a form with one element, step or drive that does `content`. A collection goes to the end, another form before
/// the collection.
Result<PlanEdit> addForm(std::string_view text, FormKind kind, const std::string& name, const Call& content);
/// Copies a form, a member or a step next to the original; a form or a member gets a new name.
Result<PlanEdit> duplicatePart(std::string_view text, const PlanPart& part);
/// Removes a part. The action of a member or an adopt becomes `doNothing` instead, because it cannot be absent. Fails
/// for a form that is still called, the last drive of the plan and the last step of a pattern.
Result<PlanEdit> removePart(std::string_view text, const PlanPart& part);

Result<PlanEdit> replaceCall(std::string_view text, const PlanPart& part, const Call& call);
Result<PlanEdit> replaceSense(std::string_view text, const PlanPart& part, const SenseTest& test);
/// Replaces the trigger of a member or the goal of a form; an empty list removes it.
Result<PlanEdit> setSenses(std::string_view text, const PlanPart& owner, const Senses& senses);
/// Sets the retries of an element ("3"), the frequency of a drive ("seconds 2") or the time limit of a competence or
/// pattern, as the user typed it; an empty text removes it.
Result<PlanEdit> setLimit(std::string_view text, const PlanPart& owner, std::string_view words);
/// Sets the comment string of a member, competence, pattern or collection; an empty text removes it.
Result<PlanEdit> setComment(std::string_view text, const PlanPart& owner, std::string_view words);

/// Moves a call into a new competence, pattern or adopt and calls that instead, with the parameters that it needs. An
/// empty name is replaced by one made from the call.
Result<PlanEdit> wrapCall(std::string_view text, const PlanPart& part, FormKind kind, std::string name = {});
/// Moves the steps of a pattern, or the levels of drives or elements, from one part to another into a new pattern or
/// competence and calls that instead. The moved members keep their triggers; the new member that calls the form has
/// none.
Result<PlanEdit> wrapParts(std::string_view text, const PlanPart& first, const PlanPart& last, FormKind kind,
                           std::string name = {});
/// The reverse of wrapping: replaces the call of a form by the steps of the pattern or by the only thing that the form
/// does. Removes the form if nothing else calls it and it has no comments.
Result<PlanEdit> inlineCall(std::string_view text, const PlanPart& part);

} // namespace usar::posh
