// The commands for the selected part of a drawn plan, and the menu of a part.
#pragma once

#include <QMenu>
#include <QObject>

#include "widgets/plan/editor/plan_actions.h"
#include "widgets/plan/editor/plan_part_editor.h"

namespace usar::widgets {

/// Adds its commands to the editor's actions when it is made. GUI thread.
class PlanPartCommands : public QObject {
    Q_OBJECT
public:
    /// The first three arguments must outlive this object.
    PlanPartCommands(PlanActions& actions, PlanPartEditor& parts, PlanCanvas& canvas, QObject* parent);

    /// Disables the commands that make no sense for the selected part.
    void enable();
    void showMenu(const QPoint& global) { menu_->popup(global); }

signals:
    void usagesRequested();
    /// The user wants to see the selected part in the text.
    void textRequested();

private:
    /// Adds a command whose keys work in the drawing only, here and to a menu.
    void add(QMenu* menu, const char* name, const QString& text, const QString& help, const char* icon,
             const QKeySequence& keys, std::function<void()> run);
    void addChanges();
    void addMoves();
    void addWraps();
    void addForms();

    PlanActions& actions_;
    PlanPartEditor& parts_;
    PlanCanvas& canvas_;
    QMenu* menu_;
};

} // namespace usar::widgets
