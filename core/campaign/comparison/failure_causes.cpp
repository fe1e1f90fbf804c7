#include "core/campaign/comparison/failure_causes.h"

#include <algorithm>
#include <map>
#include <optional>

#include <QJsonArray>

#include "core/campaign/comparison/failures.h"

namespace usar::campaign {

namespace {

/// At the last collision, or where the path ends.
std::optional<PlaceSquare> endOf(const RunResult& run) {
    const QJsonObject course = run.summary.value("course").toObject();
    for (const char* const key : {"collisions", "path"})
        if (const QJsonArray points = course.value(QLatin1String(key)).toArray(); !points.isEmpty())
            return squareOf({points.last()[0].toDouble(), points.last()[1].toDouble()});
    return std::nullopt;
}

void sortByPlace(FailureCause& cause, const std::vector<RunResult>& runs) {
    struct Ended {
        std::size_t index = 0;
        std::optional<PlaceSquare> place;
    };
    std::vector<Ended> all;
    std::map<std::optional<PlaceSquare>, std::pair<int, std::size_t>> counts; // and the first run
    for (const std::size_t index : cause.indices) {
        all.push_back({index, endOf(runs[index])});
        --counts.try_emplace(all.back().place, 0, index).first->second.first; // The most frequent is the least.
    }
    std::ranges::stable_sort(all, {}, [&](const Ended& one) { return std::pair(!one.place, counts[one.place]); });
    for (std::size_t i = 0; i < all.size(); ++i) {
        cause.indices[i] = all[i].index;
        cause.places.push_back(wordsOf(all[i].place));
    }
}

} // namespace

std::vector<FailureCause> failureCauses(const std::vector<RunResult>& runs) {
    std::vector<FailureCause> causes;
    std::map<std::pair<Outcome, std::string>, std::size_t> known;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].outcome == Outcome::Done)
            continue;
        const std::string reason = withoutNumbers(runs[i].reason);
        const auto [at, is_new] = known.try_emplace({runs[i].outcome, reason}, causes.size());
        if (is_new)
            causes.push_back({runs[i].outcome, reason, {}});
        causes[at->second].indices.push_back(i);
    }
    for (FailureCause& cause : causes)
        sortByPlace(cause, runs);
    std::ranges::stable_sort(
        causes, [](const FailureCause& a, const FailureCause& b) { return a.indices.size() > b.indices.size(); });
    return causes;
}

std::string variantCounts(const std::vector<RunResult>& runs, const std::vector<std::size_t>& indices) {
    std::map<std::string, int> counts;
    for (const std::size_t index : indices)
        ++counts[runs[index].variant];
    std::string text;
    for (const auto& [variant, count] : counts)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " \u00d7 " + variant;
    return text;
}

} // namespace usar::campaign
