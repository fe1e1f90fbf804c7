// The shortcut overview (F1): every command that has a shortcut, by group, generated from the registry, and what can be
// done with mouse and held keys.
#pragma once

#include <QDialog>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Makes the overview as a child of `window`. It is not modal; Escape closes it.
QDialog* makeShortcutSheet(const CommandRegistry& registry, QWidget* window);

} // namespace usar::widgets
