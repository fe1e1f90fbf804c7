// What every file of a scan says about itself, so that it can be read alone years later.
#pragma once

#include <utility>
#include <vector>

#include <QString>

#include "core/mission/scan_record.h"

namespace usar::mission {

/// Key and value, in this order: level, robot, behavior, axes, units, cell size, center of the upper left cell (metres,
/// map frame), lowest and highest height (missing for an empty map), faults where there were any. Keys carry their
/// unit.
std::vector<std::pair<QString, QString>> metadataOf(const ScanRecord& record);

/// Shortest text with twelve digits; C locale.
QString numberText(double value);

} // namespace usar::mission
