#include "widgets/window/map_commands.h"

#include "widgets/models/figures.h"

namespace usar::widgets {

void registerMapCommands(CommandRegistry& commands, MapView* map) {
    const auto add = [&commands](const char* id, const std::function<void(bool)>& run) {
        return commands.add(commandSpec(id), run, nullptr);
    };
    add("map.fit", [map](bool) { map->fit(); });
    add("map.fit_world", [map](bool) { map->fitWorld(); });
    QAction* const follow = add("map.follow", [map](bool on) { map->setFollowing(on); });
    add("map.zoom_in", [map](bool) { map->zoomIn(); });
    add("map.zoom_out", [map](bool) { map->zoomOut(); });
    QAction* const place = add("map.place_robot", [map](bool on) {
        map->setTool(on ? MapTool::Robot : MapTool::Pan);
        map->setFocus(); // So that it receives Escape.
    });
    QAction* const measure = add("map.measure", [map](bool on) {
        map->setTool(on ? MapTool::Measure : MapTool::Pan);
        map->setFocus(); // So that it receives Escape.
    });
    QObject::connect(map, &MapView::followingChanged, follow, &QAction::setChecked);
    QObject::connect(&map->gestures(), &MapGestures::toolChanged, place, [place, measure](MapTool tool) {
        place->setChecked(tool == MapTool::Robot);
        measure->setChecked(tool == MapTool::Measure);
    });
}

void wireSpawnCard(const WindowViews& views, const std::function<QString()>& robot_name) {
    MapView* const map = views.map;
    QObject::connect(map, &MapView::startPoseClicked, views.spawn_card,
                     [map, card = views.spawn_card, robot_name](int pose, const QPoint& at) {
                         const auto& start = map->content().start_poses[static_cast<std::size_t>(pose)];
                         card->openFor(pose, QString::fromStdString(start.name), robot_name(), at);
                     });
    QObject::connect(&map->gestures(), &MapGestures::draftClicked, views.spawn_card, [views, robot_name] {
        showSpawnDraft(views, views.map->content().spawn_draft_in_map, robot_name());
    });
}

void showSpawnDraft(const WindowViews& views, const std::optional<Pose>& draft_in_map, const QString& robot_name) {
    views.map->gestures().setDraft(draft_in_map);
    if (!draft_in_map)
        return views.spawn_card->hide();
    const Vec2 at_m = draft_in_map->position_m.head<2>();
    const QString place = QObject::tr("x %1, y %2 m, yaw %3°")
                              .arg(figure(at_m.x(), 1), figure(at_m.y(), 1), figure(degrees(draft_in_map->yaw_rad), 0));
    const QPointF beside = views.map->transform().toScreen(at_m) + QPointF(24.0, 24.0);
    views.spawn_card->openFor(SpawnChoice::at_draft, place, robot_name, views.map->mapToGlobal(beside.toPoint()));
}

} // namespace usar::widgets
