// Wilcoxon's signed-rank test of paired differences.
#pragma once

#include <cstddef>
#include <span>

namespace usar::campaign {

struct SignedRank {
    double positive = 0.0;  ///< sum of the ranks of positive differences
    double negative = 0.0;  ///< sum of the ranks of negative differences
    std::size_t ranked = 0; ///< differences other than zero
    double p = 1.0;         ///< two-sided
};

/// Ranks the differences by size. Zeros are left out (Wilcoxon 1945), equal sizes share the mean of their ranks. For up
/// to 50 ranked differences without equal sizes p is exact, by counting all signs; beyond it is the normal
/// approximation with the variance corrected for equal sizes and no correction for continuity (Hollander and Wolfe
/// 1999, section 3.1), as scipy's wilcoxon has them by default. p is 1 if nothing is ranked.
SignedRank wilcoxon(std::span<const double> differences);

} // namespace usar::campaign
