#include "app/desks/view_desk.h"

#include <cmath>

#include "widgets/commands/command_palette.h"
#include "widgets/commands/shortcut_sheet.h"

namespace usar::app {

ViewDesk::ViewDesk(const DeskContext& context, QMainWindow& window, std::optional<widgets::Theme> theme)
    : Desk(context)
    , main_window_(window)
    , theme_(theme) {}

void ViewDesk::registerCommands() {
    auto* const map = views_.map;
    add("map.fit", [map] { map->fit(); });
    add("map.fit_world", [map] { map->fitWorld(); });
    add("map.follow", [map](bool on) { map->setFollowing(on); });
    add("map.zoom_in", [map] { map->zoomIn(); });
    add("map.zoom_out", [map] { map->zoomOut(); });
    add("view.dark", [this](bool dark) { setTheme(dark ? widgets::Theme::Dark : widgets::Theme::Light); });
    add("view.hint", [this] { views_.hint->setDismissed(false); });
    auto* palette = new widgets::CommandPalette(commands_, &main_window_);
    add("view.palette", [palette] { palette->open(); });
    add("help.shortcuts", [this] {
        if (!sheet_) {
            sheet_ = widgets::makeShortcutSheet(commands_, &main_window_);
            sheet_->setAttribute(Qt::WA_DeleteOnClose);
        }
        sheet_->show();
        sheet_->raise();
        sheet_->activateWindow();
    });
    add("view.operate", [this] { arrange(views_.plots_dock, 0.25); });
    add("view.analyse", [this] { arrange(views_.plots_dock, 0.6); });
    add("view.debug", [this] { arrange(views_.messages_dock, 0.6); });
    add("view.plan", [this] { arrange(views_.plan_dock, 0.6); });
    for (QDockWidget* dock : views_.docks) {
        const widgets::CommandSpec spec{.id = "view.dock." + dock->objectName(),
                                        .text = dock->windowTitle(),
                                        .group = tr("View"),
                                        .help = tr("Shows this dock, or hides it if it is in front"),
                                        .checkable = true};
        QAction* const shown = commands_.add(spec, [dock](bool) {
            if (dock->isHidden() || dock->visibleRegion().isEmpty()) // It may be behind another tab.
                raise(dock);
            else
                dock->hide();
        });
        connect(dock, &QDockWidget::visibilityChanged, shown, [dock, shown] { shown->setChecked(!dock->isHidden()); });
    }
}

void ViewDesk::wire() {
    connect(views_.map, &widgets::MapView::followingChanged, action("map.follow"), &QAction::setChecked);
    connect(views_.layers, &widgets::LayersPanel::layerChanged, views_.map, &widgets::MapView::setLayer);
    connect(&selection_, &Selection::changed, this,
            [this] { views_.hint->setInReplay(robot() && robot()->isReplay()); });
    const auto key = [this](const char* id) { return action(id)->shortcut().toString(QKeySequence::NativeText); };
    views_.hint->setWhatNext(tr("On its way. In the simulator, %1 makes time run faster. %2 pauses the robot. At the "
                                "end a card shows the result.")
                                 .arg(key("time.faster"), key("mission.pause")));
}

void ViewDesk::setTheme(widgets::Theme theme) {
    widgets::applyTheme(theme);
    action("view.dark")->setChecked(theme == widgets::Theme::Dark);
}

void ViewDesk::arrange(QDockWidget* raised, double bottom_part) {
    main_window_.restoreState(first_layout_, layout_version);
    raised->raise();
    const int whole_px = main_window_.centralWidget()->parentWidget()->height();
    main_window_.resizeDocks({raised}, {static_cast<int>(std::lround(bottom_part * whole_px))}, Qt::Vertical);
}

void ViewDesk::restore(const QSettings& settings) {
    const QString theme = settings.value("theme", "dark").toString();
    setTheme(theme_.value_or(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark));
    main_window_.restoreGeometry(settings.value("geometry").toByteArray());
    main_window_.restoreState(settings.value("layout").toByteArray(), layout_version);
    views_.hint->setDismissed(settings.value("hint_dismissed", false).toBool());
    views_.layers->restoreState(settings.value("layers").toByteArray());
}

void ViewDesk::save(SettingsSheet& settings) const {
    settings.setValue("theme", widgets::currentTheme() == widgets::Theme::Light ? "light" : "dark");
    settings.setValue("geometry", main_window_.saveGeometry());
    settings.setValue("layout", main_window_.saveState(layout_version));
    settings.setValue("hint_dismissed", views_.hint->dismissed());
    settings.setValue("layers", views_.layers->saveState());
}

} // namespace usar::app
