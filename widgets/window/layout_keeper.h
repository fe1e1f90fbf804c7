// The user's own layouts of the docks: saves, shows, renames and deletes them.
#pragma once

#include <functional>
#include <map>

#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QThreadPool>

#include "widgets/commands/command_registry.h"
#include "widgets/models/layout_store.h"
#include "widgets/panels/layout_dialog.h"

namespace usar::widgets {

/// All layouts, by their names.
using Layouts = std::map<QString, DockLayout>;

/// How the window's docks are arranged at a moment, for undo: finer than a layout, but not to be read by people.
struct DockState {
    QByteArray docks{};  ///< by QMainWindow::saveState
    QJsonObject views{}; ///< of those contents that have changed with the docks, by the dock's name
    bool operator==(const DockState&) const = default;
};

/// Keeps the layouts in a folder. Files are read and written in a thread of the pool. What the user changes is told as
/// an edit, for a history that can take it back. GUI thread; window and registry must outlive this object.
class LayoutKeeper : public QObject {
    Q_OBJECT
public:
    /// The folder is made when the first layout is saved.
    LayoutKeeper(QMainWindow& window, CommandRegistry& commands, const QString& folder);
    /// Waits until all files are written.
    ~LayoutKeeper() override { disk_.waitForDone(); }

    /// Registers the commands that open the dialog, and lets the palette offer each layout.
    void registerCommands();
    /// Reads the folder.
    void read();
    /// Fills the menu with the user's layouts whenever it opens, after what it has now.
    void fillMenu(QMenu* menu);
    /// Lets a dock's content add a part to each layout, under the dock's name: `save` gives it, and `restore` takes it,
    /// which is called only if the layout has the part.
    void addView(const QString& dock, std::function<QJsonObject()> save,
                 std::function<void(const QJsonObject&)> restore);
    /// Does `arrange`, which moves docks, as an edit: the layout `name` is shown.
    void rearrange(const QString& name, const std::function<void()>& arrange);

    const Layouts& layouts() const { return layouts_; }
    /// Replaces all layouts, and writes what differs; this is no edit.
    void setLayouts(const Layouts& layouts);
    /// Arranges the docks as they were; this is no edit.
    void setDocks(const DockState& state);

signals:
    /// The docks were arranged in another way. `text`: what was done.
    void docksEdited(const QString& text, const usar::widgets::DockState& before,
                     const usar::widgets::DockState& after);
    /// A layout was saved, renamed, deleted or imported.
    void layoutsEdited(const QString& text, const usar::widgets::Layouts& before, const usar::widgets::Layouts& after);
    /// A file cannot be read or written. The dialog says it, too.
    void failed(const usar::Error& error);

private:
    struct View {
        std::function<QJsonObject()> save;
        std::function<void(const QJsonObject&)> restore;
    };

    void openDialog();
    void connectDialog();
    void save(const QString& name);
    void show(const QString& name);
    void importFrom(const QString& path);
    void exportTo(const QString& path, const DockLayout& layout);
    /// Replaces all layouts, as an edit.
    void change(const Layouts& layouts, const QString& text);
    /// The present state; `views`: the names of the contents that belong to it.
    DockState docks(const QStringList& views) const;
    void restoreViews(const QJsonObject& views);
    /// The same as `rearrange`, and the contents of these docks change, too.
    void rearrange(const QString& name, const QStringList& views, const std::function<void()>& arrange);
    /// Runs `work` in the pool, and then `done` with its result here.
    template <class T>
    void inPool(std::function<Result<T>()> work, std::function<void(const Result<T>&)> done);
    /// Runs work of which nobody needs the result, unless it fails.
    void inPool(std::function<Result<void>()> work);
    void complain(const Error& error);

    QMainWindow& window_;
    CommandRegistry& commands_;
    LayoutStore store_;
    Layouts layouts_;
    std::map<QString, View> added_; ///< by the dock's name
    QPointer<LayoutDialog> dialog_;
    QThreadPool disk_; ///< of one thread, so that newer files are written later
};

} // namespace usar::widgets
