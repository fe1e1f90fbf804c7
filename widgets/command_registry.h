// Every action of the program, registered once: menus, tool bars, shortcuts, palette, tooltips, help sheet and tests
// are made from here.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QAction>
#include <QKeySequence>
#include <QMenu>
#include <QObject>
#include <QToolBar>

namespace usar::widgets {

/// A command as its author describes it.
struct CommandSpec {
    QString id;    ///< "map.fit"
    QString text;  ///< "Fit mission in view": what menus and the palette say
    QString group; ///< "Map": the context it belongs to, a heading of the help sheet
    QString help;  ///< one sentence; the tooltip adds the shortcut
    QString icon;  ///< name for icons.h, may be empty
    QList<QKeySequence> shortcuts;
    bool checkable = false;
};

/// Owns the actions and adds them to the window, so that shortcuts work wherever the focus is. GUI thread; lives as
/// long as the window.
class CommandRegistry : public QObject {
    Q_OBJECT
public:
    explicit CommandRegistry(QWidget* window);
    ~CommandRegistry() override;

    /// Registers and makes the action. `run` is called with the checked state; `enabled` is asked by refresh(). An id
    /// or a shortcut that is taken is a bug (assertion).
    QAction* add(const CommandSpec& spec, std::function<void(bool)> run, std::function<bool()> enabled = {});
    /// Lists an action that somebody else made and runs (a dock's own toggle); its text and shortcut become the spec's.
    /// It lives as long as the window.
    void adopt(const CommandSpec& spec, QAction* action);
    /// The action; asking for an unknown id is a bug (assertion).
    QAction* action(const QString& id) const;
    bool contains(const QString& id) const;

    /// A command with what was made from it; `enabled` may be empty: always on.
    struct Command {
        CommandSpec spec;
        QAction* action = nullptr;
        std::function<bool()> enabled;
    };
    /// In the order of registration.
    const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
    /// Asks every enabled rule again; call it when the state changed that rules look at.
    void refresh();

    /// An id "-" makes a separator.
    void fill(QMenu* menu, const QStringList& ids) const;
    void fill(QToolBar* bar, const QStringList& ids) const;

private:
    void list(const CommandSpec& spec, QAction* action, std::function<bool()> enabled);
    const Command* find(const QString& id) const;

    QWidget* window_;
    std::vector<std::unique_ptr<Command>> commands_;
};

/// "Help sentence (Ctrl+K)": what a tooltip says.
QString tooltipText(const CommandSpec& spec);

} // namespace usar::widgets
