// What an earlier run scanned, as the run that continues it takes it over.
#pragma once

#include "core/mapping/height_map.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// A plain value that crosses threads. Meters, map frame.
struct EarlierScan {
    ScanRecord record;          ///< without its raster; its area is the whole one of the mission
    mapping::HeightTiles tiles; ///< with cells as large as those of the new run
    ContinuedRun run;           ///< what the new run's results tell about it
};

} // namespace usar::mission
