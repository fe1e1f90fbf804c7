#include "core/campaign/comparison/failures.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/text.h"

namespace usar::campaign {

namespace {

double figureOf(const RunFigures& run, const std::string& key, double otherwise) {
    const auto found = run.metrics.find(key);
    return found == run.metrics.end() ? otherwise : found->second.value_or(otherwise);
}

/// Less is worse. The number makes the order complete.
std::tuple<int, double, double, std::size_t> goodness(const RunFigures& run) {
    const int kind = run.outcome == Outcome::Done ? 2 : run.outcome == Outcome::Failed ? 1 : 0;
    const double coverage_pct = kind == 2 ? 100.0 : figureOf(run, "coverage_pct", -1.0);
    return {kind, coverage_pct, -figureOf(run, "duration_s", 0.0), run.number};
}

} // namespace

std::string withoutNumbers(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool goes_on = !result.empty() && result.back() == '#';
        const bool is_point = goes_on && text[i] == '.' && i + 1 < text.size() && isDigit(text[i + 1]);
        if (!isDigit(text[i]) && !is_point)
            result += text[i];
        else if (!goes_on)
            result += '#';
    }
    return result;
}

std::vector<const RunFigures*> worstRuns(const Comparison& comparison, std::size_t most) {
    std::vector<const RunFigures*> runs;
    for (const RunPair& pair : comparison.pairing.pairs)
        runs.insert(runs.end(), {pair.baseline, pair.candidate});
    const auto end = runs.begin() + static_cast<std::ptrdiff_t>(std::min(most, runs.size()));
    std::partial_sort(runs.begin(), end, runs.end(),
                      [](const RunFigures* a, const RunFigures* b) { return goodness(*a) < goodness(*b); });
    runs.erase(end, runs.end());
    return runs;
}

std::vector<FailureGroup> failureGroups(const Comparison& comparison, const std::vector<RunFigures>& runs) {
    std::map<std::pair<Outcome, std::string>, FailureGroup> groups;
    for (const RunFigures& run : runs) {
        const bool is_baseline = run.variant == comparison.baseline;
        if (run.outcome == Outcome::Done || (!is_baseline && run.variant != comparison.candidate))
            continue;
        const std::string reason = withoutNumbers(run.reason);
        FailureGroup& group =
            groups.try_emplace({run.outcome, reason}, FailureGroup{run.outcome, reason, 0, 0, &run}).first->second;
        ++(is_baseline ? group.of_baseline : group.of_candidate);
    }
    std::vector<FailureGroup> sorted;
    for (const auto& [key, group] : groups)
        sorted.push_back(group);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const FailureGroup& a, const FailureGroup& b) { return a.size() > b.size(); });
    return sorted;
}

} // namespace usar::campaign
