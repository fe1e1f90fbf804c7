// Makes the menus of the window from its commands.
#pragma once

#include <functional>

#include <QMenuBar>

#include "widgets/commands/command_registry.h"

namespace usar::app {

/// Adds the menus to the bar. All commands must be registered before. `fill_worlds` is called once, with the menu for
/// the worlds of the embedded simulator, which it fills.
void makeMenus(QMenuBar& bar, const widgets::CommandRegistry& commands, const std::function<void(QMenu*)>& fill_worlds);

} // namespace usar::app
