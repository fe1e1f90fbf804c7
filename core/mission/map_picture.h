// The map as a picture with the thesis's marks, and as a 16-bit height image.
#pragma once

#include <QImage>

#include "core/mission/scan_record.h"

namespace usar::mission {

/// Gray heights; path green, diversion blue, low risk orange, high risk red, recharge yellow squares, landing violet
/// circles (thesis figure 4.4).
QImage mapPicture(const ScanRecord& record);
/// Format_Grayscale16; 0 = unknown, 1..65535 = minimum..maximum; scale, offset, cell size and origin as PNG text keys.
QImage heightImage(const mapping::Raster& raster);

} // namespace usar::mission
