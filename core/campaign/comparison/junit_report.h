// The runs of a campaign as JUnit XML, which continuous integration shows as tests.
#pragma once

#include <string>
#include <vector>

#include <QByteArray>

#include "core/campaign/comparison/run_figures.h"

namespace usar::campaign {

/// One test suite for each variant, one test case for each run: its class is the mission, its name the pair,
/// its time the mission's duration in seconds. A run that failed is a failure; one that crashed, timed out, ran out of
/// memory or was refused is an error; a killed one is skipped. The text of each is the command that flies it again.
QByteArray junitReport(const std::vector<RunFigures>& runs, const std::string& campaign);

} // namespace usar::campaign
