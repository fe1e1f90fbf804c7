// The menus of the window, made from its commands.
#pragma once

#include <functional>

#include <QMenuBar>

#include "widgets/commands/command_registry.h"

namespace usar::app {

/// Every command must be registered. `fill_worlds` fills the menu of the embedded simulator's worlds.
void makeMenus(QMenuBar& bar, const widgets::CommandRegistry& commands, const std::function<void(QMenu*)>& fill_worlds);

} // namespace usar::app
