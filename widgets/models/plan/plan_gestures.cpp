#include "widgets/models/plan/plan_gestures.h"

#include <charconv>

#include <QObject>

#include "core/posh/edit/plan_phrase.h"

namespace usar::widgets {

using namespace usar::posh;

namespace {

QString nameText(const Plan& plan, const PlanPart& part) {
    const Name* const name = nameOf(plan, part);
    return name ? QString::fromStdString(name->text) : QString();
}

/// Returns the number after "/A:" at the start of a segment; 0 if there is none.
std::size_t stepNumber(const std::string& segment) {
    std::size_t number = 0;
    if (segment.starts_with("/A:"))
        std::from_chars(segment.data() + 3, segment.data() + segment.size(), number);
    return number;
}

/// Returns the deed that calls `edit(text, arguments...)`, one of the edits in plan_edits.h.
template <class Edit, class... Arguments>
PlanDeed deedOf(const QString& words, Edit edit, const std::string& text, const Arguments&... arguments) {
    return {words, [=] { return edit(text, arguments...); }};
}

} // namespace

std::optional<PlanPart> partOfNode(const Plan& plan, const PlanTree& tree, PlanNodeId node) {
    if (!tree.contains(node) || tree[node].at.line == 0)
        return std::nullopt;
    const auto part = partAt(plan, tree[node].at.offset);
    return part && nameOf(plan, *part)->at.offset == tree[node].at.offset ? part : std::nullopt;
}

std::optional<PlanPart> callOfNode(const Plan& plan, const PlanTree& tree, PlanNodeId node) {
    const auto part = partOfNode(plan, tree, node);
    if (!part || part->kind == PartKind::Action)
        return part;
    if (part->kind != PartKind::Whole || !tree[node].parent.valid())
        return std::nullopt;
    const auto parent = partOfNode(plan, tree, tree[node].parent);
    if (!parent)
        return std::nullopt;
    if (parent->kind == PartKind::Member)
        return actionPart(parent->form, parent->level, parent->member);
    const PlanPart call{PartKind::Action, parent->form, 0, 0, stepNumber(tree[node].segment)};
    return callOf(plan, call) ? std::optional(call) : std::nullopt;
}

PlanNodeId nodeOfPart(const Plan& plan, const PlanTree& tree, const PlanPart& part) {
    const Name* const name = nameOf(plan, part);
    if (!name)
        return {};
    PlanNodeId link;
    for (const PlanNodeId node : tree.nodes()) {
        if (tree[node].at.offset == name->at.offset && tree[node].at.line > 0) {
            if (!tree[node].link.valid())
                return node;
            link = node;
        } else if (part.kind == PartKind::Action && callOfNode(plan, tree, node) == part) {
            return node;
        }
    }
    return link;
}

/// The dragged sense, member or call; `from` is its place in the plan, if it has one.
struct PlanGestures::Dragged {
    PartKind kind = PartKind::Action;
    SenseTest sense{};
    Call call{};
    std::optional<PlanPart> from{};
    QString name{};
    Step step() const { return kind == PartKind::Sense ? Step(sense) : Step(call); }
};

/// The part that something is dropped on.
struct PlanGestures::Target {
    std::optional<PlanPart> part;
    std::optional<PlanPart> call; ///< call that leads to the part
    DropZone zone = DropZone::Onto;
    bool is_step = false;
    QString name{};
};

std::optional<PlanGestures::Dragged> PlanGestures::dragged(const std::variant<PlanPiece, PlanNodeId>& source) const {
    if (const auto* const piece = std::get_if<PlanPiece>(&source)) {
        const std::string words = piece->words.toStdString();
        const auto sense = piece->is_sense ? readSensePhrase(words) : Result<SenseTest>();
        const auto call = piece->is_sense ? Result<Call>() : readCallPhrase(words);
        if (!sense || !call)
            return std::nullopt;
        return Dragged{piece->is_sense ? PartKind::Sense : PartKind::Action, *sense, *call, std::nullopt,
                       piece->words.section(u' ', 0, 0).section(u'(', 0, 0)};
    }
    const PlanNodeId node = std::get<PlanNodeId>(source);
    const auto part = partOfNode(plan_, tree_, node);
    if (!part)
        return std::nullopt;
    Dragged what{.kind = part->kind, .from = part, .name = nameText(plan_, *part)};
    if (part->kind == PartKind::Sense) {
        what.sense = *senseOf(plan_, *part);
    } else if (part->kind != PartKind::Member) {
        what.kind = PartKind::Action;
        what.from = callOfNode(plan_, tree_, node);
        if (!what.from && std::holds_alternative<Collection>(plan_.forms[part->form]))
            return std::nullopt;
        what.call = what.from ? *callOf(plan_, *what.from) : Call{*nameOf(plan_, *part), {}};
    }
    return what;
}

PlanGestures::Target PlanGestures::targetAt(PlanNodeId node, DropZone zone) const {
    Target to{.part = partOfNode(plan_, tree_, node), .call = callOfNode(plan_, tree_, node), .zone = zone};
    if (to.part) {
        to.name = nameText(plan_, *to.part);
        to.is_step = isStep(plan_, to.call ? *to.call : *to.part);
    }
    return to;
}

PlanDeed PlanGestures::swap(const Dragged& what, const PlanPart& with) const {
    return deedOf(QObject::tr("Swap %1 with %2").arg(what.name, nameText(plan_, with)), swapParts, text_, *what.from,
                  with);
}

/// For a target that is alone in its level: a new level before or after it. Among equals: another member of that level.
MemberPlace PlanGestures::placeAt(const Target& to) const {
    const PlanPart& part = *to.part;
    const std::size_t after = to.zone == DropZone::After ? 1 : 0;
    if ((*levelsIn(plan_.forms[part.form]))[part.level].size() > 1)
        return {part.form, part.level, part.member + after};
    return {part.form, part.level + after};
}

/// Before a last member that is always ready, because nothing after it would ever be reached.
MemberPlace PlanGestures::endOf(std::size_t form) const {
    const Levels& levels = *levelsIn(plan_.forms[form]);
    const bool ends_ready = !levels.empty() && levels.back().size() == 1 && levels.back()[0].trigger.empty();
    return {form, levels.size() - (ends_ready ? 1 : 0)};
}

Senses PlanGestures::firstTrigger(const MemberPlace& place) const {
    if (place.level >= levelsIn(plan_.forms[place.form])->size())
        return {};
    return {SenseTest{Call{{"fail", {}}, {}}, std::nullopt, std::nullopt}};
}

std::optional<PlanDeed> PlanGestures::drop(const std::variant<PlanPiece, PlanNodeId>& source, PlanNodeId target,
                                           DropZone zone) const {
    const auto* const node = std::get_if<PlanNodeId>(&source);
    const auto what = node && *node == target ? std::nullopt : dragged(source);
    if (!what)
        return std::nullopt;
    // Only senses can be dropped on a sense row; others mean its card.
    if (target.valid() && tree_[target].in_card && what->kind != PartKind::Sense) {
        target = tree_[target].parent;
        zone = DropZone::Onto;
    }
    if (!target.valid() && collectionOf(plan_) && what->kind == PartKind::Action) {
        for (std::size_t i = 0; i < plan_.forms.size(); ++i)
            if (std::holds_alternative<Collection>(plan_.forms[i]))
                return putInto(*what, i);
    }
    const Target to = targetAt(target, zone);
    if (!to.part)
        return std::nullopt;
    switch (what->kind) {
    case PartKind::Sense:
        return dropSense(*what, to);
    case PartKind::Member:
        return dropMember(*what, to);
    default:
        return dropCall(*what, to);
    }
}

std::optional<PlanDeed> PlanGestures::add(const PlanPiece& piece, PlanNodeId selected) const {
    const bool is_row = selected.valid() && tree_[selected].in_card;
    const bool is_card = selected.valid() && !piece.is_sense &&
                         (tree_[selected].kind == PlanNodeKind::Drive ||
                          tree_[selected].kind == PlanNodeKind::Element || targetAt(selected, DropZone::After).is_step);
    return drop(piece, selected, is_row || is_card ? DropZone::After : DropZone::Onto);
}

std::optional<PlanDeed> PlanGestures::dropSense(const Dragged& what, const Target& to) const {
    if (to.part == what.from)
        return std::nullopt;
    if (to.is_step)
        return dropOnStep(what, to);
    if (to.part->kind == PartKind::Sense && to.zone == DropZone::Onto) {
        if (what.from)
            return swap(what, *to.part);
        return deedOf(QObject::tr("Ask %1 in place of %2").arg(what.name, to.name), replaceSense, text_, *to.part,
                      what.sense);
    }
    PlanPart owner =
        to.part->kind == PartKind::Whole || to.part->kind == PartKind::Member ? *to.part : ownerOf(*to.part);
    if (to.call && to.call->in_member && to.part->kind == PartKind::Action)
        owner = ownerOf(*to.call);
    if (owner.kind == PartKind::Whole && std::holds_alternative<Pattern>(plan_.forms[owner.form]))
        return putInto(what, owner.form);
    const QString words = owner.kind == PartKind::Member
                              ? QObject::tr("Ask %1 for %2").arg(what.name, nameText(plan_, owner))
                              : QObject::tr("Make %1 the goal of %2").arg(what.name, nameText(plan_, owner));
    if (what.from && ownerOf(*what.from) == owner && !isStep(plan_, *what.from))
        return deedOf(QObject::tr("Ask %1 at another place").arg(what.name), swapParts, text_, *what.from, *to.part);
    return PlanDeed{words, [text = text_, owner, test = what.sense, from = what.from]() -> Result<PlanEdit> {
                        auto added = addSense(text, owner, test);
                        if (!added || !from)
                            return added;
                        auto moved = removePart(added->text, *from);
                        if (moved)
                            moved->part = added->part;
                        return moved;
                    }};
}

std::optional<PlanDeed> PlanGestures::dropMember(const Dragged& what, const Target& to) const {
    const PlanPart from = *what.from;
    if (to.part->kind == PartKind::Whole && levelsIn(plan_.forms[to.part->form]))
        return deedOf(QObject::tr("Move %1 to %2").arg(what.name, to.name), moveMember, text_, from,
                      endOf(to.part->form));
    if (to.part->kind != PartKind::Member)
        return std::nullopt;
    if (to.zone == DropZone::Onto)
        return swap(what, *to.part);
    const QString words =
        to.zone == DropZone::Before ? QObject::tr("Move %1 before %2") : QObject::tr("Move %1 after %2");
    return deedOf(words.arg(what.name, to.name), moveMember, text_, from, placeAt(to));
}

std::optional<PlanDeed> PlanGestures::dropOnStep(const Dragged& what, const Target& to) const {
    const PlanPart step = to.call ? *to.call : *to.part;
    const bool from_step = what.from && isStep(plan_, *what.from);
    if (to.zone == DropZone::Onto) {
        if (from_step || (what.from && what.kind == PartKind::Action && step.kind == PartKind::Action))
            return swap(what, step);
        if (what.kind == PartKind::Action && step.kind == PartKind::Action && !what.from)
            return deedOf(QObject::tr("Do %1 in place of %2").arg(what.name, to.name), replaceCall, text_, step,
                          what.call);
    }
    const std::size_t index = step.index + (to.zone == DropZone::After ? 1 : 0);
    const QString words =
        (to.zone == DropZone::After ? QObject::tr("%1 after %2") : QObject::tr("%1 before %2")).arg(what.name, to.name);
    if (from_step)
        return deedOf(words, moveStep, text_, *what.from, step.form, index);
    return deedOf(words, addStep, text_, step.form, index, what.step());
}

std::optional<PlanDeed> PlanGestures::dropCall(const Dragged& what, const Target& to) const {
    const PlanPart& part = *to.part;
    if (part.kind == PartKind::Whole && (!what.from || !to.call) && !(to.is_step && to.zone != DropZone::Onto))
        return putInto(what, part.form);
    if (to.is_step)
        return dropOnStep(what, to);
    if (part.kind == PartKind::Member && to.zone != DropZone::Onto) {
        const MemberPlace place = placeAt(to);
        const QString words =
            to.zone == DropZone::Before ? QObject::tr("New %1 before %2") : QObject::tr("New %1 after %2");
        return deedOf(words.arg(what.name, to.name), addMember, text_, place, what.call, firstTrigger(place),
                      std::string());
    }
    const PlanPart place = part.kind == PartKind::Member ? actionPart(part.form, part.level, part.member)
                           : to.call                     ? *to.call
                                                         : part;
    if (place.kind != PartKind::Action || what.from == place)
        return std::nullopt;
    if (what.from)
        return swap(what, place);
    return deedOf(QObject::tr("Do %1 in place of %2").arg(what.name, nameText(plan_, place)), replaceCall, text_, place,
                  what.call);
}

/// Appends to the form.
std::optional<PlanDeed> PlanGestures::putInto(const Dragged& what, std::size_t form) const {
    const QString words = QObject::tr("Put %1 into %2").arg(what.name, nameText(plan_, formPart(form)));
    if (const auto* const pattern = std::get_if<Pattern>(&plan_.forms[form]))
        return deedOf(words, addStep, text_, form, pattern->steps.size(), what.step());
    if (what.kind != PartKind::Action)
        return std::nullopt;
    if (std::holds_alternative<Adopt>(plan_.forms[form]))
        return deedOf(words, replaceCall, text_, PlanPart{PartKind::Action, form}, what.call);
    const MemberPlace place = endOf(form);
    return deedOf(words, addMember, text_, place, what.call, firstTrigger(place), std::string());
}

} // namespace usar::widgets
