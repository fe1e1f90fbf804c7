// The commands of the plan editor: each one is made once and used by buttons, menus and keys.
#include <algorithm>
#include <array>
#include <cassert>

#include <QKeyEvent>

#include "core/posh/edit/plan_phrase.h"
#include "core/posh/edit/plan_templates.h"
#include "widgets/plan/plan_editor.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

using posh::PlanEdit;
using posh::PlanPart;

namespace {

constexpr const char* in_drawing_property = "in_drawing";

/// True for keys that the drawing handles itself, although the window may have shortcuts on them.
bool isKeyOfDrawing(const QKeyEvent& event) {
    if (event.modifiers() & Qt::ControlModifier)
        return event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down;
    constexpr std::array keys{Qt::Key_F,    Qt::Key_N,     Qt::Key_Space, Qt::Key_Home,   Qt::Key_End,
                              Qt::Key_Plus, Qt::Key_Equal, Qt::Key_Minus, Qt::Key_Return, Qt::Key_Enter};
    return std::ranges::find(keys, event.key()) != keys.end();
}

} // namespace

struct PlanEditor::Command {
    const char* name;
    QString text;
    QString help;
    const char* icon = "";
    QKeySequence keys = {};
    bool in_drawing = false; ///< its keys work in the drawing only
};

QAction* PlanEditor::add(const Command& command, std::function<void()> run) {
    auto* made = new QAction(command.text, this);
    const QString keys = command.keys.toString(QKeySequence::NativeText);
    made->setToolTip(keys.isEmpty() ? command.help : command.help + QStringLiteral(" (") + keys + u')');
    if (command.icon[0] != '\0')
        made->setIcon(icon(QString::fromLatin1(command.icon)));
    made->setShortcut(command.keys);
    made->setShortcutContext(Qt::WidgetShortcut); // Shown in menus; eventFilter handles the keys.
    made->setProperty(in_drawing_property, command.in_drawing);
    connect(made, &QAction::triggered, this, std::move(run));
    actions_.emplace(QString::fromLatin1(command.name), made);
    return made;
}

/// Returns the action for these keys, or nullptr.
QAction* PlanEditor::actionOf(const QKeyEvent& event, bool in_drawing) const {
    const QKeySequence keys(QKeyCombination(event.modifiers() & ~Qt::KeypadModifier, Qt::Key(event.key())));
    for (const auto& [name, candidate] : actions_)
        if (candidate->shortcut() == keys && (in_drawing || !candidate->property(in_drawing_property).toBool()))
            return candidate;
    return nullptr;
}

/// The window around the editor may have the same shortcuts; inside the editor, those of the editor take precedence.
bool PlanEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    QAction* const meant = actionOf(key, watched == canvas_);
    if (event->type() == QEvent::ShortcutOverride) {
        if (meant || (watched == canvas_ && isKeyOfDrawing(key)))
            event->accept();
        return meant != nullptr;
    }
    if (!meant)
        return QWidget::eventFilter(watched, event);
    enableCommands();
    meant->trigger();
    return true;
}

QAction* PlanEditor::action(const QString& name) const {
    const auto found = actions_.find(name);
    assert(found != actions_.end());
    return found->second;
}

