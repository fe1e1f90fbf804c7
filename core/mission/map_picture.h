// The map as a picture with the thesis's marks, and as a 16-bit height image.
#pragma once

#include <QImage>

#include "core/mission/scan_record.h"

namespace usar::mission {

/// Gray heights, darker is deeper, unknown ground slate; path green, diversion blue, low risk orange, high risk red,
/// recharge yellow squares, landing violet circles (thesis figure 4.4), goals given up as white crosses, the mission
/// area as a thin frame. Small maps are enlarged by a whole number until the shorter side has 600 pixels, huge ones
/// made smaller until the longer has 8192. Below the map stands a legend: height range, scale bar, colors of the marks.
/// Metadata as PNG text keys. Any thread; letters need a QGuiApplication (without one the legend has none).
QImage mapPicture(const ScanRecord& record);

/// Format_Grayscale16; 0 = unknown, 1..65535 = minimum..maximum: height = height_offset_m + pixel * height_scale_m.
/// These two, cell size and origin are PNG text keys. A null image for an empty raster.
QImage heightImage(const mapping::Raster& raster);

} // namespace usar::mission
