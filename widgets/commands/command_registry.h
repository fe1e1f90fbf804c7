// Registry of all actions of the program: menus, tool bars, shortcuts, palette, tooltips, help sheet and tests are made
// from it.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include <QAction>
#include <QKeySequence>
#include <QMenuBar>
#include <QObject>

namespace usar::widgets {

/// Description of a command as its author writes it.
struct CommandSpec {
    QString id;                      ///< "map.fit"
    QString text;                    ///< "Fit mission in view": shown in menus and the palette
    QString group;                   ///< "Map": group of related commands, a heading of the help sheet
    QString help{};                  ///< one sentence; the tooltip appends the shortcut
    QString icon{};                  ///< icon name for icons.h; may be empty
    QList<QKeySequence> shortcuts{}; ///< the first one is shown in tooltips; no two commands may share one
    bool checkable = false;          ///< the action has an on/off state
    QKeySequence twice{};            ///< one key that also runs the command when it is pressed twice; see KeyTwice
    QString question{};  ///< asked before a key runs the command, or switches it off; %1: robot; empty: never
    QString answer{};    ///< the answer that runs it: "Land"
    QStringList words{}; ///< other words for it, by which the palette finds it
    QString button{};    ///< a shorter text below an icon; empty: the text
    bool sends = false;  ///< a robot or the world gets a command that cannot be taken back
    QString
        wish{}; ///< the text with a verb, for the palette, which never switches it off: "Show Camera"; empty: the text
};

/// Something that the palette offers beside the commands because it comes and goes: "Select R1".
struct PaletteOffer {
    QString text;
    QString group;
    QStringList words{}; ///< other words for it
    std::function<void()> run;
};

/// The keys of commands by their ids.
using KeyChoices = std::map<QString, QList<QKeySequence>>;

/// Owns the actions and adds them to the window, so that shortcuts work wherever the focus is; only those that are a
/// single key without Ctrl or Alt work in a few places alone (`setPlacesOfPlainKeys`), or what is typed elsewhere would
/// move a robot. GUI thread; must not outlive the window.
class CommandRegistry : public QObject {
    Q_OBJECT
public:
    explicit CommandRegistry(QWidget* window);

    /// Registers a command and makes its action. `run` is called with the checked state; `enabled` is evaluated now and
    /// by refresh(). An id or shortcut that is already used is a programming error (assertion).
    QAction* add(const CommandSpec& spec, std::function<void(bool)> run, std::function<bool()> enabled = {});
    /// Registers an action that somebody else made and runs (for example a dock's own toggle); its text and shortcuts
    /// are set from the spec. The action must live as long as the window.
    void adopt(const CommandSpec& spec, QAction* action);
    /// Returns the action; an unknown id is a programming error (assertion).
    QAction* action(const QString& id) const;
    bool contains(const QString& id) const { return find(id) != nullptr; }

    /// A registered command with its action; an empty `enabled` means that the command is always enabled.
    struct Command {
        CommandSpec spec;
        QAction* action = nullptr;
        std::function<bool()> enabled;
        QList<QKeySequence> first_keys{}; ///< those of the table; `spec` has the present ones
    };
    /// In the order of registration.
    const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
    /// The widgets in which a single key runs its command while one of them, or a part of it, has the focus. Before
    /// this call it does so everywhere; to be called once, after all commands have been added.
    void setPlacesOfPlainKeys(const QList<QWidget*>& places);
    /// Gives the command these keys instead of its present ones; none of them may be another command's (assertion).
    void setKeys(const QString& id, const QList<QKeySequence>& keys);
    /// Gives all commands the keys of the table again, and then these. Ids that do not exist are ignored, and so are
    /// keys that another command has by then.
    void takeKeys(const KeyChoices& keys);
    /// The keys that differ from those of the table.
    KeyChoices changedKeys() const;
    /// The command that this key runs; nullptr if none does.
    const Command* ownerOf(const QKeySequence& key) const;
    /// Evaluates every `enabled` rule again; call it when state that the rules depend on has changed.
    void refresh();

    /// Lets the palette offer what `provider` returns whenever the palette opens.
    void offer(std::function<std::vector<PaletteOffer>()> provider) { providers_.push_back(std::move(provider)); }
    /// What can be done at this moment beside the commands, in the order in which the providers were added.
    std::vector<PaletteOffer> offers() const;

    /// Appends these commands in order; an id "-" makes a separator, and "view.dock.*" stands for all that begin so.
    void fill(QMenu* menu, const QStringList& ids) const;

signals:
    /// A key was pressed for a command that has a question; `run` does what it asks about.
    void questionRaised(const usar::widgets::CommandSpec& spec, const std::function<void()>& run);
    /// By setKeys or takeKeys.
    void keysChanged();
    /// A command that `sends` has run.
    void sent(const usar::widgets::CommandSpec& spec);

private:
    void list(const CommandSpec& spec, QAction* action, std::function<bool()> enabled);
    Command* find(const QString& id) const;
    /// Replaces the keys without telling.
    void give(Command& command, const QList<QKeySequence>& keys);
    /// Lets the keys of the action work in the whole window, or only in the places of plain keys.
    void place(const Command& command);

    QWidget* window_;
    QList<QWidget*> places_; ///< of plain keys; empty: the whole window
    std::vector<std::unique_ptr<Command>> commands_;
    std::vector<std::function<std::vector<PaletteOffer>()>> providers_;
};

/// "Help sentence (Ctrl+K)": the help, or the text if there is no help, with the first shortcut.
QString tooltipText(const CommandSpec& spec);

/// Reads a table of commands: an object of groups, each an object of commands by id, with `text`, `help`, and possibly
/// `icon`, `button`, `keys`, `checkable`, `twice`, `question`, `answer`, `sends` and `words`, which are separated by
/// commas. A
/// key is written as in a menu ("Ctrl+K"), or names one that differs by desktop ("StandardKey::Open"). Text that is no
/// JSON object is read as an empty table.
std::vector<CommandSpec> readCommandTable(const QByteArray& json);

/// All commands of the program's own table, sorted by group and id.
const std::vector<CommandSpec>& commandTable();
/// The command with this id; an unknown id is a programming error (assertion).
const CommandSpec& commandSpec(const QString& id);

/// Fills the menu bar as the program's table says (resources/menus.json): a list of menus, each with a `title` and
/// `items`. An item is a text of command ids, "-" for a separator, or the beginning of ids ("view.dock.*") for all that
/// begin so; or a submenu, which may have `items`, too. Returns the submenus by name. All commands must be registered
/// before.
std::map<QString, QMenu*> makeMenus(QMenuBar& bar, const CommandRegistry& commands);

} // namespace usar::widgets
