// How the window looks: theme, layouts of its docks, and the helps that explain it.
#pragma once

#include <optional>

#include <QMainWindow>
#include <QObject>
#include <QSettings>

#include "app/desks/desk.h"
#include "widgets/style/theme.h"

namespace usar::app {

/// GUI thread.
class ViewDesk : public QObject {
    Q_OBJECT
public:
    /// `theme`: as the command line wants it; absent: as it was last.
    ViewDesk(const DeskContext& context, QMainWindow& window, std::optional<widgets::Theme> theme);

    void registerCommands();
    void registerLayouts();
    /// The layouts begin from the window as it is now.
    void keepFirstLayout() { first_layout_ = window_.saveState(layout_version); }
    void restore(const QSettings& settings);
    void save(QSettings& settings) const;

private:
    void setTheme(widgets::Theme theme);
    /// The first layout, with the bottom dock `raised` and this part of the height given to the bottom docks.
    void arrange(QDockWidget* raised, double bottom_part);

    static constexpr int layout_version = 5; ///< a layout saved by an older set of docks is not restored

    DeskContext desk_;
    QMainWindow& window_;
    std::optional<widgets::Theme> theme_;
    QByteArray first_layout_;
};

} // namespace usar::app
