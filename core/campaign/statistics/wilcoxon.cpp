#include "core/campaign/statistics/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/campaign/statistics/normal.h"

namespace usar::campaign {

namespace {

constexpr std::size_t largest_exact = 50;

/// The differences other than zero, the smallest in size first.
std::vector<double> bySize(std::span<const double> differences) {
    std::vector<double> ranked;
    std::copy_if(differences.begin(), differences.end(), std::back_inserter(ranked), [](double d) { return d != 0.0; });
    std::sort(ranked.begin(), ranked.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
    return ranked;
}

/// Adds the ranks to both sums. Returns the sum of t^3 - t over groups of t equal sizes, which is 0 without any.
double addRanks(const std::vector<double>& ranked, SignedRank& result) {
    double ties = 0.0;
    for (std::size_t first = 0, last = 0; first < ranked.size(); first = last) {
        while (last < ranked.size() && std::abs(ranked[last]) == std::abs(ranked[first]))
            ++last;
        const double rank = static_cast<double>(first + 1 + last) / 2.0, size = static_cast<double>(last - first);
        for (std::size_t i = first; i < last; ++i)
            (ranked[i] > 0.0 ? result.positive : result.negative) += rank;
        ties += size * size * size - size;
    }
    return ties;
}

/// The probability that a sum of the ranks 1 to `count`, each taken with probability 1/2, is at most `sum`.
double exactTail(std::size_t count, std::size_t sum) {
    std::vector<double> ways(sum + 1, 0.0); // exact: all are below 2^50
    ways[0] = 1.0;
    for (std::size_t rank = 1; rank <= count; ++rank)
        for (std::size_t total = sum; total >= rank; --total)
            ways[total] += ways[total - rank];
    double all = 0.0;
    for (const double some : ways)
        all += some;
    return std::ldexp(all, -static_cast<int>(count));
}

} // namespace

SignedRank wilcoxon(std::span<const double> differences) {
    SignedRank result;
    const std::vector<double> ranked = bySize(differences);
    result.ranked = ranked.size();
    if (ranked.empty())
        return result;
    const double ties = addRanks(ranked, result), smaller = std::min(result.positive, result.negative);
    if (ties == 0.0 && result.ranked <= largest_exact) {
        result.p = std::min(1.0, 2.0 * exactTail(result.ranked, static_cast<std::size_t>(smaller)));
        return result;
    }
    const double n = static_cast<double>(result.ranked), expected = n * (n + 1.0) / 4.0;
    const double spread = std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - ties / 48.0);
    result.p = std::min(1.0, 2.0 * normalCumulative((smaller - expected) / spread));
    return result;
}

} // namespace usar::campaign
