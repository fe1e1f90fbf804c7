// Draws a measured line on the map, and the profile of the heights along it.
#pragma once

#include <QPainter>

#include "widgets/map/height_layer.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/models/map/measured_line.h"

namespace usar::widgets {

/// The heights of the map along the line.
LineProfile profileOf(const MeasuredLine& line, const HeightLayer& heights);
/// Paints the line with its ends, and at the top of the view a sheet with the profile from the first end to the second;
/// where no height is known it has a gap. GUI thread.
void paintMeasured(QPainter& painter, const MeasuredLine& line, const HeightLayer& heights,
                   const MapTransform& transform);

} // namespace usar::widgets
