// The part of WorldEditor that registers its commands.
#include "app/desks/world_editor.h"

namespace usar::app {

void WorldEditor::registerCommands() {
    const auto one = [this] { return selected() != nullptr; };
    commands_.add(
        {"world.turn_left",
         tr("Turn left"),
         tr("World"),
         tr("Turns the selected object by 15° counter-clockwise"),
         "turn-left",
         {QKeySequence("Ctrl+[")}},
        [this](bool) { turn(radians(15.0)); }, one);
    commands_.add(
        {"world.turn_right",
         tr("Turn right"),
         tr("World"),
         tr("Turns the selected object by 15° clockwise"),
         "turn-right",
         {QKeySequence("Ctrl+]")}},
        [this](bool) { turn(radians(-15.0)); }, one);
    commands_.add(
        {"world.spin",
         tr("Spin, or stop spinning"),
         tr("World"),
         tr("Turns the selected object on and on, 30° a second; again stops it"),
         "spin",
         {}},
        [this](bool) { spin(); }, one);
    registerDeleteCommands();
    registerWayCommands();
}

void WorldEditor::registerDeleteCommands() {
    const auto any = [this] { return !shown_.empty(); };
    const auto one = [this] { return selected() != nullptr; };
    commands_.add(
        {"world.delete",
         tr("Delete object"),
         tr("World"),
         tr("Takes the selected object out of the world; on map and list the Delete key does it"),
         "trash",
         {QKeySequence("Ctrl+Delete")}},
        [this](bool) { remove(selected_); }, one);
    commands_.add(
        {"world.delete_all",
         tr("Delete all objects"),
         tr("World"),
         tr("Takes every object out of the world"),
         "trash-all",
         {}},
        [this](bool) { removeAll(); }, any);
    commands_.add(
        {"world.undo",
         tr("Bring back what was deleted"),
         tr("World"),
         tr("The objects of the last deletion, where they were"),
         "undo",
         {QKeySequence::Undo}},
        [this](bool) {
            deleted_.undo();
            commands_.refresh();
        },
        [this] { return deleted_.canUndo() && port_ != 0; });
    commands_.add(
        {"world.redo",
         tr("Redo"),
         tr("World"),
         tr("Deletes again what was brought back"),
         "redo",
         {QKeySequence::Redo}},
        [this](bool) {
            deleted_.redo();
            commands_.refresh();
        },
        [this] { return deleted_.canRedo() && port_ != 0; });
}

void WorldEditor::registerWayCommands() {
    const auto one = [this] { return selected() != nullptr; };
    const auto has_way = [this] { return selected() && !selected()->waypoints_in_map_m.empty(); };
    const auto can_go = [this, has_way] { return has_way() || (selected() && selected()->carries); };
    commands_.add(
        {"world.waypoints",
         tr("Add way points"),
         tr("World"),
         tr("Each click on the map adds one to the way of the selected object; Escape ends it"),
         "waypoint",
         {QKeySequence("W")},
         true},
        [this](bool on) {
            views_.map->setTool(on ? widgets::MapTool::Waypoint : widgets::MapTool::Pan);
            if (on)
                views_.map->setFocus(); // So that it receives Escape.
        },
        one);
    commands_.add(
        {"world.clear_way",
         tr("Forget way points"),
         tr("World"),
         tr("The selected object stops and has no way any more"),
         "waypoint-off",
         {}},
        [this](bool) { clearWay(); }, has_way);
    commands_.add(
        {"world.go",
         tr("Start moving"),
         tr("World"),
         tr("Along its way points at this speed; a conveyor runs its belt"),
         "play",
         {}},
        [this](bool) { follow(true); }, can_go);
    commands_.add(
        {"world.halt", tr("Stop moving"), tr("World"), tr("Where it is; a belt stands still"), "pause", {}},
        [this](bool) { follow(false); }, can_go);
}

} // namespace usar::app
