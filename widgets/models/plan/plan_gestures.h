// Translates gestures in the drawing of a plan into edits of its text, with a description of each edit in words.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include <QString>

#include "core/posh/edit/plan_edits.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// A new part, for example from the palette: a sense with its comparison, or an act, competence, pattern or adopt with
/// its arguments.
struct PlanPiece {
    bool is_sense = false;
    QString words; ///< as a plan writes it: "Distance 0.3 <", "DriveTo(2.5)"
    bool operator==(const PlanPiece&) const = default;
};

/// The part of the target card on which something is dropped: upper part, middle, lower part.
enum class DropZone { Before, Onto, After };

/// A possible edit, and its description: "Put wave before safe".
struct PlanDeed {
    QString words;
    /// Makes the edit when called; it works on the text of the moment when it was offered.
    std::function<Result<posh::PlanEdit>()> edit;
};

/// The part of the plan that a node of its drawing stands for; nullopt for the common root of several forms.
std::optional<posh::PlanPart> partOfNode(const posh::Plan& plan, const PlanTree& tree, PlanNodeId node);
/// The call that leads to the node: the call of an act, or the call of a form at this place.
std::optional<posh::PlanPart> callOfNode(const posh::Plan& plan, const PlanTree& tree, PlanNodeId node);
/// The node that draws a part; none if it is not drawn. Prefers the full drawing over links.
PlanNodeId nodeOfPart(const posh::Plan& plan, const PlanTree& tree, const posh::PlanPart& part);

/// Refers to text, plan and drawing of one moment, which must outlive it. A new drive or element gets a trigger that
/// never holds, unless it is placed last, so that it does not preempt the parts after it before the user has written
/// its trigger.
class PlanGestures {
public:
    PlanGestures(const std::string& text, const posh::Plan& plan, const PlanTree& tree)
        : text_(text)
        , plan_(plan)
        , tree_(tree) {}

    /// The edit that dropping `source`, a piece or a node, on a zone of `target` would make; nullopt if
    /// there is none.
    std::optional<PlanDeed> drop(const std::variant<PlanPiece, PlanNodeId>& source, PlanNodeId target,
                                 DropZone zone) const;
    /// The edit that adds a piece without naming a place: at the selected node, or at the end of the drives if there is
    /// none.
    std::optional<PlanDeed> add(const PlanPiece& piece, PlanNodeId selected) const;

private:
    struct Dragged;
    struct Target;
    /// The sense, member or call that is dragged; nullopt if it cannot be.
    std::optional<Dragged> dragged(const std::variant<PlanPiece, PlanNodeId>& source) const;
    /// The target with the part that it draws.
    Target targetAt(PlanNodeId node, DropZone zone) const;
    /// The following return the edit for a sense, a member or a call; nullopt if the drop means nothing.
    std::optional<PlanDeed> dropSense(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropMember(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropCall(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropOnStep(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> putInto(const Dragged& what, std::size_t form) const;
    /// Place for a new or moved member before or after the target.
    posh::MemberPlace placeAt(const Target& to) const;
    /// Place at the end of a form that has levels.
    posh::MemberPlace endOf(std::size_t form) const;
    /// Trigger for a new member at this place.
    posh::Senses firstTrigger(const posh::MemberPlace& place) const;
    PlanDeed swap(const Dragged& what, const posh::PlanPart& with) const;

    const std::string& text_;
    const posh::Plan& plan_;
    const PlanTree& tree_;
};

} // namespace usar::widgets
