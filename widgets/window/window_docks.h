// The window's docks as a whole: the layouts that it comes with, a command for each dock, and which docks still wait.
#pragma once

#include "widgets/commands/command_registry.h"
#include "widgets/window/dock_opener.h"
#include "widgets/window/layout_keeper.h"
#include "widgets/window/window_views.h"

namespace usar::widgets {

/// The layouts begin from the first layout, in which the docks stand when the window is new. GUI thread; what is given
/// must outlive this object.
class WindowDocks : public QObject {
    Q_OBJECT
public:
    /// `own`: tells that one of these layouts is shown, as it does for those of the user.
    WindowDocks(QMainWindow& window, const WindowViews& views, CommandRegistry& commands, LayoutKeeper& own);

    /// Registers the layouts, and one command for each dock, which shows or hides it.
    void registerCommands();
    /// Opens docks when they get something to show for the first time, and gives the list of robots its room. Other
    /// views must be connected first, so that what they show is there.
    void wire();
    /// Keeps the present layout as the first one. To be called before `restore`.
    /// Gives the window its first size, which is at most the screen's, and keeps the layout for View > Operate.
    void keepFirstLayout();
    /// A robot is selected: opens the docks that show what it says, if they wait.
    void showForRobot();

    /// Places and sizes of all docks and bars, for the settings.
    QByteArray state() const { return window_.saveState(version); }
    /// The docks that wait, for the settings.
    QStringList waiting() const { return opener_.waiting(); }
    /// Restores both. A state of another version of the docks is ignored. `sized`: so has been the window's size.
    void restore(bool sized, const QByteArray& state, const QStringList& waiting);

private:
    /// Increased with each change of the docks; older states are ignored.
    static constexpr int version = 8;

    /// Registers a layout. If `raised` is not null, this bottom dock is in front, and the bottom docks get this
    /// fraction of the height.
    void addLayout(const char* id, QDockWidget* raised, double bottom_part);
    void addCommand(QDockWidget* dock);
    /// A sight of the map, or a table with its head, needs more height than a list: at least this part of what it
    /// shares with the map.
    void giveRoom(QDockWidget* dock, double part);
    void resizeToScreen();
    void arrange(QDockWidget* raised, double bottom_part);
    /// Makes the list of robots as tall as its robots need, as long as the docks below it keep enough.
    void giveRobotsRoom();

    QMainWindow& window_;
    const WindowViews& views_;
    CommandRegistry& commands_;
    LayoutKeeper& own_;
    DockOpener opener_;
    QByteArray first_layout_;
};

} // namespace usar::widgets
