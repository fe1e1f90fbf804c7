// The commands of the Help menu.
#pragma once

#include <QDialog>
#include <QPointer>

#include "widgets/commands/command_registry.h"
#include "widgets/window/tour.h"

namespace usar::widgets {

/// Shows keys, facts and explanations, each in one window at most. GUI thread; what is given must outlive this object.
class WindowHelp {
public:
    WindowHelp(QMainWindow& window, const WindowViews& views, CommandRegistry& commands);

    void registerCommands();
    Tour& tour() { return tour_; }
    const Tour& tour() const { return tour_; }

private:
    QMainWindow& window_;
    CommandRegistry& commands_;
    Tour tour_;
    QPointer<QDialog> sheet_; ///< lists all keys; nullptr while it is closed
    QPointer<QDialog> about_; ///< versions and licenses; nullptr while it is closed
};

} // namespace usar::widgets
