#include "app/desks/view_desk.h"

#include <cmath>

#include "widgets/commands/command_palette.h"
#include "widgets/commands/shortcut_sheet.h"

namespace usar::app {

namespace {

const QList<std::pair<QString, QString>> gestures{
    {QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
    {QObject::tr("Click a start pose"), QObject::tr("Choose class, name and behavior first")},
    {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area; its handles change it")},
    {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
    {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
    {QObject::tr("W S, A D, Q E, R F held while you drive"),
     QObject::tr("Forward and back, round, sideways, up and down; Shift slower, Space stops")},
    {QObject::tr("Drag the camera's picture, wheel on it"), QObject::tr("Turn the camera, zoom it")},
    {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
    {QObject::tr("Press an object in the palette, click on the map"), QObject::tr("Put it into the world")},
    {QObject::tr("Drag an object"), QObject::tr("Move it")}};

} // namespace

ViewDesk::ViewDesk(const DeskContext& context, QMainWindow& window, std::optional<widgets::Theme> theme)
    : desk_(context)
    , window_(window)
    , theme_(theme) {}

void ViewDesk::registerCommands() {
    desk_.commands.add(
        {"view.dark", tr("Dark theme"), tr("View"), tr("Dark or light"), "moon", {QKeySequence("Ctrl+T")}, true},
        [this](bool dark) { setTheme(dark ? widgets::Theme::Dark : widgets::Theme::Light); });
    desk_.commands.add({"view.hint", tr("First steps"), tr("View"), tr("The three-step hint above the map"), "", {}},
                       [this](bool) { desk_.views.hint->show(); });
    auto* palette = new widgets::CommandPalette(desk_.commands, &window_);
    desk_.commands.add({"view.palette",
                        tr("Command palette"),
                        tr("View"),
                        tr("Any command by a few letters"),
                        "",
                        {QKeySequence("Ctrl+K")}},
                       [palette](bool) { palette->open(); });
    desk_.commands.add({"help.shortcuts",
                        tr("Shortcuts"),
                        tr("Help"),
                        tr("All keys and gestures on one sheet"),
                        "",
                        {QKeySequence("F1")}},
                       [this](bool) {
                           auto* sheet = new widgets::ShortcutSheet(desk_.commands, gestures, &window_);
                           sheet->setAttribute(Qt::WA_DeleteOnClose);
                           sheet->show();
                       });
}

void ViewDesk::registerLayouts() {
    desk_.commands.add({"view.operate",
                        tr("Layout: operate"),
                        tr("View"),
                        tr("All docks where they were at first, the map largest"),
                        "reset",
                        {QKeySequence("Ctrl+F1")}},
                       [this](bool) { arrange(desk_.views.plots_dock, 0.25); });
    desk_.commands.add({"view.analyse",
                        tr("Layout: analyse"),
                        tr("View"),
                        tr("Plots large, below a small map"),
                        "plot",
                        {QKeySequence("Ctrl+F2")}},
                       [this](bool) { arrange(desk_.views.plots_dock, 0.6); });
    desk_.commands.add({"view.debug",
                        tr("Layout: debug"),
                        tr("View"),
                        tr("Messages large, below a small map"),
                        "message",
                        {QKeySequence("Ctrl+F3")}},
                       [this](bool) { arrange(desk_.views.messages_dock, 0.6); });
    desk_.commands.add({"view.plan",
                        tr("Layout: plan"),
                        tr("View"),
                        tr("The plan of the selected robot large, below a small map"),
                        "",
                        {QKeySequence("Ctrl+F4")}},
                       [this](bool) { arrange(desk_.views.plan_dock, 0.6); });
    for (QDockWidget* dock : desk_.views.docks) {
        connect(dock->toggleViewAction(), &QAction::triggered, dock, [dock](bool shown) {
            if (shown)
                dock->raise(); // It may be one of several tabs.
        });
        desk_.commands.adopt({"view.dock." + dock->objectName(),
                              dock->windowTitle(),
                              tr("View"),
                              tr("Shows or hides this dock"),
                              "",
                              {}},
                             dock->toggleViewAction());
    }
}

void ViewDesk::setTheme(widgets::Theme theme) {
    widgets::applyTheme(theme);
    desk_.commands.action("view.dark")->setChecked(theme == widgets::Theme::Dark);
}

void ViewDesk::arrange(QDockWidget* raised, double bottom_part) {
    window_.restoreState(first_layout_, layout_version);
    raised->raise();
    const int whole_px = window_.centralWidget()->parentWidget()->height();
    window_.resizeDocks({raised}, {static_cast<int>(std::lround(bottom_part * whole_px))}, Qt::Vertical);
}

void ViewDesk::restore(const QSettings& settings) {
    const QString theme = settings.value("theme", "dark").toString();
    setTheme(theme_.value_or(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark));
    window_.restoreGeometry(settings.value("geometry").toByteArray());
    window_.restoreState(settings.value("layout").toByteArray(), layout_version);
    desk_.views.hint->setVisible(!settings.value("hint_dismissed", false).toBool());
}

void ViewDesk::save(QSettings& settings) const {
    settings.setValue("theme", widgets::currentTheme() == widgets::Theme::Light ? "light" : "dark");
    settings.setValue("geometry", window_.saveGeometry());
    settings.setValue("layout", window_.saveState(layout_version));
    settings.setValue("hint_dismissed", desk_.views.hint->isHidden());
}

} // namespace usar::app
