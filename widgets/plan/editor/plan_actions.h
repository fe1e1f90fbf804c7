// The commands of the plan editor by name: each is made once and used by buttons, menus and keys.
#pragma once

#include <functional>
#include <initializer_list>
#include <map>

#include <QAction>
#include <QKeyEvent>
#include <QMenu>
#include <QWidget>

namespace usar::widgets {

/// Description of a command of the editor.
struct PlanCommand {
    const char* name; ///< unique: "undo", "move_up", "wrap_pattern"
    QString text;
    QString help;
    const char* icon = ""; ///< empty: none
    QKeySequence keys = {};
    bool in_drawing = false; ///< its keys work in the drawing only
};

/// The actions belong to the owner, which also has to dispatch the keys: the actions' own shortcuts are only shown,
/// because the window around the editor may have the same ones. GUI thread.
class PlanActions {
public:
    explicit PlanActions(QWidget& owner) : owner_(owner) {}

    /// Makes the action of a command; `run` is called whenever it is triggered.
    QAction* add(const PlanCommand& command, std::function<void()> run);
    /// An unknown name is a programming error (assertion).
    QAction* action(const QString& name) const;
    void enable(const char* name, bool on) { action(QString::fromLatin1(name))->setEnabled(on); }
    void enable(std::initializer_list<const char*> names, bool on);
    /// Appends the actions to a menu, in this order.
    void fill(QMenu& menu, std::initializer_list<const char*> names) const;
    /// The action for these keys, which were pressed in the drawing or elsewhere; nullptr if there is none.
    QAction* actionOf(const QKeyEvent& event, bool in_drawing) const;

private:
    QWidget& owner_;
    std::map<QString, QAction*> actions_;
};

/// True for keys that the drawing handles itself, although the window may have shortcuts on them.
bool isKeyOfDrawing(const QKeyEvent& event);

} // namespace usar::widgets
