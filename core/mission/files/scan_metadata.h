// Metadata in every file of a scan, so that each can be understood on its own years later.
#pragma once

#include <utility>
#include <vector>

#include <QString>

#include "core/mission/files/scan_record.h"

namespace usar::mission {

/// Keys and values, in this order: level, robot, behavior, axes, units, cell size, center of the upper left cell
/// (meters, map frame), faults if there were any, lowest and highest height (missing for an empty map). Keys carry
/// their unit.
std::vector<std::pair<QString, QString>> metadataOf(const ScanRecord& record);

/// Formats a number with up to twelve significant digits; C locale.
QString numberText(double value);

} // namespace usar::mission
