// The map as a screen reader finds it: its start poses, robots and objects, each with its name and its place.
#pragma once

namespace usar::widgets {

/// Makes every MapView tell assistive tools what is on it. Further calls have no effect. GUI thread.
void describeMaps();

} // namespace usar::widgets
