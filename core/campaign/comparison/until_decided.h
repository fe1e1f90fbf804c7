// What a campaign that stops as soon as it is decided feeds to its sequential test.
#pragma once

#include <optional>

#include "core/campaign/comparison/pairing.h"

namespace usar::campaign {

/// The candidate's gain in one pair, as a multiple of the metric's margin, for SequentialTest(1.0). Success comes
/// first: infinite where only the candidate was done, minus infinite where only the baseline was, and 0 where neither
/// was. A margin that is a share is one of this pair's baseline, because the median of all is not known yet. Nothing
/// where a run was refused or killed, or has no such figure; such a pair is not fed. Feed pairs in the order of their
/// seeds, not as they finish: what finishes first is not chosen by chance, on which the test relies.
std::optional<double> scaledGain(const RunPair& pair, const Metric& metric);

} // namespace usar::campaign
