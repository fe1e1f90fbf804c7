// The map as a picture with the marks of the thesis, and as a 16-bit height image.
#pragma once

#include <cstdint>

#include <QImage>

#include "core/mapping/height_look.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// Heights are colored and lit, or gray, over the range that `look` tells, as the window shows them; unknown ground
/// slate, small holes that are filled in (mapping::withHolesFilled) half as bright; path green, diversion blue, low
/// risk orange, high risk red, recharge yellow squares, landing violet circles (thesis figure 4.4), abandoned goals
/// white crosses, the mission area a thin frame. Small maps are enlarged by a whole number until the shorter side has
/// 600 pixels, huge ones reduced until the longer side has 8192. Below the map is a legend with height range, scale bar
/// and the colors of the marks. Metadata are PNG text keys. A null image for an empty raster. Works in any thread; text
/// needs a QGuiApplication (without one the legend has no letters).
QImage mapPicture(const ScanRecord& record, const mapping::HeightLook& look = {});

/// Of ground that is not known, as 0xffRRGGBB, in all pictures of a map.
inline constexpr std::uint32_t unknown_color = 0xff2c3340;

/// The heights that have the colors at the two ends of the scale.
mapping::HeightRange colorRange(const mapping::Raster& raster, const mapping::HeightLook& look);

/// The legend of mapPicture alone, as wide as that picture and with its metadata, for pages and slides that show the
/// heights in another way. A null image for an empty raster.
QImage legendPicture(const ScanRecord& record, const mapping::HeightLook& look = {});

/// Format_Grayscale16; 0 is unknown, 1..65535 spans minimum..maximum: height = height_offset_m + pixel *
/// height_scale_m. These two, cell size and origin are PNG text keys. A null image for an empty raster.
QImage heightImage(const mapping::Raster& raster);

} // namespace usar::mission
