#include "core/campaign/statistics/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

#include "core/campaign/statistics/normal.h"
#include "core/campaign/statistics/sample.h"

namespace usar::campaign {

namespace {

/// A sample in ascending order, and where in it the members of each group stand.
struct GroupedSample {
    std::vector<double> sorted;
    std::vector<std::vector<std::uint32_t>> groups;
};

GroupedSample groupedSample(std::span<const double> values, std::span<const int> groups) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
    GroupedSample sample;
    std::map<int, std::vector<std::uint32_t>> members;
    for (const std::size_t from : order) {
        members[groups.empty() ? 0 : groups[from]].push_back(static_cast<std::uint32_t>(sample.sorted.size()));
        sample.sorted.push_back(values[from]);
    }
    for (auto& [group, places] : members)
        sample.groups.push_back(std::move(places));
    return sample;
}

/// Equally likely numbers below a count. The standard library's distributions differ from one library to the next, and
/// its engines would take two thirds of the time of a resample; so this is SplitMix64 (Steele et al. 2014). Each of its
/// numbers serves twice; the bias is count / 2^32.
class IndexSource {
public:
    explicit IndexSource(std::uint64_t seed) : state_(seed) {}

    /// Adds one to the counter of a place for each of as many draws as the group has members.
    void drawInto(std::vector<std::uint32_t>& counters, const std::vector<std::uint32_t>& group) {
        const std::uint64_t size = group.size();
        for (std::size_t drawn = 0; drawn + 1 < group.size(); drawn += 2) {
            const std::uint64_t bits = next();
            ++counters[group[(bits >> 32) * size >> 32]];
            ++counters[group[(bits & 0xffffffffU) * size >> 32]];
        }
        if (size % 2 == 1)
            ++counters[group[(next() >> 32) * size >> 32]];
    }

private:
    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t bits = state_;
        bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
        bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
        return bits ^ (bits >> 31);
    }

    std::uint64_t state_;
};

/// The trimmed mean of a sample in which the i-th of the sorted values occurs `counters[i]` times. `kept` values remain
/// of all after `cut` at each end. Counting takes the place of sorting each resample.
double trimmedMeanOfCounts(const std::vector<double>& sorted, const std::vector<std::uint32_t>& counters,
                           std::size_t cut, std::size_t kept) {
    std::size_t place = 0, passed = 0;
    while (passed + counters[place] <= cut)
        passed += counters[place++];
    std::size_t left = kept;
    std::size_t here = passed + counters[place] - cut;
    double sum = 0.0;
    while (here < left) {
        sum += static_cast<double>(here) * sorted[place];
        left -= here;
        here = counters[++place];
    }
    return (sum + static_cast<double>(left) * sorted[place]) / static_cast<double>(kept);
}

std::vector<double> sortedReplicates(const GroupedSample& sample, double trimmed_share, const Resampling& resampling) {
    const std::size_t size = sample.sorted.size(), cut = trimmedAtEachEnd(size, trimmed_share);
    std::vector<std::uint32_t> counters(size);
    std::vector<double> replicates(static_cast<std::size_t>(resampling.resamples));
    IndexSource indices(resampling.seed);
    for (double& replicate : replicates) {
        std::fill(counters.begin(), counters.end(), 0U);
        for (const auto& group : sample.groups)
            indices.drawInto(counters, group);
        replicate = trimmedMeanOfCounts(sample.sorted, counters, cut, size - 2 * cut);
    }
    std::sort(replicates.begin(), replicates.end());
    return replicates;
}

/// The trimmed means of the sample without each one of its values in turn, by sums from the start.
std::vector<double> leaveOneOut(const std::vector<double>& sorted, double trimmed_share) {
    const std::size_t rest = sorted.size() - 1, cut = trimmedAtEachEnd(rest, trimmed_share), end = rest - cut;
    std::vector<double> sums(sorted.size() + 1, 0.0);
    std::partial_sum(sorted.begin(), sorted.end(), sums.begin() + 1);
    std::vector<double> means(sorted.size());
    for (std::size_t out = 0; out < sorted.size(); ++out) {
        double sum = 0.0;
        if (out < cut) // the kept ones stand one place further on
            sum = sums[end + 1] - sums[cut + 1];
        else if (out < end)
            sum = sums[end + 1] - sums[cut] - sorted[out];
        else
            sum = sums[end] - sums[cut];
        means[out] = sum / static_cast<double>(end - cut);
    }
    return means;
}

/// How fast the spread of the estimate changes with what it estimates.
double acceleration(const GroupedSample& sample, double trimmed_share) {
    const std::vector<double> without = leaveOneOut(sample.sorted, trimmed_share);
    double cubes = 0.0, squares = 0.0;
    for (const auto& group : sample.groups) {
        const double size = static_cast<double>(group.size());
        double center = 0.0;
        for (const std::uint32_t place : group)
            center += without[place] / size;
        for (const std::uint32_t place : group) {
            const double influence = (size - 1.0) * (center - without[place]) / size;
            squares += influence * influence;
            cubes += influence * influence * influence;
        }
    }
    return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

/// The share of the replicates that a bound stands at. `bias` and `acceleration` are the two corrections; with zero for
/// both this is `probability` itself. Where the formula has a pole, the bound stands at the end.
double correctedShare(double probability, double bias, double acceleration) {
    const double z = bias + normalQuantile(probability);
    return normalCumulative(bias + z / std::max(1e-9, 1.0 - acceleration * z));
}

/// Where the estimate stands among the replicates, as a normal quantile; equal ones count half. It stays finite: an
/// estimate beyond all replicates stands as if half a replicate were there.
double biasOf(const std::vector<double>& replicates, double estimate) {
    const auto [first, last] = std::equal_range(replicates.begin(), replicates.end(), estimate);
    const double below = 0.5 * static_cast<double>((first - replicates.begin()) + (last - replicates.begin()));
    const double count = static_cast<double>(replicates.size());
    return normalQuantile(std::clamp(below, 0.5, count - 0.5) / count);
}

} // namespace

Interval bcaInterval(std::span<const double> values, std::span<const int> groups, double trimmed_share,
                     const Resampling& resampling) {
    if (values.size() < 2)
        return {};
    const GroupedSample sample = groupedSample(values, groups);
    if (sample.sorted.front() == sample.sorted.back())
        return {sample.sorted.front(), sample.sorted.front()};
    const std::vector<double> replicates = sortedReplicates(sample, trimmed_share, resampling);
    const double bias = biasOf(replicates, trimmedMean(sample.sorted, trimmed_share));
    const double speed = acceleration(sample, trimmed_share), tail = (1.0 - resampling.confidence) / 2.0;
    return {quantileOfSorted(replicates, correctedShare(tail, bias, speed)),
            quantileOfSorted(replicates, correctedShare(1.0 - tail, bias, speed))};
}

} // namespace usar::campaign
