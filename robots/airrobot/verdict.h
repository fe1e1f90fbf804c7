// Says whether a survey whose lanes are finished has scanned its area, and where it ended.
#pragma once

#include <string>

#include "core/agent/behavior.h"
#include "robots/airrobot/scan_ledger.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// A success only if the lanes were flown as far as ways lead, few of them were given up, and the scans show most of
/// what the lanes lead over. The reason says what was left out. `missed`: see Leftovers::missed.
agent::BehaviorFinished verdictOf(const Survey& survey, const ScanLedger& ledger, const Settings& settings,
                                  double missed = 0.0);

/// A place in the map frame, for people.
std::string placeWords(const Vec2& at_m);

} // namespace usar::airrobot
