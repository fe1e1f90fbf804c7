// The word on a difference between two variants.
#pragma once

#include <cstdint>

#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

enum class Verdict { Better, Worse, Equal, NotWorse, Undecided };

/// "better", "worse", "equal", "not worse", "undecided"
const char* wordOf(Verdict verdict);

/// What a verdict stands on. A gain is a difference in the good direction, whichever that is for the metric.
struct Evidence {
    Interval gain;
    double margin = 0.0;
    bool is_enough = false;      ///< enough pairs for any verdict
    bool is_significant = false; ///< by the test beside the interval, adjusted for the number of questions
};

/// Cuts the line of gains at minus and plus the margin and asks on which piece the whole interval lies: beyond the
/// margin on the good side it is better, beyond it on the bad side worse, both only if the test beside the interval
/// agrees; between the margins, both ends included, it is equal. So a difference that is significant but within the
/// margin is equal, because it does not matter; and one that may be either is undecided, however likely.
Verdict verdictOn(const Evidence& evidence);

/// True where the interval excludes that the candidate is worse by more than the margin. A candidate may be known not
/// to be worse long before it is known whether it is equal or better.
bool isNotWorse(const Evidence& evidence);

} // namespace usar::campaign
