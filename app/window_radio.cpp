// The radio's part of MainWindow: its commands.
#include <algorithm>

#include "app/main_window.h"
#include "core/protocol/commands/spawn.h"

namespace usar::app {

void MainWindow::registerRadioCommands() {
    QAction* const station = commands_.add(
        {"radio.station",
         tr("Spawn a base station"),
         tr("Radio"),
         tr("A base of the radio network, on the first start pose that is free"),
         "plus",
         {QKeySequence("Ctrl+B")}},
        [this](bool) { spawnStation(); },
        [this] { return link_state_ == link::LinkState::Connected && !start_poses_.empty(); });
    commands_.add({"radio.show",
                   tr("Radio links"),
                   tr("Radio"),
                   tr("How well robots hear each other: dBm of each pair, and the last minutes"),
                   "",
                   {QKeySequence("F7")}},
                  [this](bool) {
                      auto* dock = findChild<QDockWidget*>("radio");
                      dock->show();
                      dock->raise();
                  });
    QAction* const layer =
        commands_.add({"radio.map",
                       tr("Radio links on the map"),
                       tr("Radio"),
                       tr("Lines between robots in the color of their link; the Layers dock has it, too"),
                       "",
                       {QKeySequence("Ctrl+Shift+B")},
                       true},
                      [this](bool on) {
                          widgets::LayerState state = views_.map->layer(widgets::MapLayer::Radio);
                          state.visible = on;
                          views_.map->setLayer(widgets::MapLayer::Radio, state);
                          views_.layers->setLayer(widgets::MapLayer::Radio, state);
                      });
    connect(views_.layers, &widgets::LayersPanel::layerChanged, layer,
            [layer](widgets::MapLayer which, const widgets::LayerState& state) {
                if (which == widgets::MapLayer::Radio)
                    layer->setChecked(state.visible);
            });
    radio_.setStationAction(station);
}

/// Two in one place would hear each other best, and nobody wants to know.
void MainWindow::spawnStation() {
    const auto robots = control_.robots();
    const auto is_free = [&](const protocol::StartPose& pose) {
        return std::ranges::none_of(robots, [&](const Robot* robot) {
            return robot->view().spawn.start_in_map.position_m.isApprox(pose.pose_in_map.position_m);
        });
    };
    auto place = std::ranges::find_if(start_poses_, is_free);
    if (place == start_poses_.end())
        place = start_poses_.begin();
    const auto is_taken = [&](const std::string& name) {
        return std::ranges::any_of(robots, [&](const Robot* robot) { return robot->view().spawn.robot_name == name; });
    };
    std::string name = "Base";
    for (int number = 2; is_taken(name); ++number)
        name = "Base" + std::to_string(number);
    const auto id = control_.spawn({std::string(protocol::station_class), name, place->pose_in_map});
    if (!id)
        complain("spawn", id.error());
}

} // namespace usar::app
