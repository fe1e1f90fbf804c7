#include "app/desks/map_desk.h"

namespace usar::app {

void MapDesk::registerCommands() {
    auto* const map = views_.map;
    add("map.fit", [map] { map->fit(); });
    add("map.fit_world", [map] { map->fitWorld(); });
    add("map.follow", [map](bool on) { map->setFollowing(on); });
    add("map.zoom_in", [map] { map->zoomIn(); });
    add("map.zoom_out", [map] { map->zoomOut(); });
}

void MapDesk::wire() {
    connect(views_.map, &widgets::MapView::followingChanged, action("map.follow"), &QAction::setChecked);
    connect(views_.layers, &widgets::LayersPanel::layerChanged, views_.map, &widgets::MapView::setLayer);
}

void MapDesk::restore(const QSettings& settings) {
    views_.layers->restoreState(settings.value("layers").toByteArray());
}

void MapDesk::save(QSettings& settings) const {
    settings.setValue("layers", views_.layers->saveState());
}

} // namespace usar::app
