#include "widgets/plan/editor/plan_part_commands.h"

namespace usar::widgets {

using InPlace = PlanPartEditor::InPlace;

PlanPartCommands::PlanPartCommands(PlanActions& actions, PlanPartEditor& parts, PlanCanvas& canvas, QObject* parent)
    : QObject(parent)
    , actions_(actions)
    , parts_(parts)
    , canvas_(canvas) {
    addChanges();
    addMoves();
    addWraps();
    addForms();
    fillMenu();
}

void PlanPartCommands::addChanges() {
    actions_.add({"edit", tr("Change"), tr("Changes its name, call or sense where it stands"), "", Qt::Key_F2, true},
                 [this] { parts_.editInPlace(InPlace::Words); });
    actions_.add({"values", tr("Values…"), tr("Arguments, comparison and operand, each by its type and range"), "",
                  Qt::Key_V, true},
                 [this] { parts_.editValues(); });
    actions_.add({"rename", tr("Rename everywhere"), tr("Changes its name and all that refers to it"), "",
                  QKeySequence("Shift+F2")},
                 [this] { parts_.editInPlace(InPlace::Rename); });
    actions_.add(
        {"trigger", tr("Trigger or goal"), tr("Changes when it may run, or when it is done"), "", Qt::Key_T, true},
        [this] { parts_.editInPlace(InPlace::Trigger); });
    actions_.add(
        {"limit", tr("Limit"), tr("Changes how often it may start, or how long it may take"), "", Qt::Key_L, true},
        [this] { parts_.editInPlace(InPlace::Limit); });
    actions_.add({"comment", tr("Comment"), tr("Changes what is said about it"), "", Qt::Key_C, true},
                 [this] { parts_.editInPlace(InPlace::Comment); });
}

void PlanPartCommands::addMoves() {
    actions_.add(
        {"move_up", tr("Move up"), tr("Makes it more important, or earlier"), "up", QKeySequence("Alt+Up"), true},
        [this] { parts_.shift(-1); });
    actions_.add(
        {"move_down", tr("Move down"), tr("Makes it less important, or later"), "down", QKeySequence("Alt+Down"), true},
        [this] { parts_.shift(1); });
    actions_.add({"join_up", tr("Make equal with the one above"), tr("Both have one priority then"), "",
                  QKeySequence("Alt+Shift+Up"), true},
                 [this] { parts_.join(-1); });
    actions_.add({"join_down", tr("Make equal with the one below"), tr("Both have one priority then"), "",
                  QKeySequence("Alt+Shift+Down"), true},
                 [this] { parts_.join(1); });
    actions_.add(
        {"add_before", tr("Add before"), tr("A new one like it, before it"), "", QKeySequence("Shift+Ins"), true},
        [this] { parts_.addMember(true); });
    actions_.add({"add_after", tr("Add behind"), tr("A new one like it, behind it"), "plus", QKeySequence("Ins"), true},
                 [this] { parts_.addMember(false); });
    actions_.add({"swap", tr("Swap with…"), tr("Remembers it; the next one you swap with changes places with it"), "",
                  Qt::Key_X, true},
                 [this] { parts_.swap(); });
    actions_.add(
        {"duplicate", tr("Duplicate"), tr("The same once more, under another name"), "", QKeySequence("Ctrl+D"), true},
        [this] { parts_.duplicate(); });
    actions_.add({"delete", tr("Delete"), tr("Takes it out of the plan"), "trash", QKeySequence::Delete, true},
                 [this] { parts_.remove(); });
}

void PlanPartCommands::addWraps() {
    actions_.add({"wrap_competence", tr("Wrap in a competence"),
                  tr("A competence that does this takes its place; Shift+Down takes neighbors along"), "",
                  QKeySequence("Ctrl+1"), true},
                 [this] { parts_.wrap(posh::FormKind::C); });
    actions_.add({"wrap_pattern", tr("Wrap in an action pattern"),
                  tr("A pattern that does this takes its place; Shift+Down takes neighbors along"), "",
                  QKeySequence("Ctrl+2"), true},
                 [this] { parts_.wrap(posh::FormKind::Ap); });
    actions_.add({"wrap_adopt", tr("Wrap in an adopt"), tr("An adopt that does this takes its place"), "",
                  QKeySequence("Ctrl+3"), true},
                 [this] { parts_.wrap(posh::FormKind::Ad); });
    actions_.add({"inline", tr("Put in place of its call"), tr("What it does stands here then"), "",
                  QKeySequence("Ctrl+0"), true},
                 [this] { parts_.inlineSelected(); });
    actions_.add({"usages", tr("Find usages"), tr("Lists all places that use it"), "search", QKeySequence("Shift+F12")},
                 [this] { emit usagesRequested(); });
    actions_.add({"show_text", tr("Show in the text"), tr("Goes to its place in the text"), "text", {}, true},
                 [this] { emit textRequested(); });
}

void PlanPartCommands::addForms() {
    const auto add = [this](const char* name, const QString& text, posh::FormKind kind, const std::string& base) {
        actions_.add({name, text, tr("It does nothing at first; drag pieces into it")},
                     [this, kind, base] { parts_.addForm(kind, base); });
    };
    add("new_competence", tr("New competence"), posh::FormKind::C, "choose");
    add("new_pattern", tr("New action pattern"), posh::FormKind::Ap, "steps");
    add("new_adopt", tr("New adopt"), posh::FormKind::Ad, "keep");
    add("new_collection", tr("New drive collection"), posh::FormKind::Dc, "life");
}

void PlanPartCommands::fillMenu() {
    menu_ = new QMenu(&canvas_);
    menu_->setToolTipsVisible(true);
    actions_.fill(*menu_, {"edit", "values", "rename", "trigger", "limit", "comment"});
    menu_->addSeparator();
    actions_.fill(*menu_, {"move_up", "move_down", "join_up", "join_down", "swap"});
    menu_->addSeparator();
    actions_.fill(*menu_, {"add_before", "add_after", "duplicate", "delete"});
    menu_->addSeparator();
    actions_.fill(*menu_->addMenu(tr("Wrap or unwrap")), {"wrap_competence", "wrap_pattern", "wrap_adopt", "inline"});
    actions_.fill(*menu_->addMenu(tr("New form")), {"new_competence", "new_pattern", "new_adopt", "new_collection"});
    menu_->addSeparator();
    actions_.fill(*menu_, {"usages", "show_text"});
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
    if (canvas_.rangeEnd() >= 0) {
        actions_.enable("wrap_competence", is_member);
        actions_.enable("wrap_pattern", is_step);
        actions_.enable("wrap_adopt", false);
    }
    actions_.enable("inline", call && is_form);
    actions_.enable({"new_competence", "new_pattern", "new_adopt"}, can != nullptr);
    actions_.enable("new_collection", can && !posh::collectionOf(plan));
}

} // namespace usar::widgets