void PlanEditor::makeFileCommands() {
    new_menu_ = new QMenu(this);
    for (const posh::PlanTemplate& pattern : posh::planTemplates()) {
        QAction* const made = new_menu_->addAction(QString::fromStdString(pattern.title));
        made->setToolTip(QString::fromStdString(pattern.help));
        connect(made, &QAction::triggered, this, [this, &pattern] {
            const auto start = [this, &pattern] { setText(pattern.text, tr("new.lap")); };
            if (!isModified())
                return start();
            offer(tr("%1 has changes that are not saved.").arg(name()), tr("Leave them and begin anew"), start);
        });
    }
    new_menu_->setToolTipsVisible(true);
    add({"open", tr("Open…"), tr("Opens a plan"), "open", QKeySequence::Open}, [this] { emit openRequested(); });
    add({"save", tr("Save"), tr("Saves the plan in its file"), "save", QKeySequence::Save}, [this] { saveNow(); });
    add({"save_as", tr("Save as…"), tr("Saves the plan in another file"), "", QKeySequence("Ctrl+Shift+S")},
        [this] { emit saveAsRequested(); });
    add({"apply", tr("Put into the robot"), tr("The robot goes on with this plan"), "play",
         QKeySequence("Ctrl+Return")},
        [this] { emit applyRequested(text(), name()); });
    export_menu_ = new QMenu(this);
    export_menu_->addAction(action("save_as"));
    const auto exports = [this](const char* name, const QString& text, const QString& help, auto run) {
        export_menu_->addAction(add({name, text, help}, run));
    };
    exports("export_classic", tr("For jyposh and POSH#…"), tr("Writes what the strict old dialect can express"),
            [this] { emit exportRequested(posh::Dialect::Classic); });
    exports("export_yaposh", tr("For yaPOSH…"), tr("Writes what Pogamut's dialect can express"),
            [this] { emit exportRequested(posh::Dialect::Yaposh); });
    exports("export_picture", tr("Picture of the drawing…"), tr("As SVG, PDF or PNG"),
            [this] { emit pictureRequested(); });
}

void PlanEditor::makeEditCommands() {
    QAction* const undo =
        add({"undo", tr("Undo"), tr("Takes the last change back, in text or drawing"), "undo", QKeySequence::Undo},
            [this] { text_->undo(), catchUp(); });
    QAction* const redo = add({"redo", tr("Redo"), tr("Makes it again"), "redo", QKeySequence("Ctrl+Shift+Z")},
                              [this] { text_->redo(), catchUp(); });
    undo->setEnabled(false);
    redo->setEnabled(false);
    connect(text_, &QPlainTextEdit::undoAvailable, undo, &QAction::setEnabled);
    connect(text_, &QPlainTextEdit::redoAvailable, redo, &QAction::setEnabled);
    compare_menu_ = new QMenu(this);
    compare_menu_->addAction(add({"compare_saved", tr("With the saved plan"), tr("Lists what was changed since")},
                                 [this] { compareWith(file_.savedText(), tr("the saved plan")); }));
    compare_menu_->addAction(add({"compare_running", tr("With the running plan"), tr("Lists how they differ")},
                                 [this] { compareWith(running_text_, running_name_); }));
    add({"mend", tr("Mend…"), tr("What can be done about the finding at the cursor"), "lamp",
         QKeySequence("Alt+Return")},
        [this] { showMends(); });
    add({"next_finding", tr("Next finding"), tr("Goes to the next error or warning"), "", QKeySequence("F8")},
        [this] { text_->setFocus(), text_->nextFinding(); });
}

