// Desk for the look of the window: theme, docks, keys, the view and layers of the map, command palette, history and
// help.
#pragma once

#include <QMainWindow>
#include <QThreadPool>

#include "app/desks/desk.h"
#include "widgets/commands/key_file.h"
#include "widgets/commands/theme_chooser.h"
#include "widgets/window/layout_keeper.h"
#include "widgets/window/window_docks.h"
#include "widgets/window/window_help.h"

namespace usar::app {

/// Lets the theme be chosen, arranges the docks, undoes and redoes, and fits, zooms and follows on the map. Theme,
/// docks, plots and visible layers are kept in the settings; keys and layouts in files beside them. GUI thread.
class ViewDesk : public Desk {
    Q_OBJECT
public:
    /// `theme`: the one that the command line asks for; empty: the one used last.
    ViewDesk(const DeskContext& context, QMainWindow& window, const QString& theme);

    void registerCommands() override;
    void wire() override;
    widgets::WindowDocks& docks() { return docks_; }
    /// The user's own layouts.
    widgets::LayoutKeeper& layouts() { return layouts_; }
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

private:
    /// Asks where to save what the 3D view shows, and writes it in a worker.
    void saveReliefPicture();
    /// Shows the manual in the browser, or says how to get it.
    void openManual();
    /// For the palette: each number that the selected robot's sensors say can be plotted.
    std::vector<widgets::PaletteOffer> plots() const;
    /// Connects what is edited in views to the history, and the history to its dock and commands.
    void wireHistory();
    /// Names the commands after what they would undo and redo.
    void showHistory();
    /// Reads the user's keys and layouts, and connects what is edited in them to the history.
    void wireFiles();
    void showPlots(const QJsonObject& plots);
    /// Shows what the notification with this key is about: selects its robot, and raises or opens the place.
    void goTo(const QString& notice_key);

    widgets::LayoutKeeper layouts_;
    widgets::WindowDocks docks_;
    widgets::KeyFile keys_;
    widgets::ThemeChooser themes_;
    widgets::WindowHelp help_;
    QMainWindow& main_window_;
    QString theme_;
    QThreadPool pool_; ///< its destructor waits
};

} // namespace usar::app
