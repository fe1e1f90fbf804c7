// The commands of the map, and the card of a robot that was placed on it.
#pragma once

#include <functional>

#include "widgets/commands/command_registry.h"
#include "widgets/window/window_views.h"

namespace usar::widgets {

/// Registers the commands that move the map, and the tool that places a robot. The map must outlive the registry.
void registerMapCommands(CommandRegistry& commands, MapView* map);

/// Opens the card where a start pose or the placed robot is clicked. `robot_name` gives the next free name.
void wireSpawnCard(const WindowViews& views, const std::function<QString()>& robot_name);

/// Shows the robot to spawn at this pose on the map, with the card that asks which; nullopt takes both away. The robot
/// gets this name unless the user chooses another.
void showSpawnDraft(const WindowViews& views, const std::optional<Pose>& draft_in_map, const QString& robot_name);

} // namespace usar::widgets
