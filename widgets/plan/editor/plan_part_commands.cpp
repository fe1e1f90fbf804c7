#include "widgets/plan/editor/plan_part_commands.h"

namespace usar::widgets {

using InPlace = PlanPartEditor::InPlace;

PlanPartCommands::PlanPartCommands(PlanActions& actions, PlanPartEditor& parts, PlanCanvas& canvas, QObject* parent)
    : QObject(parent)
    , actions_(actions)
    , parts_(parts)
    , canvas_(canvas)
    , menu_(new QMenu(&canvas)) {
    menu_->setToolTipsVisible(true);
    addChanges();
    menu_->addSeparator();
    addMoves();
    menu_->addSeparator();
    addWraps();
    addForms();
    menu_->addSeparator();
    menu_->addAction(actions_.add(
        {"usages", tr("Find usages"), tr("Lists all places that use it"), "search", QKeySequence("Shift+F12")},
        [this] { emit usagesRequested(); }));
    add(menu_, "show_text", tr("Show in the text"), tr("Goes to its place in the text"), "text", {},
        [this] { emit textRequested(); });
}

void PlanPartCommands::add(QMenu* menu, const char* name, const QString& text, const QString& help, const char* icon,
                           const QKeySequence& keys, std::function<void()> run) {
    menu->addAction(actions_.add({name, text, help, icon, keys, true}, std::move(run)));
}

void PlanPartCommands::addChanges() {
    const auto edits = [this](InPlace what) { return [this, what] { parts_.editInPlace(what); }; };
    add(menu_, "edit", tr("Edit"), tr("Edits its name, call or sense in place"), "", Qt::Key_F2, edits(InPlace::Words));
    add(menu_, "values", tr("Values…"), tr("Edits arguments, comparison and operand, each by its type and range"), "",
        Qt::Key_V, [this] { parts_.editValues(); });
    menu_->addAction(actions_.add({"rename", tr("Rename everywhere"), tr("Renames it and everything that refers to it"),
                                   "", QKeySequence("Shift+F2")},
                                  edits(InPlace::Rename)));
    add(menu_, "trigger", tr("Trigger or goal"), tr("Edits when it may run, or when it is done"), "", Qt::Key_T,
        edits(InPlace::Trigger));
    add(menu_, "limit", tr("Limit"), tr("Edits how often it may start, or how long it may take"), "", Qt::Key_L,
        edits(InPlace::Limit));
    add(menu_, "comment", tr("Comment"), tr("Edits the comment about it"), "", Qt::Key_C, edits(InPlace::Comment));
}

void PlanPartCommands::addMoves() {
    const auto by = [this](auto edit, int steps) {
        return
            [=, this] { parts_.perform([=](const auto& text, const auto& part) { return edit(text, part, steps); }); };
    };
    add(menu_, "move_up", tr("Move up"), tr("Makes it more important, or earlier"), "up", QKeySequence("Alt+Up"),
        by(posh::shiftPart, -1));
    add(menu_, "move_down", tr("Move down"), tr("Makes it less important, or later"), "down", QKeySequence("Alt+Down"),
        by(posh::shiftPart, 1));
    add(menu_, "join_up", tr("Make equal with the one above"), tr("Gives both the same priority"), "",
        QKeySequence("Alt+Shift+Up"), by(posh::joinLevel, -1));
    add(menu_, "join_down", tr("Make equal with the one below"), tr("Gives both the same priority"), "",
        QKeySequence("Alt+Shift+Down"), by(posh::joinLevel, 1));
    add(menu_, "swap", tr("Swap with…"), tr("Remembers it; then use this on another part to swap the two"), "",
        Qt::Key_X, [this] { parts_.swap(); });
    menu_->addSeparator();
    add(menu_, "add_before", tr("Add before"), tr("Adds a new one of its kind before it"), "",
        QKeySequence("Shift+Ins"), [this] { parts_.addMember(true); });
    add(menu_, "add_after", tr("Add after"), tr("Adds a new one of its kind after it"), "plus", QKeySequence("Ins"),
        [this] { parts_.addMember(false); });
    add(menu_, "duplicate", tr("Duplicate"), tr("Adds a copy of it under another name"), "", QKeySequence("Ctrl+D"),
        [this] { parts_.perform(posh::duplicatePart); });
    add(menu_, "delete", tr("Delete"), tr("Removes it from the plan"), "trash", QKeySequence::Delete,
        [this] { parts_.perform(posh::removePart); });
}

void PlanPartCommands::addWraps() {
    QMenu* const wraps = menu_->addMenu(tr("Wrap or unwrap"));
    add(wraps, "wrap_competence", tr("Wrap in a competence"),
        tr("Puts a competence that does this in its place; Shift+Down includes its neighbors"), "",
        QKeySequence("Ctrl+1"), [this] { parts_.wrap(posh::FormKind::C); });
    add(wraps, "wrap_pattern", tr("Wrap in an action pattern"),
        tr("Puts a pattern that does this in its place; Shift+Down includes its neighbors"), "", QKeySequence("Ctrl+2"),
        [this] { parts_.wrap(posh::FormKind::Ap); });
    add(wraps, "wrap_adopt", tr("Wrap in an adopt"), tr("Puts an adopt that does this in its place"), "",
        QKeySequence("Ctrl+3"), [this] { parts_.wrap(posh::FormKind::Ad); });
    add(wraps, "inline", tr("Replace call by content"), tr("Puts what it does in place of its call"), "",
        QKeySequence("Ctrl+0"), [this] { parts_.inlineSelected(); });
}

void PlanPartCommands::addForms() {
    QMenu* const forms = menu_->addMenu(tr("New form"));
    const auto addForm = [&](const char* name, const QString& text, posh::FormKind kind, const std::string& base) {
        add(forms, name, text, tr("Adds one that does nothing yet; drag pieces into it"), "", {},
            [this, kind, base] { parts_.addForm(kind, base); });
    };
    addForm("new_competence", tr("New competence"), posh::FormKind::C, "choose");
    addForm("new_pattern", tr("New action pattern"), posh::FormKind::Ap, "steps");
    addForm("new_adopt", tr("New adopt"), posh::FormKind::Ad, "keep");
    addForm("new_collection", tr("New drive collection"), posh::FormKind::Dc, "life");
}

void PlanPartCommands::enable() {
    const PlanGestures* const can = parts_.gestures();
    const posh::Plan& plan = parts_.plan();
    const auto part = can ? parts_.selectedPart() : std::nullopt;
    const auto call = can ? parts_.selectedCall() : std::nullopt;
    const bool is_member = part && part->kind == posh::PartKind::Member;
    const bool is_form = part && part->kind == posh::PartKind::Whole;
    const bool is_step = call && posh::isStep(plan, *call);
    const bool has_senses = is_member || (is_form && !std::holds_alternative<posh::Pattern>(plan.forms[part->form]));
    actions_.enable({"edit", "rename", "swap", "move_up", "move_down", "delete", "usages", "show_text"},
                    part.has_value());
    actions_.enable("values", part && posh::callOf(plan, *part));
    actions_.enable("trigger", has_senses);
    actions_.enable({"limit", "comment"}, is_member || is_form);
    actions_.enable({"join_up", "join_down"}, is_member);
    actions_.enable("add_before", is_member || is_step);
    actions_.enable({"add_after", "duplicate"}, is_member || is_step || is_form);
    actions_.enable({"wrap_competence", "wrap_pattern", "wrap_adopt"}, call.has_value() || is_member);
    if (canvas_.rangeEnd().valid()) {
        actions_.enable("wrap_competence", is_member);
        actions_.enable("wrap_pattern", is_step);
        actions_.enable("wrap_adopt", false);
    }
    actions_.enable("inline", call && is_form);
    actions_.enable({"new_competence", "new_pattern", "new_adopt"}, can != nullptr);
    actions_.enable("new_collection", can && !posh::collectionOf(plan));
}

} // namespace usar::widgets
