#include "core/campaign/comparison/failures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/text.h"

namespace usar::campaign {

namespace {

constexpr int square_m = 10; ///< side of a square

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

bool isDigitAt(const std::string& text, std::size_t at) {
    return at < text.size() && isDigit(text[at]);
}

/// The end of the number that begins here, with its sign; `at` itself if none does. A minus behind a letter or a digit
/// is a hyphen.
std::size_t endOfNumber(const std::string& text, std::size_t at) {
    std::size_t end = at;
    if (text[at] == '-' && (at == 0 || (!isLetter(text[at - 1]) && !isDigit(text[at - 1]))))
        ++end;
    if (!isDigitAt(text, end))
        return at;
    while (isDigitAt(text, end) || (end < text.size() && text[end] == '.' && isDigitAt(text, end + 1)))
        ++end;
    return end;
}

void countIn(FailureGroup& group, const RunFigures& run, bool is_baseline) {
    ++(is_baseline ? group.of_baseline : group.of_candidate);
    const auto place = endOf(run);
    auto found = std::ranges::find(group.places, place, &FailurePlace::place);
    if (found == group.places.end())
        found = group.places.insert(group.places.end(), FailurePlace{place, 0, 0});
    ++(is_baseline ? found->of_baseline : found->of_candidate);
}

} // namespace

PlaceSquare squareOf(const QPointF& point_m) {
    return {static_cast<int>(std::floor(point_m.x() / square_m)), static_cast<int>(std::floor(point_m.y() / square_m))};
}

std::string wordsOf(const std::optional<PlaceSquare>& place) {
    const auto middle = [](int number) { return std::to_string(number * square_m + square_m / 2); };
    return place ? "around x " + middle(place->x) + " m, y " + middle(place->y) + " m" : std::string();
}

std::optional<PlaceSquare> endOf(const RunFigures& run) {
    for (const auto* points : {&run.course.collisions, &run.course.path})
        if (!points->empty())
            return squareOf(points->back());
    return std::nullopt;
}

std::string withoutNumbers(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = endOfNumber(text, at);
        const bool is_name = at > 0 && isLetter(text[at - 1]) && text.find('.', at) >= end;
        result += end == at ? text.substr(at, 1) : is_name ? text.substr(at, end - at) : "#";
        at = std::max(end, at + 1);
    }
    return result;
}

std::vector<const RunFigures*> worstRuns(const Comparison& comparison, std::size_t most) {
    std::vector<const RunFigures*> runs;
    for (const RunPair& pair : comparison.pairing.pairs)
        runs.insert(runs.end(), {pair.baseline, pair.candidate});
    return worstOf(std::move(runs), most);
}

std::vector<const RunFigures*> worstOf(std::vector<const RunFigures*> runs, std::size_t most) {
    const auto end = runs.begin() + static_cast<std::ptrdiff_t>(std::min(most, runs.size()));
    std::partial_sort(runs.begin(), end, runs.end(),
                      [](const RunFigures* a, const RunFigures* b) { return goodness(*a) < goodness(*b); });
    runs.erase(end, runs.end());
    return runs;
}

std::vector<FailureGroup> failureGroups(const Comparison& comparison, const std::vector<RunFigures>& runs) {
    return failureGroups(comparison.baseline, comparison.candidate, runs);
}

std::vector<FailureGroup> failureGroups(const std::string& baseline, const std::string& candidate,
                                        const std::vector<RunFigures>& runs) {
    std::map<std::pair<Outcome, std::string>, FailureGroup> groups;
    for (const RunFigures& run : runs) {
        const bool is_baseline = run.variant == baseline;
        if (run.outcome == Outcome::Done || (!is_baseline && run.variant != candidate))
            continue;
        const std::string reason = withoutNumbers(run.reason);
        FailureGroup& group =
            groups.try_emplace({run.outcome, reason}, FailureGroup{run.outcome, reason, 0, 0, &run}).first->second;
        countIn(group, run, is_baseline);
    }
    std::vector<FailureGroup> sorted;
    for (auto& [key, group] : groups) {
        std::ranges::stable_sort(group.places, {}, [](const FailurePlace& one) {
            return std::tuple(!one.place, -static_cast<std::ptrdiff_t>(one.size()), one.place);
        });
        sorted.push_back(group);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const FailureGroup& a, const FailureGroup& b) { return a.size() > b.size(); });
    return sorted;
}

} // namespace usar::campaign