void PlanEditor::makePartCommands() {
    const auto shift = [this](int by) {
        perform([by](const std::string& text, const PlanPart& part) { return posh::shiftPart(text, part, by); });
    };
    const auto join = [this](int by) {
        perform([by](const std::string& text, const PlanPart& part) { return posh::joinLevel(text, part, by); });
    };
    add({"edit", tr("Change"), tr("Changes its name, call or sense where it stands"), "", Qt::Key_F2, true},
        [this] { editInPlace(InPlace::Words); });
    add({"values", tr("Values…"), tr("Arguments, comparison and operand, each by its type and range"), "", Qt::Key_V,
         true},
        [this] { editValues(); });
    add({"rename", tr("Rename everywhere"), tr("Changes its name and all that refers to it"), "",
         QKeySequence("Shift+F2")},
        [this] { editInPlace(InPlace::Rename); });
    add({"trigger", tr("Trigger or goal"), tr("Changes when it may run, or when it is done"), "", Qt::Key_T, true},
        [this] { editInPlace(InPlace::Trigger); });
    add({"limit", tr("Limit"), tr("Changes how often it may start, or how long it may take"), "", Qt::Key_L, true},
        [this] { editInPlace(InPlace::Limit); });
    add({"comment", tr("Comment"), tr("Changes what is said about it"), "", Qt::Key_C, true},
        [this] { editInPlace(InPlace::Comment); });
    add({"move_up", tr("Move up"), tr("Makes it more important, or earlier"), "up", QKeySequence("Alt+Up"), true},
        [shift] { shift(-1); });
    add({"move_down", tr("Move down"), tr("Makes it less important, or later"), "down", QKeySequence("Alt+Down"), true},
        [shift] { shift(1); });
    add({"join_up", tr("Make equal with the one above"), tr("Both have one priority then"), "",
         QKeySequence("Alt+Shift+Up"), true},
        [join] { join(-1); });
    add({"join_down", tr("Make equal with the one below"), tr("Both have one priority then"), "",
         QKeySequence("Alt+Shift+Down"), true},
        [join] { join(1); });
    add({"add_before", tr("Add before"), tr("A new one like it, before it"), "", QKeySequence("Shift+Ins"), true},
        [this] { addMemberAtSelection(true); });
    add({"add_after", tr("Add behind"), tr("A new one like it, behind it"), "plus", QKeySequence("Ins"), true},
        [this] { addMemberAtSelection(false); });
    add({"swap", tr("Swap with…"), tr("Remembers it; the next one you swap with changes places with it"), "", Qt::Key_X,
         true},
        [this] { swapSelected(); });
    add({"duplicate", tr("Duplicate"), tr("The same once more, under another name"), "", QKeySequence("Ctrl+D"), true},
        [this] { perform(posh::duplicatePart); });
    add({"delete", tr("Delete"), tr("Takes it out of the plan"), "trash", QKeySequence::Delete, true},
        [this] { perform(posh::removePart); });
}

void PlanEditor::makeListCommands() {
    const auto wrap = [this](posh::FormKind kind) {
        if (canvas_->rangeEnd() >= 0)
            return wrapRange(kind);
        const auto call = selectedCall();
        const auto part = call ? call : selectedPart();
        if (part && gestures())
            perform(posh::wrapCall(drawn_text_, *part, kind));
    };
    add({"wrap_competence", tr("Wrap in a competence"),
         tr("A competence that does this takes its place; Shift+Down takes neighbors along"), "",
         QKeySequence("Ctrl+1"), true},
        [wrap] { wrap(posh::FormKind::C); });
    add({"wrap_pattern", tr("Wrap in an action pattern"),
         tr("A pattern that does this takes its place; Shift+Down takes neighbors along"), "", QKeySequence("Ctrl+2"),
         true},
        [wrap] { wrap(posh::FormKind::Ap); });
    add({"wrap_adopt", tr("Wrap in an adopt"), tr("An adopt that does this takes its place"), "",
         QKeySequence("Ctrl+3"), true},
        [wrap] { wrap(posh::FormKind::Ad); });
    add({"inline", tr("Put in place of its call"), tr("What it does stands here then"), "", QKeySequence("Ctrl+0"),
         true},
        [this] {
            if (const auto call = selectedCall(); call && gestures())
                perform(posh::inlineCall(drawn_text_, *call));
        });
    add({"usages", tr("Find usages"), tr("Lists all places that use it"), "search", QKeySequence("Shift+F12")},
        [this] { showUsages(); });
    add({"show_text", tr("Show in the text"), tr("Goes to its place in the text"), "text", {}, true}, [this] {
        if (const int node = canvas_->selected(); node >= 0)
            jumpTo(canvas_->tree()[node].at);
    });
    const auto addForm = [this](const char* name, const QString& text, posh::FormKind kind, const std::string& base) {
        add({name, text, tr("It does nothing at first; drag pieces into it")}, [this, kind, base] {
            const std::string free = posh::freeFormName(drawn_plan_, base);
            perform(posh::addForm(text_->planText(), kind, free, posh::readCallPhrase("doNothing").value()));
            if (canvas_->selected() >= 0)
                editInPlace(InPlace::Rename);
        });
    };
    addForm("new_competence", tr("New competence"), posh::FormKind::C, "choose");
    addForm("new_pattern", tr("New action pattern"), posh::FormKind::Ap, "steps");
    addForm("new_adopt", tr("New adopt"), posh::FormKind::Ad, "keep");
    addForm("new_collection", tr("New drive collection"), posh::FormKind::Dc, "life");
}

