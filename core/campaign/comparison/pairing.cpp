#include "core/campaign/comparison/pairing.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/text.h"

namespace usar::campaign {

namespace {

using Seeds = std::map<std::pair<std::string, std::size_t>, RunPair>;

/// Puts a run into its place; false if the place is taken.
bool place(const RunFigures*& where, const RunFigures& run) {
    if (where)
        return false;
    where = &run;
    return true;
}

Result<void> flown(const std::vector<std::string>& variants, const std::string& variant) {
    if (std::find(variants.begin(), variants.end(), variant) != variants.end())
        return {};
    return failure("no run is of this variant", variant,
                   variants.empty() ? std::string() : "Those that were flown: " + listOf(variants));
}

std::optional<double> measured(const RunFigures& run, const std::string& key) {
    const auto found = run.metrics.find(key);
    return found == run.metrics.end() || !found->second || !std::isfinite(*found->second) ? std::nullopt
                                                                                          : found->second;
}

/// The longest time of each mission of which a run was done.
std::map<int, double> longestTimes(const Pairing& pairing, const Metric& metric) {
    std::map<int, double> longest;
    std::set<int> done;
    for (const RunPair& pair : pairing.pairs)
        for (const RunFigures* run : {pair.baseline, pair.candidate}) {
            if (const auto time_s = measured(*run, metric.key)) {
                double& most_s = longest.try_emplace(pair.mission, *time_s).first->second;
                most_s = std::max(most_s, *time_s);
            }
            if (run->outcome == Outcome::Done)
                done.insert(pair.mission);
        }
    std::erase_if(longest, [&](const auto& one) { return !done.contains(one.first); });
    return longest;
}

std::optional<double> valueOrLongest(const RunFigures& run, const Metric& metric, const std::map<int, double>& longest,
                                     int mission) {
    const auto value = valueOf(run, metric);
    const auto found = longest.find(mission);
    return value || run.outcome == Outcome::Done || found == longest.end() ? value : std::optional(found->second);
}

void noteLimit(const RunFigures& run, double value, PairedValues& values) {
    if (run.outcome == Outcome::Done)
        return;
    values.assumed += run.time_limit_s ? 0 : 1;
    const Interval limits = values.limits.value_or(Interval{value, value});
    values.limits = Interval{std::min(limits.low, value), std::max(limits.high, value)};
}

} // namespace

Result<Pairing> pairUp(const std::vector<RunFigures>& runs, const std::string& baseline, const std::string& candidate) {
    const std::vector<std::string> variants = variantsOf(runs);
    for (const std::string& variant : {baseline, candidate})
        if (auto known = flown(variants, variant); !known)
            return tl::unexpected(known.error());
    if (baseline == candidate)
        return failure("a variant cannot be compared with itself", baseline, "Name two variants");
    Pairing pairing;
    Seeds seeds;
    std::set<std::string> missions;
    for (const RunFigures& run : runs) {
        if (run.variant != baseline && run.variant != candidate)
            continue;
        RunPair& pair = seeds[{run.mission, run.pair}];
        pairing.repeated += place(run.variant == baseline ? pair.baseline : pair.candidate, run) ? 0 : 1;
        missions.insert(run.mission);
    }
    pairing.missions.assign(missions.begin(), missions.end());
    for (auto& [key, pair] : seeds) {
        if (!pair.baseline || !pair.candidate) {
            ++pairing.single;
        } else if (!counts(pair.baseline->outcome) || !counts(pair.candidate->outcome)) {
            ++pairing.not_counted;
        } else {
            pair.mission = static_cast<int>(std::distance(missions.begin(), missions.find(key.first)));
            pairing.pairs.push_back(pair);
        }
    }
    return pairing;
}

std::size_t seedsOf(const Pairing& pairing) {
    std::set<std::uint64_t> seeds;
    for (const RunPair& pair : pairing.pairs)
        seeds.insert(pair.baseline->seed);
    return seeds.size();
}

std::vector<std::string> variantsOf(const std::vector<RunFigures>& runs) {
    std::vector<std::string> variants;
    for (const RunFigures& run : runs)
        if (std::find(variants.begin(), variants.end(), run.variant) == variants.end())
            variants.push_back(run.variant);
    return variants;
}

std::optional<double> valueOf(const RunFigures& run, const Metric& metric) {
    if (!counts(run.outcome))
        return std::nullopt;
    if (run.outcome != Outcome::Done && metric.unfinished == UnfinishedRuns::CountTheLimit)
        return run.time_limit_s;
    if (run.outcome != Outcome::Done && metric.unfinished == UnfinishedRuns::LeftOut)
        return std::nullopt;
    return measured(run, metric.key);
}

PairedValues valuesOf(const Pairing& pairing, const Metric& metric) {
    PairedValues values;
    const std::map<int, double> longest =
        metric.unfinished == UnfinishedRuns::CountTheLimit ? longestTimes(pairing, metric) : std::map<int, double>();
    for (const RunPair& pair : pairing.pairs) {
        const auto baseline = valueOrLongest(*pair.baseline, metric, longest, pair.mission);
        const auto candidate = valueOrLongest(*pair.candidate, metric, longest, pair.mission);
        if (!baseline || !candidate) {
            ++values.left_out;
            continue;
        }
        if (metric.unfinished == UnfinishedRuns::CountTheLimit) {
            noteLimit(*pair.baseline, *baseline, values);
            noteLimit(*pair.candidate, *candidate, values);
        }
        values.baseline.push_back(*baseline);
        values.candidate.push_back(*candidate);
        values.missions.push_back(pair.mission);
    }
    return values;
}

} // namespace usar::campaign
