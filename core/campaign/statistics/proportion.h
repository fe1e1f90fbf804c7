// What counts of successes say: intervals of a rate, and whether two rates on equal seeds differ.
#pragma once

#include <cstddef>

#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

/// `successes` of `trials`; the first is never more than the second.
struct Count {
    std::size_t successes = 0;
    std::size_t trials = 0;

    /// 0 without trials.
    double rate() const;
    bool operator==(const Count&) const = default;
};

/// Wilson's score interval of the rate (Wilson 1927), which is to be shown: on average it holds what it promises, also
/// near 0 and 1. From 0 to 1 without trials.
Interval wilsonInterval(const Count& count, double confidence = 0.95);

/// The interval of Clopper and Pearson (1934), which is to be claimed: it never holds less than it promises, and so is
/// wider. From 0 to 1 without trials.
Interval clopperPearsonInterval(const Count& count, double confidence = 0.95);

/// The one-sided bounds of Clopper and Pearson: with this confidence the rate is at most, or at least, so much. No
/// crash in 200 runs proves a rate below 1.49 %.
double highestRate(const Count& count, double confidence = 0.95);
double lowestRate(const Count& count, double confidence = 0.95);

/// What became of pairs of runs on equal seeds.
struct PairedCount {
    std::size_t both = 0;           ///< succeeded
    std::size_t baseline_only = 0;  ///< succeeded, and the candidate did not
    std::size_t candidate_only = 0; ///< succeeded, and the baseline did not
    std::size_t neither = 0;

    std::size_t pairs() const { return both + baseline_only + candidate_only + neither; }
    Count baseline() const { return {both + baseline_only, pairs()}; }
    Count candidate() const { return {both + candidate_only, pairs()}; }
    bool operator==(const PairedCount&) const = default;
};

/// The two-sided p-value of McNemar's exact test: the pairs that differ are tosses of a fair coin if both rates are
/// equal. 1 if no pair differs.
double mcNemar(const PairedCount& count);

/// The interval of the candidate's rate minus the baseline's: the adjusted Wald interval of Bonett and Price (2012),
/// which adds one pair to each kind that differs. From -1 to 1 without pairs.
Interval rateDifference(const PairedCount& count, double confidence = 0.95);

} // namespace usar::campaign
