// Paints trees and buildings as seen from above.
#pragma once

#include <QPainter>

#include "core/base/scenery.h"
#include "widgets/models/map/map_transform.h"

namespace usar::widgets {

/// Paints what is in the viewport. Trees of a size are copies of one picture, because a world has thousands; those
/// smaller than a pixel are points. Takes some milliseconds, so the caller keeps the result. GUI thread.
void paintScenery(QPainter& painter, const Scenery& scenery, const MapTransform& transform);
/// One tree around the painter's origin: a crown with a rim, and the trunk in it. Radii in pixels.
void paintTree(QPainter& painter, double crown_px, double trunk_px);

} // namespace usar::widgets
