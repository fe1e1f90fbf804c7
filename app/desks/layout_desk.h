// The user's own layouts of the docks: saves, shows, renames and deletes them.
#pragma once

#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QThreadPool>

#include "app/desks/desk.h"
#include "widgets/models/layout_store.h"
#include "widgets/panels/layout_dialog.h"

namespace usar::app {

/// Keeps the layouts in a folder beside the settings. Files are read and written in a thread of the pool. Owned by
/// ViewDesk. GUI thread.
class LayoutDesk : public Desk {
    Q_OBJECT
public:
    LayoutDesk(const DeskContext& context, QMainWindow& window);
    /// Waits until all files are written.
    ~LayoutDesk() override { disk_.waitForDone(); }

    void registerCommands() override;
    /// Reads the folder.
    void wire() override;
    /// Fills the menu with the user's layouts whenever it opens, after those that it has.
    void fillMenu(QMenu* menu);
    /// Lets a dock's content add a part to each layout, under the dock's name: `save` gives it, and `restore` takes it,
    /// which is called only if the layout has the part.
    void addView(const QString& dock, std::function<QJsonObject()> save,
                 std::function<void(const QJsonObject&)> restore);
    /// Does `arrange`, which moves docks, as an edit that can be undone.
    void rearrange(const QString& name, const std::function<void()>& arrange);

private:
    struct View {
        std::function<QJsonObject()> save;
        std::function<void(const QJsonObject&)> restore;
    };
    using Layouts = std::map<QString, widgets::DockLayout>;

    void openDialog();
    void connectDialog();
    void save(const QString& name);
    void show(const QString& name);
    void importFrom(const QString& path);
    /// Replaces all layouts, as an edit, and writes what differs.
    void change(const Layouts& layouts, const QString& text);
    void apply(const Layouts& layouts);
    /// Runs `work` in the pool, and then `done` with its result here.
    template <class T>
    void inPool(std::function<Result<T>()> work, std::function<void(const Result<T>&)> done);
    void complain(const Error& error);

    QMainWindow& main_window_;
    widgets::LayoutStore store_;
    Layouts layouts_;
    std::map<QString, View> added_; ///< by the dock's name
    QPointer<widgets::LayoutDialog> dialog_;
    QThreadPool disk_; ///< of one thread, so that newer files are written later
};

} // namespace usar::app
