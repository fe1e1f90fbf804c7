// What one view of the window tells another, and how much the bars show of themselves.
#pragma once

#include "widgets/window/window_views.h"

namespace usar::widgets {

/// Connects views whose signals need no desk: the map and the form of the area, the layers and the map, the sensors and
/// the plots, and buttons that bring up a dock. To be called once, before a desk connects itself.
void wireViews(const WindowViews& views);

/// Leaves out words in a narrow window, so that the time's controls stay visible. `columns`: the window's width in
/// digits.
void fitBars(const WindowViews& views, int columns);

} // namespace usar::widgets
