// Desk for the look of the window: theme, layouts of the docks, the view and layers of the map, command palette and
// help.
#pragma once

#include <optional>

#include <QDialog>
#include <QMainWindow>
#include <QPointer>

#include "app/desks/history_desk.h"
#include "app/desks/key_desk.h"
#include "app/desks/layout_desk.h"
#include "widgets/style/theme.h"
#include "widgets/window/dock_opener.h"

namespace usar::app {

/// Switches the theme, arranges the docks, and fits, zooms and follows on the map. Theme, docks and visible layers are
/// kept in the settings. GUI thread.
class ViewDesk : public Desk {
    Q_OBJECT
public:
    /// `theme`: the one that the command line asks for; nullopt: the one used last.
    ViewDesk(const DeskContext& context, QMainWindow& window, std::optional<widgets::Theme> theme);

    /// Also registers one command per dock, which shows or hides it.
    void registerCommands() override;
    void wire() override;
    /// Keeps the current layout, from which the layout commands start. To be called before `restore`.
    void keepFirstLayout() { first_layout_ = main_window_.saveState(layout_version); }
    /// The user's own layouts.
    LayoutDesk& layouts() { return layouts_; }
    void restore(const QSettings& settings) override;
    void save(SettingsSheet& settings) const override;

private:
    void setTheme(widgets::Theme theme);
    /// Makes the list of robots as tall as its robots need, as long as the docks below it keep enough.
    void giveRobotsRoom();
    /// Registers a built-in layout. It restores the first layout and, if `raised` is not null, raises this bottom dock,
    /// and gives the bottom docks this fraction of the height.
    void addLayout(const char* id, QDockWidget* raised, double bottom_part);
    void arrange(QDockWidget* raised, double bottom_part);

    static constexpr int layout_version = 6; ///< increased with each change of the docks; older layouts are ignored

    void registerHelpCommands();
    /// For the palette: each number that the selected robot's sensors say can be plotted.
    std::vector<widgets::PaletteOffer> plots() const;

    HistoryDesk history_;
    LayoutDesk layouts_;
    KeyDesk keys_;
    widgets::DockOpener opener_;
    QMainWindow& main_window_;
    std::optional<widgets::Theme> theme_;
    QByteArray first_layout_;
    QPointer<QDialog> about_; ///< versions and licenses; nullptr while it is closed
};

} // namespace usar::app
