// The commands of the plan editor for files, history and findings, and the dispatch of all keys.
#include <QKeyEvent>

#include "core/posh/edit/plan_templates.h"
#include "widgets/plan/editor/plan_editor.h"

namespace usar::widgets {

/// The window around the editor may have the same shortcuts; inside the editor, those of the editor take precedence.
bool PlanEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress)
        return QWidget::eventFilter(watched, event);
    const auto& key = *static_cast<QKeyEvent*>(event);
    QAction* const meant = actions_.actionOf(key, watched == canvas_);
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

void PlanEditor::addFileCommands() {
    menus_.new_plan = new QMenu(this);
    for (const posh::PlanTemplate& pattern : posh::planTemplates()) {
        QAction* const made = menus_.new_plan->addAction(QString::fromStdString(pattern.title));
        made->setToolTip(QString::fromStdString(pattern.help));
        connect(made, &QAction::triggered, this, [this, &pattern] {
            const auto start = [this, &pattern] { setText(pattern.text, tr("new.lap")); };
            if (!isModified())
                return start();
            offer_->offer(tr("%1 has changes that are not saved.").arg(name()), tr("Discard them and start a new plan"),
                          start);
        });
    }
    menus_.new_plan->setToolTipsVisible(true);
    actions_.add({"open", tr("Open…"), tr("Opens a plan"), "open", QKeySequence::Open},
                 [this] { emit openRequested(); });
    actions_.add({"save", tr("Save"), tr("Saves the plan to its file"), "save", QKeySequence::Save},
                 [this] { saveNow(); });
    actions_.add({"save_as", tr("Save as…"), tr("Saves the plan to another file"), "", QKeySequence("Ctrl+Shift+S")},
                 [this] { chooseWhereToSave(); });
    actions_.add({"apply", tr("Load into robot"), tr("Makes the robot continue with this plan"), "play",
                  QKeySequence("Ctrl+Return")},
                 [this] { emit applyRequested(text(), name()); });
    menus_.save_as = new QMenu(this);
    menus_.save_as->addAction(action("save_as"));
    const auto exports = [this](const char* name, const QString& text, const QString& help, auto run) {
        menus_.save_as->addAction(actions_.add({name, text, help}, run));
    };
    exports("export_classic", tr("For jyposh and POSH#…"), tr("Exports what the strict old dialect can express"),
            [this] { chooseWhereToExport(posh::Dialect::Classic); });
    exports("export_yaposh", tr("For yaPOSH…"), tr("Exports what Pogamut's dialect can express"),
            [this] { chooseWhereToExport(posh::Dialect::Yaposh); });
    exports("export_picture", tr("Picture of the drawing…"), tr("Saves the drawing as SVG, PDF or PNG"),
            [this] { chooseWhereToDraw(); });
}

void PlanEditor::addEditCommands() {
    QAction* const undo = actions_.add(
        {"undo", tr("Undo"), tr("Undoes the last change, in the text or the drawing"), "undo", QKeySequence::Undo},
        [this] { text_->undo(), catchUp(); });
    QAction* const redo =
        actions_.add({"redo", tr("Redo"), tr("Makes the undone change again"), "redo", QKeySequence("Ctrl+Shift+Z")},
                     [this] { text_->redo(), catchUp(); });
    undo->setEnabled(false);
    redo->setEnabled(false);
    connect(text_, &QPlainTextEdit::undoAvailable, undo, &QAction::setEnabled);
    connect(text_, &QPlainTextEdit::redoAvailable, redo, &QAction::setEnabled);
    menus_.compare = new QMenu(this);
    menus_.compare->addAction(
        actions_.add({"compare_saved", tr("With the saved plan"), tr("Lists what has changed since then")},
                     [this] { compareWith(file_.savedText(), tr("the saved plan")); }));
    menus_.compare->addAction(
        actions_.add({"compare_running", tr("With the running plan"), tr("Lists the differences")},
                     [this] { compareWith(running_text_, running_name_); }));
    actions_.add(
        {"mend", tr("Fix…"), tr("Offers fixes for the finding at the cursor"), "lamp", QKeySequence("Alt+Return")},
        [this] { showFixes(); });
    actions_.add({"next_finding", tr("Next finding"), tr("Goes to the next error or warning"), "", QKeySequence("F8")},
                 [this] { text_->setFocus(), text_->nextFinding(); });
}

void PlanEditor::enableCommands() {
    part_commands_->enable();
    actions_.enable("compare_saved", text_->planText() != file_.savedText());
    actions_.enable("compare_running", !running_text_.empty());
}

/// Shows the standard menu of text editors, extended by commands for plans.
void PlanEditor::showTextMenu(const QPoint& at) {
    enableCommands();
    QMenu* const menu = text_->createStandardContextMenu(at);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addSeparator();
    actions_.fill(*menu, {"mend", "next_finding", "rename", "usages"});
    menu->popup(text_->viewport()->mapToGlobal(at));
}

} // namespace usar::widgets
