// What a gesture in the drawing of a plan means: which edit of the text it is, and how one says it beforehand.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>

#include <QString>

#include "core/posh/plan_edits.h"
#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// Something new, as from a palette: a sense with its value, or an act, competence, pattern or adopt with its
/// arguments.
struct PlanPiece {
    bool is_sense = false;
    QString words; ///< as in a plan: "Distance 0.3 <", "DriveTo(2.5)"
    bool operator==(const PlanPiece&) const = default;
};

/// Where on a card something is let go: its upper part, its middle, its lower part.
enum class DropZone { Before, Onto, After };

/// An edit that can be made, and the words for it: "Put wave before safe".
struct PlanDeed {
    QString words;
    std::function<Result<posh::PlanEdit>()> edit;
};

/// The part of the plan that a node of its drawing stands for; nothing for the root of several.
std::optional<posh::PlanPart> partOfNode(const posh::Plan& plan, const PlanTree& tree, int node);
/// The call that leads to it: of an act, or of a form where it is called.
std::optional<posh::PlanPart> callOfNode(const posh::Plan& plan, const PlanTree& tree, int node);
/// Where a part is drawn; -1 where it is not.
int nodeOfPart(const posh::Plan& plan, const PlanTree& tree, const posh::PlanPart& part);

/// Text, plan and drawing of one moment; they must outlive it. What is new gets a trigger that never holds unless it is
/// the last, so that it takes nothing away from what stands behind it before a person has said when it is to run.
class PlanGestures {
public:
    PlanGestures(const std::string& text, const posh::Plan& plan, const PlanTree& tree)
        : text_(text)
        , plan_(plan)
        , tree_(tree) {}

    /// `source` is a piece or a node of the drawing. Nothing where this means nothing.
    std::optional<PlanDeed> drop(const std::variant<PlanPiece, int>& source, int target, DropZone zone) const;
    /// Without a place: at the selected node, or where there is none (-1) at the end of the drives.
    std::optional<PlanDeed> add(const PlanPiece& piece, int selected) const;

private:
    struct Dragged;
    struct Target;
    std::optional<Dragged> dragged(const std::variant<PlanPiece, int>& source) const;
    Target targetAt(int node, DropZone zone) const;
    std::optional<PlanDeed> dropSense(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropMember(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropCall(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> dropOnStep(const Dragged& what, const Target& to) const;
    std::optional<PlanDeed> putInto(const Dragged& what, std::size_t form) const;
    posh::MemberPlace placeAt(const Target& to) const;
    posh::MemberPlace endOf(std::size_t form) const;
    posh::Senses firstTrigger(const posh::MemberPlace& place) const;
    PlanDeed swap(const Dragged& what, const posh::PlanPart& with) const;

    const std::string& text_;
    const posh::Plan& plan_;
    const PlanTree& tree_;
};

} // namespace usar::widgets
