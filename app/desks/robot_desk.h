// Desk for robots: spawns, lists and removes them, shows their updates, and lets them leave trace marks.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "app/desks/desk.h"
#include "app/desks/robot_presenter.h"
#include "core/mission/fleet/shown_heights.h"

namespace usar::app {

/// Spawns robots on the map's start poses; a RobotPresenter shows their updates. GUI thread.
class RobotDesk : public Desk {
    Q_OBJECT
public:
    explicit RobotDesk(const DeskContext& context);

    void registerCommands() override;
    void wire() override;
    /// The robot of this name stays selected from when it comes until the user selects another one. Empty: none does.
    void prefer(const QString& name) { preferred_name_ = name.toStdString(); }
    /// Offers the classes that can be spawned now in the spawn card.
    void listClasses();
    /// Updates the robot's row in the list and its arrow on the map.
    void showRow(RobotId id) { presenter_.showRow(id); }
    /// Sends TRACE for the selected robot, with the color chosen in the palette.
    void trace(bool on);

private:
    /// Registers the commands that switch marks on and off, choose their color, and remove them from the map.
    void registerTraceCommands();
    void wireRobots();
    void wireSpawning();
    void wireMarks();
    /// Connects whose heights are shown with the height layer, its controls and their command.
    void wireHeights();
    /// Time since the shown height at this point was scanned, on the protocol clock; nullopt: nobody knows it, or the
    /// messages do not have the scan.
    std::optional<Seconds> ageAt(const Vec2& point_in_map_m);
    /// Shows the line that wrote the map here in the messages, or says why there is none.
    void showWriter(const Vec2& point_in_map_m);
    /// For the palette: each robot can be selected, and one can be spawned at each start pose.
    std::vector<widgets::PaletteOffer> offers();
    /// Shows a new robot, and selects it unless the preferred one is selected.
    void welcome(RobotId id);
    /// Removes a robot from the views; `instead` is selected if the robot was.
    void dismiss(RobotId id, const QString& name, RobotId instead);
    /// Spawns a robot on the chosen start pose, unless that pose no longer exists. An error is a notice.
    void spawn(const widgets::SpawnChoice& choice);
    /// Shows the selected robot's trace state in the command and the palette.
    void showTrace();
    /// Selects the robot with this name, which was clicked on the map; an unknown name changes nothing.
    void select(const QString& name);

    RobotPresenter presenter_;
    std::string preferred_name_;
    RobotId preferred_; ///< It is the robot of that name as soon as it has come.
    mission::ShownHeights heights_;
    /// When the lines were sent that the probe has asked for, because to look for one takes a millisecond.
    std::map<std::pair<ConnectionId, LineNumber>, std::optional<Seconds>> line_times_;
};

} // namespace usar::app
