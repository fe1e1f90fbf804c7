// A comparison as one HTML page that needs nothing beside itself.
#pragma once

#include <QByteArray>

#include "core/campaign/comparison/report.h"

namespace usar::campaign {

/// UTF-8, without scripts, fonts or pictures from elsewhere; the drawings are inline SVG. It follows the reader's light
/// or dark theme, and is laid out for paper. Verdicts with intervals, sorted differences of each metric, the share of
/// seeds done by each time, the seeds that differ, the ten worst runs and the command that flies each again, failures
/// by reason, and the facts of the report.
QByteArray htmlReport(const Report& report);
/// The same for each candidate, after an overview.
QByteArray htmlReport(const CampaignReport& report);

} // namespace usar::campaign
