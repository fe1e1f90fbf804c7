#include "app/desks/map_desk.h"

namespace usar::app {

void MapDesk::registerCommands() {
    auto* const map = desk_.views.map;
    desk_.commands.add({"map.fit",
                        tr("Fit mission"),
                        tr("Map"),
                        tr("Shows the area and all that was scanned"),
                        "fit",
                        {QKeySequence("F")}},
                       [map](bool) { map->fit(); });
    desk_.commands.add(
        {"map.fit_world", tr("Fit world"), tr("Map"), tr("Shows the whole world"), "", {QKeySequence("Home")}},
        [map](bool) { map->fitWorld(); });
    desk_.commands.add({"map.follow",
                        tr("Follow robot"),
                        tr("Map"),
                        tr("Keeps the selected robot in the middle"),
                        "follow",
                        {QKeySequence("Shift+F")},
                        true},
                       [map](bool on) { map->setFollowing(on); });
    desk_.commands.add({"map.zoom_in", tr("Zoom in"), tr("Map"), tr("Closer"), "", {QKeySequence::ZoomIn}},
                       [map](bool) { map->zoomIn(); });
    desk_.commands.add({"map.zoom_out", tr("Zoom out"), tr("Map"), tr("Farther away"), "", {QKeySequence::ZoomOut}},
                       [map](bool) { map->zoomOut(); });
}

void MapDesk::wire() {
    connect(desk_.views.map, &widgets::MapView::followingChanged, desk_.commands.action("map.follow"),
            &QAction::setChecked);
    connect(desk_.views.layers, &widgets::LayersPanel::layerChanged, desk_.views.map, &widgets::MapView::setLayer);
}

void MapDesk::restore(const QSettings& settings) {
    desk_.views.layers->restoreState(settings.value("layers").toByteArray());
}

void MapDesk::save(QSettings& settings) const {
    settings.setValue("layers", desk_.views.layers->saveState());
}

} // namespace usar::app
