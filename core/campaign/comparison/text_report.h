// A comparison as a table for the terminal.
#pragma once

#include <QString>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// The headline, one line for success and for each metric, and what was not compared. Ends with a line end. Without
/// colors, so that it can be piped.
QString textReport(const Comparison& comparison);
/// The reports of several candidates one after the other, and their headlines last.
QString textReport(const std::vector<Comparison>& comparisons);

} // namespace usar::campaign
