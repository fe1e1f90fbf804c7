// Checks of a run that hold for a sound program, whatever befalls its robot.
#pragma once

#include <QStringList>

#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// Returns a sentence for each invariant that the run breaks; empty if it breaks none. A program that crashes, hangs,
/// gives no reason in words, tells figures that cannot be, or does not bring its robot to rest, is unsound; so is one
/// whose second flight came out differently. That a mission fails breaks nothing, nor that one is refused, which is the
/// campaign's fault, nor that something else has killed the process.
QStringList brokenInvariants(const RunResult& result);

} // namespace usar::campaign