void PlanEditor::makeMenus() {
    part_menu_ = new QMenu(canvas_);
    part_menu_->setToolTipsVisible(true);
    const auto fill = [this](QMenu* menu, std::initializer_list<const char*> names) {
        for (const char* const name : names)
            menu->addAction(action(QString::fromLatin1(name)));
    };
    fill(part_menu_, {"edit", "values", "rename", "trigger", "limit", "comment"});
    part_menu_->addSeparator();
    fill(part_menu_, {"move_up", "move_down", "join_up", "join_down", "swap"});
    part_menu_->addSeparator();
    fill(part_menu_, {"add_before", "add_after", "duplicate", "delete"});
    part_menu_->addSeparator();
    fill(part_menu_->addMenu(tr("Wrap or unwrap")), {"wrap_competence", "wrap_pattern", "wrap_adopt", "inline"});
    fill(part_menu_->addMenu(tr("New form")), {"new_competence", "new_pattern", "new_adopt", "new_collection"});
    part_menu_->addSeparator();
    fill(part_menu_, {"usages", "show_text"});
}

/// Disables the commands that make no sense for the selected part.
void PlanEditor::enableCommands() {
    const PlanGestures* const can = gestures();
    const auto part = can ? selectedPart() : std::nullopt;
    const auto call = can ? selectedCall() : std::nullopt;
    const bool is_member = part && part->kind == posh::PartKind::Member;
    const bool is_form = part && part->kind == posh::PartKind::Whole;
    const bool is_step = call && posh::isStep(drawn_plan_, *call);
    const bool has_senses =
        is_member || (is_form && !std::holds_alternative<posh::Pattern>(drawn_plan_.forms[part->form]));
    const auto enable = [this](const char* name, bool on) { action(QString::fromLatin1(name))->setEnabled(on); };
    for (const char* const name : {"edit", "rename", "swap", "move_up", "move_down", "delete", "usages", "show_text"})
        enable(name, part.has_value());
    enable("values", part && posh::callOf(drawn_plan_, *part));
    enable("trigger", has_senses);
    enable("limit", is_member || is_form);
    enable("comment", is_member || is_form);
    enable("join_up", is_member);
    enable("join_down", is_member);
    enable("add_before", is_member || is_step);
    enable("add_after", is_member || is_step || is_form);
    enable("duplicate", is_member || is_step || is_form);
    for (const char* const name : {"wrap_competence", "wrap_pattern", "wrap_adopt"})
        enable(name, call.has_value() || is_member);
    if (canvas_->rangeEnd() >= 0) {
        enable("wrap_competence", is_member);
        enable("wrap_pattern", is_step);
        enable("wrap_adopt", false);
    }
    enable("inline", call && is_form);
    for (const char* const name : {"new_competence", "new_pattern", "new_adopt"})
        enable(name, can != nullptr);
    enable("new_collection", can && !posh::collectionOf(drawn_plan_));
    enable("compare_saved", text_->planText() != file_.savedText());
    enable("compare_running", !running_text_.empty());
}

void PlanEditor::showMenu(int, const QPoint& global) {
    enableCommands();
    part_menu_->popup(global);
}

/// Shows the standard menu of text editors, extended by commands for plans.
void PlanEditor::showTextMenu(const QPoint& at) {
    enableCommands();
    QMenu* const menu = text_->createStandardContextMenu(at);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSeparator();
    for (const char* const name : {"mend", "next_finding", "rename", "usages"})
        menu->addAction(action(QString::fromLatin1(name)));
    menu->popup(text_->viewport()->mapToGlobal(at));
}

