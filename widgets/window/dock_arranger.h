// Reads the present layout from a window's docks, and gives them another one.
#pragma once

#include <QMainWindow>

#include "widgets/models/dock_layout.h"

namespace usar::widgets {

/// The present places of all docks of the window, which are told by their object names; without a name and views. The
/// window must be visible, because places are found by where the docks are.
DockLayout layoutOf(const QMainWindow& window);

/// Moves the docks to their places. Names of docks that the window does not have are ignored; docks that the layout
/// does not name are closed where they are. A floating dock whose place is on no screen any more comes to the first
/// screen.
void arrangeDocks(QMainWindow& window, const DockLayout& layout);

} // namespace usar::widgets
