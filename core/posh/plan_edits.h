// Changes to a plan as a person makes them in a drawing of it. Each takes the plan's text and gives another one: the
// text is the only truth, and what was not changed keeps its comments, order and layout.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/posh/plan.h"
#include "core/posh/plan_part.h"

namespace usar::posh {

/// The text afterwards, and what to look at in it. A text that cannot be read is never the outcome: an edit that would
/// bring an error (a circle of references, a parameter that is not declared) fails and says which. The parts are those
/// of the plan read from the given text, which must be readable itself.
struct PlanEdit {
    std::string text;
    PlanPart part;
};

/// A form with every call of it, a drive, an element, or a sense or act of the robot wherever the plan uses it.
Result<PlanEdit> renamePart(std::string_view text, const PlanPart& part, std::string_view name);

/// Two members of one kind, two acts, two senses, two steps or two forms change places.
Result<PlanEdit> swapParts(std::string_view text, const PlanPart& a, const PlanPart& b);

/// Before the level `level` in a level of its own; with `beside`, in that level before its member of that number, so
/// that they are equals. One past the last stands for the end.
struct MemberPlace {
    std::size_t form = 0;
    std::size_t level = 0;
    std::optional<std::size_t> beside = std::nullopt;
};
/// Also into another competence; a drive becomes an element and the other way round. The place counts as if the member
/// still stood where it is.
Result<PlanEdit> moveMember(std::string_view text, const PlanPart& part, const MemberPlace& to);
Result<PlanEdit> moveStep(std::string_view text, const PlanPart& part, std::size_t form, std::size_t index);
/// Earlier (-1) or later (1) by one place: a member out of its level or past the next one, a step, a sense among those
/// of its trigger, a form in the file.
Result<PlanEdit> shiftPart(std::string_view text, const PlanPart& part, int by);
/// A member becomes an equal of those of the level before (-1) or behind (1) its own.
Result<PlanEdit> joinLevel(std::string_view text, const PlanPart& part, int by);

/// Without a name it gets one from what it does.
Result<PlanEdit> addMember(std::string_view text, const MemberPlace& to, const Call& action, const Senses& trigger,
                           std::string name = {});
Result<PlanEdit> addStep(std::string_view text, std::size_t form, std::size_t index, const Step& step);
/// To the trigger of a member or the goal of a form, as its last.
Result<PlanEdit> addSense(std::string_view text, const PlanPart& owner, const SenseTest& test);
enum class FormKind { C, Ap, Ad, Dc };
/// With one element, step or drive that does `content`. Stands before the collection; a collection at the end.
Result<PlanEdit> addForm(std::string_view text, FormKind kind, const std::string& name, const Call& content);
/// Beside itself, under another name.
Result<PlanEdit> duplicatePart(std::string_view text, const PlanPart& part);
/// What a member or an adopt does cannot be absent: it becomes `doNothing`. A form that is still called stays.
Result<PlanEdit> removePart(std::string_view text, const PlanPart& part);

Result<PlanEdit> replaceCall(std::string_view text, const PlanPart& part, const Call& call);
Result<PlanEdit> replaceSense(std::string_view text, const PlanPart& part, const SenseTest& test);
/// The trigger of a member, the goal of a form; none takes it away.
Result<PlanEdit> setSenses(std::string_view text, const PlanPart& owner, const Senses& senses);
/// As typed: retries of an element ("3"), frequency of a drive ("seconds 2"), time of a competence or pattern; nothing
/// takes it away.
Result<PlanEdit> setLimit(std::string_view text, const PlanPart& owner, std::string_view words);
/// The string at the end of a member, competence, pattern or collection; empty takes it away.
Result<PlanEdit> setComment(std::string_view text, const PlanPart& owner, std::string_view words);

/// A call becomes the only content of a new competence, pattern or adopt that is called in its place, with the
/// parameters it needs. Without a name it gets one from the call.
Result<PlanEdit> wrapCall(std::string_view text, const PlanPart& part, FormKind kind, std::string name = {});
/// All steps of a pattern, or all levels of drives or elements, from one part to another become one new pattern or
/// competence that is called in their place. What was taken out keeps its triggers; the new element has none.
Result<PlanEdit> wrapParts(std::string_view text, const PlanPart& first, const PlanPart& last, FormKind kind,
                           std::string name = {});
/// The other way round: the steps of a pattern, or the only thing that a form does, in the place of its call. The form
/// goes when nothing else calls it and nothing is remarked about it.
Result<PlanEdit> inlineCall(std::string_view text, const PlanPart& part);

} // namespace usar::posh
