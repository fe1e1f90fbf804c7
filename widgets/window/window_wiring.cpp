#include "widgets/window/window_wiring.h"

namespace usar::widgets {

namespace {

void raise(QDockWidget* dock) {
    dock->show();
    dock->raise();
}

void wireArea(MapView* map, BehaviorPanel* panel) {
    MapGestures* const gestures = &map->gestures();
    QObject::connect(gestures, &MapGestures::areaEdited, panel, &BehaviorPanel::setArea);
    QObject::connect(gestures, &MapGestures::areaChanged, panel, [map, panel](const Rectangle& area) {
        panel->setArea(area);
        map->setTool(MapTool::Pan);
    });
    QObject::connect(gestures, &MapGestures::toolChanged, panel,
                     [panel](MapTool tool) { panel->setAreaToolActive(tool == MapTool::Area); });
    QObject::connect(panel, &BehaviorPanel::areaTyped, map,
                     [map](const Rectangle& area) { map->setArea(area.empty() ? std::nullopt : std::optional(area)); });
    QObject::connect(panel, &BehaviorPanel::areaToolToggled, map,
                     [map](bool active) { map->setTool(active ? MapTool::Area : MapTool::Pan); });
}

void wireNotifications(const WindowViews& views) {
    QDockWidget* const dock = views.notifications_dock;
    QObject::connect(views.notifications, &NotificationCenter::unreadChanged, dock, [dock](int unread) {
        dock->setWindowTitle(unread ? QObject::tr("Notifications (%1)").arg(unread) : QObject::tr("Notifications"));
    });
    QObject::connect(views.toasts, &ToastStack::openRequested, dock, [dock] { raise(dock); });
}

} // namespace

void wireViews(const WindowViews& views) {
    wireArea(views.map, views.behavior);
    wireNotifications(views);
    QObject::connect(&views.map->gestures(), &MapGestures::toolChanged, views.world,
                     [world = views.world](MapTool tool) {
                         if (tool != MapTool::Place)
                             world->disarm();
                     });
    QObject::connect(views.layers, &LayersPanel::layerChanged, views.map, &MapView::setLayer);
    HeightLayer* const heights = &views.map->heights();
    HeightControls* const look = views.layers->heightControls();
    QObject::connect(look, &HeightControls::lookChanged, heights, &HeightLayer::setLook);
    QObject::connect(heights, &HeightLayer::changed, look, [=] { look->setShownRange(heights->range()); });
    QObject::connect(views.sensors, &SensorPanel::plotRequested, views.plots, &PlotView::addSeries);
    QObject::connect(views.messages, &MessageList::countChanged, views.message_count, &QLabel::setText);
    QObject::connect(views.traffic, &QToolButton::clicked, views.connection, &ConnectionBar::openPanel);
    QObject::connect(views.driver, &ControlBadge::clicked, views.drive_dock,
                     [dock = views.drive_dock] { raise(dock); });
}

void fitBars(const WindowViews& views, int columns) {
    constexpr int least_wide = 175;
    constexpr int least_medium = 150;
    views.connection->setRoom(columns >= least_wide     ? BarRoom::Wide
                              : columns >= least_medium ? BarRoom::Medium
                                                        : BarRoom::Narrow);
    views.record->setFiguresShown(columns >= least_medium);
    views.driver->setRoomy(columns >= least_medium);
}

} // namespace usar::widgets
