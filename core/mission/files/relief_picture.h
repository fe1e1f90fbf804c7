// The map as a picture in perspective, for the results of a mission.
#pragma once

#include <stop_token>

#include <QImage>

#include "core/mapping/height_look.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// The heights as a surface in the colors of mapPicture, not exaggerated, seen from the south-east, with the path at
/// the height at which it was flown, broken where it jumps, the marks and the outline of the mission area. It has
/// 1600 x 1000 pixels; metadata are PNG text keys. Huge maps are drawn from larger cells. A null image for an empty
/// raster, and after a request to stop. Works in any thread.
QImage reliefPicture(const ScanRecord& record, const mapping::HeightLook& look = {}, const std::stop_token& stop = {});

} // namespace usar::mission