/// Opens the line editor with a name, a call or a sense as the plan writes it, the whole trigger, a limit or a comment.
void PlanEditor::editInPlace(InPlace what) {
    const int node = canvas_->selected();
    const auto part = gestures() ? selectedPart() : std::nullopt;
    if (node < 0 || !part)
        return;
    const posh::Plan& plan = drawn_plan_;
    const PlanNode& drawn = canvas_->tree()[node];
    QString words = drawn.name;
    if (what == InPlace::Words && part->kind == posh::PartKind::Sense)
        words += drawn.detail.isEmpty()
                     ? QString()
                     : QString::fromStdString(posh::phraseOf(*posh::senseOf(plan, *part))).mid(drawn.name.size());
    else if (what == InPlace::Rename)
        words = QString::fromStdString(posh::nameOf(plan, *part)->text);
    else if (what == InPlace::Trigger)
        words = QString::fromStdString(posh::sensesPhrase(plan, *part));
    else if (what == InPlace::Limit)
        words = QString::fromStdString(posh::limitPhrase(plan, *part));
    else if (what == InPlace::Comment)
        words = drawn.comment;
    drawing_shown_->setChecked(true);
    canvas_->editInPlace(node, words, static_cast<int>(what));
}

void PlanEditor::enterWords(int node, const QString& entered, int what) {
    const auto part = gestures() ? partOfNode(drawn_plan_, canvas_->tree(), node) : std::nullopt;
    if (!part)
        return;
    const std::string words = entered.trimmed().toStdString();
    const auto with = [&](auto phrase, auto edit) -> Result<PlanEdit> {
        if (!phrase)
            return tl::unexpected(phrase.error());
        return edit(drawn_text_, *part, *phrase);
    };
    switch (static_cast<InPlace>(what)) {
    case InPlace::Trigger:
        return perform(with(posh::readSensesPhrase(words), posh::setSenses));
    case InPlace::Limit:
        return perform(posh::setLimit(drawn_text_, *part, words));
    case InPlace::Comment:
        return perform(posh::setComment(drawn_text_, *part, words));
    case InPlace::Words:
        if (part->kind == posh::PartKind::Sense)
            return perform(with(posh::readSensePhrase(words), posh::replaceSense));
        if (part->kind == posh::PartKind::Action)
            return perform(with(posh::readCallPhrase(words), posh::replaceCall));
        break;
    case InPlace::Rename:
        break;
    }
    perform(posh::renamePart(drawn_text_, *part, words));
}

/// Adds a member beside a member, a step beside a step, or a part inside a form; then the user can write its act.
void PlanEditor::addMemberAtSelection(bool before) {
    const PlanGestures* const can = gestures();
    const int node = canvas_->selected();
    const auto part = can ? selectedPart() : std::nullopt;
    if (!part)
        return;
    const bool into =
        part->kind == posh::PartKind::Whole && !(selectedCall() && posh::isStep(drawn_plan_, *selectedCall()));
    const DropZone zone = into ? DropZone::Onto : before ? DropZone::Before : DropZone::After;
    const auto deed = can->drop(PlanPiece{false, QStringLiteral("doNothing")}, node, zone);
    if (!deed)
        return say(tr("Nothing can be added here; choose a drive, an element, a step or a form."), true);
    perform(deed->edit());
    const int made = canvas_->selected();
    const bool is_card = made >= 0 && !canvas_->tree().children(made).empty();
    canvas_->select(is_card ? canvas_->tree().children(made).front() : made);
    editInPlace(InPlace::Words);
}

/// Remembers the first part by its place in the text until the text changes; the second part is swapped with it.
void PlanEditor::swapSelected() {
    const int node = canvas_->selected();
    const auto call = selectedCall();
    const auto part = call ? call : selectedPart();
    if (!gestures() || !part)
        return;
    const bool has_first = swap_first_ && swap_text_ == drawn_text_ && *swap_first_ != *part;
    if (has_first)
        return perform(posh::swapParts(drawn_text_, *std::exchange(swap_first_, std::nullopt), *part));
    swap_first_ = part;
    swap_text_ = drawn_text_;
    say(tr("Now select what %1 is to change places with, and press X again.").arg(canvas_->tree()[node].name));
}

} // namespace usar::widgets
