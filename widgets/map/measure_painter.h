// Draws a measured line on the map and the profile of the heights along it, or a measured rectangle.
#pragma once

#include <QPainter>

#include "widgets/map/height_layer.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/models/map/measured_line.h"

namespace usar::widgets {

/// The heights of the map along the line.
LineProfile profileOf(const MeasuredLine& line, const HeightLayer& heights);
/// What is measured in words, as profileText or rectangleText.
QString measuredText(const MeasuredLine& line, const HeightLayer& heights);
/// Paints the line with its ends, and at the top of the view a sheet with the profile from the first end to the second;
/// where no height is known it has a gap. Of a rectangle it paints the outline, and a sheet without a profile. GUI
/// thread.
void paintMeasured(QPainter& painter, const MeasuredLine& line, const HeightLayer& heights,
                   const MapTransform& transform);

} // namespace usar::widgets
