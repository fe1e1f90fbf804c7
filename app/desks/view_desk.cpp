#include "app/desks/view_desk.h"

#include <algorithm>
#include <cmath>

#include <QWhatsThis>

#include "widgets/commands/command_palette.h"
#include "widgets/commands/help.h"

namespace usar::app {

namespace {

/// The docks that have nothing to show at a first start, or nothing that a person must see then.
QList<QDockWidget*> waitingDocks(const widgets::WindowViews& views) {
    static const QStringList needed{"robots", "behavior"};
    QList<QDockWidget*> docks;
    for (QDockWidget* const dock : views.docks)
        if (!needed.contains(dock->objectName()))
            docks << dock;
    return docks;
}

} // namespace

ViewDesk::ViewDesk(const DeskContext& context, QMainWindow& window, std::optional<widgets::Theme> theme)
    : Desk(context)
    , history_(context)
    , layouts_(context, window)
    , keys_(context)
    , opener_(waitingDocks(context.views))
    , main_window_(window)
    , theme_(theme) {}

void ViewDesk::registerCommands() {
    history_.registerCommands();
    layouts_.registerCommands();
    keys_.registerCommands();
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
    commands_.offer([this] { return plots(); });
    addLayout("view.operate", nullptr, 0.0);
    addLayout("view.analyse", views_.plots_dock, 0.6);
    addLayout("view.debug", views_.messages_dock, 0.6);
    addLayout("view.plan", views_.plan_dock, 0.6);
    registerHelpCommands();
    for (QDockWidget* dock : views_.docks) {
        const widgets::CommandSpec spec{.id = "view.dock." + dock->objectName(),
                                        .text = dock->windowTitle(),
                                        .group = tr("View"),
                                        .help = tr("Shows this dock, or hides it if it is in front"),
                                        .checkable = true,
                                        .wish = tr("Show %1").arg(dock->windowTitle())};
        QAction* const shown = commands_.add(spec, [dock](bool) {
            if (dock->isHidden() || dock->visibleRegion().isEmpty()) // It may be behind another tab.
                raise(dock);
            else
                dock->hide();
        });
        connect(dock, &QDockWidget::visibilityChanged, shown, [dock, shown] { shown->setChecked(!dock->isHidden()); });
    }
}

void ViewDesk::registerHelpCommands() {
    add("help.what", [this] {
        widgets::explainParts(main_window_);
        QWhatsThis::enterWhatsThisMode();
    });
    add("help.about", [this] {
        if (!about_) {
            about_ = widgets::makeAbout(&main_window_);
            about_->setAttribute(Qt::WA_DeleteOnClose);
        }
        about_->show();
        about_->raise();
        about_->activateWindow();
    });
}

std::vector<widgets::PaletteOffer> ViewDesk::plots() const {
    views_.sensors->refresh(); // It does not while it is hidden.
    std::vector<widgets::PaletteOffer> offers;
    const widgets::SensorModel& sensors = views_.sensors->model();
    for (int source = 0; source < sensors.rowCount(); ++source) {
        const QModelIndex parent = sensors.index(source, 0);
        for (int leaf = 0; leaf < sensors.rowCount(parent); ++leaf) {
            const QModelIndex field = sensors.index(leaf, 0, parent);
            const QString path = field.data(widgets::SensorModel::PathRole).toString();
            if (!field.data(widgets::SensorModel::NumericRole).toBool())
                continue;
            const QString unit = field.data(widgets::SensorModel::UnitRole).toString();
            offers.push_back({tr("Plot %1").arg(path), tr("Sensors"), {"graph", "chart", "curve"}, [this, path, unit] {
                                  raise(views_.plots_dock);
                                  views_.plots->addSeries(path, unit);
                              }});
        }
    }
    return offers;
}

void ViewDesk::wire() {
    history_.wire();
    layouts_.wire();
    keys_.wire();
    connect(views_.map, &widgets::MapView::followingChanged, action("map.follow"), &QAction::setChecked);
    connect(views_.robots, &widgets::RobotList::wholeHeightChanged, this, &ViewDesk::giveRobotsRoom);
    connect(views_.layers, &widgets::LayersPanel::layerChanged, views_.map, &widgets::MapView::setLayer);
    widgets::HeightLayer* const heights = &views_.map->heights();
    widgets::HeightControls* const look = views_.layers->heightControls();
    connect(look, &widgets::HeightControls::lookChanged, heights, &widgets::HeightLayer::setLook);
    connect(heights, &widgets::HeightLayer::changed, look, [=] { look->setShownRange(heights->range()); });
    connect(views_.sensors, &widgets::SensorPanel::plotRequested, this,
            [this] { opener_.showFirst(views_.plots_dock); });
    connect(&selection_, &Selection::changed, this, [this](RobotId id) {
        for (QDockWidget* const dock : views_.docks)
            if (id.valid() && (dock->objectName() == "instruments" || dock->objectName() == "sensors"))
                opener_.showFirst(dock);
    });
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

void ViewDesk::addLayout(const char* id, QDockWidget* raised, double bottom_part) {
    const QString name = widgets::commandSpec(id).text.section(": ", 1);
    add(id,
        [this, name, raised, bottom_part] { layouts_.rearrange(name, [=, this] { arrange(raised, bottom_part); }); });
}

void ViewDesk::arrange(QDockWidget* raised, double bottom_part) {
    opener_.keepDuring(raised, [this, raised] {
        main_window_.restoreState(first_layout_, layout_version);
        if (raised)
            raised->show();
    });
    if (raised) {
        raised->raise();
        const int whole_px = main_window_.centralWidget()->parentWidget()->height();
        main_window_.resizeDocks({raised}, {static_cast<int>(std::lround(bottom_part * whole_px))}, Qt::Vertical);
    }
    giveRobotsRoom();
}

void ViewDesk::giveRobotsRoom() {
    QDockWidget* const dock = views_.robots_dock;
    if (dock->isHidden() || dock->isFloating() || !main_window_.tabifiedDockWidgets(dock).isEmpty())
        return;
    constexpr int least_px = 110;  // The list is never lower, even when it is empty.
    constexpr int others_px = 300; // The docks below it need this.
    const int column_px = main_window_.height() - main_window_.centralWidget()->y();
    constexpr int rounding_px = 4; // The main window deals out heights in whole shares.
    const int title_px = dock->height() - views_.robots->height() + rounding_px;
    const int robots_px =
        std::clamp(views_.robots->wholeHeight_px() + title_px, least_px, std::max(least_px, column_px - others_px));
    main_window_.resizeDocks({dock, views_.docks[1]}, {robots_px, column_px - robots_px}, Qt::Vertical);
}

void ViewDesk::restore(const QSettings& settings) {
    const QString theme = settings.value("theme", "dark").toString();
    setTheme(theme_.value_or(theme == "light" ? widgets::Theme::Light : widgets::Theme::Dark));
    main_window_.restoreGeometry(settings.value("geometry").toByteArray());
    main_window_.restoreState(settings.value("layout").toByteArray(), layout_version);
    opener_.begin(settings.value("waiting_docks", opener_.waiting()).toStringList());
    views_.hint->setDismissed(settings.value("hint_dismissed", false).toBool());
    views_.layers->restoreState(settings.value("layers").toByteArray());
    history_.keepLayers();
}

void ViewDesk::save(SettingsSheet& settings) const {
    settings.setValue("theme", widgets::currentTheme() == widgets::Theme::Light ? "light" : "dark");
    settings.setValue("geometry", main_window_.saveGeometry());
    settings.setValue("layout", main_window_.saveState(layout_version));
    settings.setValue("waiting_docks", opener_.waiting());
    settings.setValue("hint_dismissed", views_.hint->dismissed());
    settings.setValue("layers", views_.layers->saveState());
}

} // namespace usar::app
